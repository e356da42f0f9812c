// Vectorised loops over columns: arrays of kBlockRows values, one for each row of a block.
#pragma once

#include <cstddef>

#include "fit/model/lobe_columns.h"

namespace brdf::fit {

// sum_k w[k] column[k][j]
void mix(std::size_t columns, const double* const* column, const double* w, double* out);
// out[j] += a[j]
void add(const double* a, double* out);
// out[j] = a[j] b[j]
void multiply(const double* a, const double* b, double* out);
// h[i * n + j] += a[i] . b[j], columns of kBlockRows entries. Symmetric: only j >= i, for a and b of m = n.
void add_gram(std::size_t m, const double* const* a, std::size_t n, const double* const* b, bool symmetric,
              double* h);

}  // namespace brdf::fit
