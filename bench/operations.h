// The number of operations of an evaluation, counted on the traced formula, not estimated.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::bench {

// Operations per pair of directions. Expressions of parameters alone are not counted; equal expressions
// count once.
struct Operations {
  int divides = 0, roots = 0;
  int arithmetic = 0;  // additions, subtractions, multiplications
};

// Returns the operations of eval_cos of one channel. The kernels' polynomials are longer in double.
Operations operations(const Reflectance& form, bool double_precision);

}  // namespace brdf::bench
