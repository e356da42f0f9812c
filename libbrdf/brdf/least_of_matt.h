// The least value of a sum of the functions of a matt basis, over all pairs of directions.
#pragma once

#include <span>

#include "brdf/facts.h"
#include "brdf/vec3.h"

namespace brdf {

struct LeastOfMatt {
  double value = 0;     // the least f that was found, in 1/sr
  Vec3<double> wi, wo;  // where it was found
  double bound = 0;     // f is nowhere below this, apart from rounding
  long boxes = 0;       // examined
};

// Returns the least value of f, by branch and bound with Bernstein's coefficients. The search ends where
// the bound is `above` or more, where bound and value differ by less than a millionth of the sum of the
// weights, or after `most` boxes. `weights` are in the order of the table of the form.
// Example:
//     const brdf::Reflectance form = *brdf::find_form("matt_2");
//     const double weights[] = {0.3, -0.4};
//     const brdf::LeastOfMatt least = brdf::least_of_matt(*form.info().basis, weights, 0);
//     std::printf("f is at least %g and reaches %g\n", least.bound, least.value);
LeastOfMatt least_of_matt(const MattBasis& basis, std::span<const double> weights, double above,
                          long most = 20000);

// Returns the values of the functions of the basis at a pair of directions: f = sum of weights times values.
void matt_values(const MattBasis& basis, const Vec3<double>& wi, const Vec3<double>& wo,
                 std::span<double> out);

// Returns the directional albedos of the functions of the basis for light with this cosine.
void matt_albedos(const MattBasis& basis, double cosine, std::span<double> out);

}  // namespace brdf
