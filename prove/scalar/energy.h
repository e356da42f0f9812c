// Forms whose energy is bounded by an authored reason.
#pragma once

#include <optional>

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// Of weights with kd + ks <= 1, or a diffuse weight of at most 1; exact but for the rounding of the constants.
struct EnergyMethod {
  std::string why;
  Domain domain;
  Bounds (*enclose)(std::span<const Bounds> box);  // of the albedo's bound
  // The directional albedo itself, of parameters in their tables' order and views of a range of turns from the normal, 0 to
  // 1 (facets: of the stretched normal, facet_albedo.h); exact. None where it is not known, of unequal widths say. `accuracy`: where an integral that has it in fewer cells may stop.
  std::optional<Bounds> (*albedo)(std::span<const Bounds> shape, std::span<const Bounds> weights, Bounds turn,
                                  double accuracy) = nullptr;
  // What the view's tangent is multiplied by before its turn is taken; null: 1.
  double (*stretch)(std::span<const Bounds> shape) = nullptr;
};

// 1/pi rounded, times pi: what is at most 1 of exact constants.
inline constexpr double kRoundedConstants = 1e-15;

// The one that the form's recorded formula is of; none for others.
const EnergyMethod* energy_method(int form);

}  // namespace brdf::prove
