// Vectorised loops over columns: arrays of kBlockRows values, one for each row of a block. Those over `rows` entries take
// padded(rows).
#pragma once

#include <cstddef>

#include "fit/model/lobe_columns.h"

namespace brdf::fit {

inline constexpr std::size_t kLanes = 8;  // numbers of the widest vector
static_assert(kBlockRows % kLanes == 0);

// The entries that are touched where the first `rows` count: whole vectors.
constexpr std::size_t padded(std::size_t rows) {
  return (rows + kLanes - 1) / kLanes * kLanes;
}

// sum_k w[k] column[k][j]
void mix(std::size_t columns, const double* const* column, const double* w, std::size_t entries, double* out);
// out[j] += a[j]
void add(const double* a, std::size_t entries, double* out);
// out[j] = a[j] b[j]
void multiply(const double* a, const double* b, std::size_t entries, double* out);
// h[i * n + j] += a[i] . b[j]. Symmetric: only j >= i, for a and b of m = n.
void add_gram(std::size_t m, const double* const* a, std::size_t n, const double* const* b, bool symmetric,
              std::size_t entries, double* h);
// out[j] = sum_ik c_i[j] m[i * n + k] c_k[j] of n columns c
void quadratic_forms(std::size_t n, const double* const* column, const double* m, std::size_t entries,
                     double* out);

}  // namespace brdf::fit
