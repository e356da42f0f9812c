// How many operations an evaluation needs: counted on the traced formula, not estimated.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::bench {

// Per pair of directions; what depends on the parameters alone is not counted, equal expressions count once.
struct Operations {
  int divides = 0, roots = 0;
  int arithmetic = 0;  // additions, subtractions, multiplications
};

// eval_cos of one channel. The kernels' polynomials are longer in double.
Operations operations(const Reflectance& form, bool double_precision);

}  // namespace brdf::bench
