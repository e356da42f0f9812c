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
};

// The one that the form's recorded formula is of; none for others.
const EnergyMethod* energy_method(int form);

}  // namespace brdf::prove
