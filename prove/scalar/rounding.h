// Rounding errors of a form's lobes, proved.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// Of one lobe without its weight; of a form that is no sum of lobes, of f (f cos_i of a listing).
struct LobeRounding {
  // What the error is relative to: the exact value; or its peak: the value with Fresnel's weight and
  // Gaussians at their largest, every other factor where it is; or nothing is proved.
  enum class Beside { value, peak, nothing } beside = Beside::nothing;
  double error = std::numeric_limits<double>::infinity();
  double underflow = 0;  // absolute, what is added where numbers become subnormal
  double peak = 0;       // the largest that the peak is on the box
};

// Shape parameters, and the weights of a form that is no sum of lobes; directions are everywhere in the
// hemisphere.
Domain rounding_domain(int form);
std::vector<LobeRounding> rounding_of(int form, Precision precision, std::span<const Bounds> box);
// The same in a box of domain_of(form), with its directions.
std::vector<LobeRounding> rounding_within(int form, Precision precision, std::span<const Bounds> box);

}  // namespace brdf::prove
