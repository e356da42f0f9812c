// Proved rounding errors of a form's lobes.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// The error of one lobe without its weight. If a form is not a sum of lobes, the error of f (of f cos_i for
// a listing).
struct LobeRounding {
  // The reference of the relative error. value: the exact value. peak: the value with Fresnel's weight and
  // Gaussians at their largest and every other factor unchanged. nothing: no error is proved.
  enum class Beside { value, peak, nothing } beside = Beside::nothing;
  double error = std::numeric_limits<double>::infinity();
  double underflow = 0;  // absolute, added if numbers become subnormal
  double peak = 0;       // the largest value of the peak on the box
};

// Returns the domain of the errors: shape parameters, and the weights of a form that is not a sum of lobes.
// Directions are anywhere in the hemisphere.
Domain rounding_domain(int form);
// Returns the errors of the lobes on a box of rounding_domain(form).
std::vector<LobeRounding> rounding_of(int form, Precision precision, std::span<const Bounds> box);
// Returns the errors on a box of domain_of(form), with its directions.
std::vector<LobeRounding> rounding_within(int form, Precision precision, std::span<const Bounds> box);

}  // namespace brdf::prove
