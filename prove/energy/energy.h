// Forms whose energy is bounded by an authored reason.
#pragma once

#include <array>
#include <optional>

#include "prove/scalar/enclosed.h"
#include "prove/scalar/views.h"

namespace brdf::prove {

// Of weights with kd + ks <= 1, or a diffuse weight of at most 1; exact but for the rounding of the
// constants.
struct EnergyMethod {
  std::string why;
  Domain domain;
  Bounds (*enclose)(std::span<const Bounds> box) =
      nullptr;  // of the albedo's bound; null: none over all parameters
  // The directional albedo itself, of parameters in their tables' order and these views (facets: stretched
  // ones, facet_albedo.h); exact. None where it is not known. `accuracy`: where an integral that has it in
  // fewer cells may stop.
  std::optional<AlbedoBounds> (*albedo)(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                        const Views& views, double accuracy) = nullptr;
  // What the view's two tangents are multiplied by before its turns are taken; null: 1.
  std::array<double, 2> (*stretch)(std::span<const Bounds> shape) = nullptr;
};

// 1/pi rounded, times pi: what is at most 1 of exact constants.
inline constexpr double kRoundedConstants = 1e-15;

// The one that the form's recorded formula is of; null for others and where it has no bound over all
// parameters.
const EnergyMethod* energy_method(int form);
// The same where the albedo at given parameters is known.
const EnergyMethod* albedo_method(int form);

}  // namespace brdf::prove
