// Forms with a bound of their energy that rests on an authored reason.
#pragma once

#include <array>
#include <optional>

#include "prove/scalar/enclosed.h"
#include "prove/scalar/views.h"

namespace brdf::prove {

// The reason and the functions that bound the albedo for weights with kd + ks <= 1, or for a diffuse weight
// of at most 1. Exact, except for the rounding of the constants.
struct EnergyMethod {
  std::string why;
  Domain domain;
  // Bounds the albedo; null if there is no bound over all parameters.
  Bounds (*enclose)(std::span<const Bounds> box) = nullptr;
  // Encloses the directional albedo itself. The parameters are in the order of their tables, the views as
  // given (for facets: stretched views, facet_albedo.h). The bounds are exact. Returns std::nullopt if the
  // albedo is unknown. `accuracy`: an integral that reaches this accuracy with fewer cells may stop.
  std::optional<AlbedoBounds> (*albedo)(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                        const Views& views, double accuracy) = nullptr;
  // The factors of the view's two tangents, applied before the turns of the view are taken; null:
  // both are 1.
  std::array<double, 2> (*stretch)(std::span<const Bounds> shape) = nullptr;
};

// The excess over 1 of a bound that is 1 with exact constants: the rounded 1/pi is multiplied by pi.
inline constexpr double kRoundedConstants = 1e-15;

// Returns the method that belongs to the recorded formula of the form; null for other forms, and for forms
// without a bound over all parameters.
const EnergyMethod* energy_method(int form);
// Returns the method if the albedo at given parameters is known; else null.
const EnergyMethod* albedo_method(int form);

}  // namespace brdf::prove
