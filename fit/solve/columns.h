// Vectorised loops over columns: arrays of kBlockRows values, one for each row of a block. Those over `rows`
// entries take padded(rows).
#pragma once

#include <cstddef>

#include "brdf/directions.h"
#include "fit/model/lobe_columns.h"

namespace brdf::fit {

inline constexpr std::size_t kLanes = 8;  // numbers of the widest vector
static_assert(kBlockRows % kLanes == 0);

// The entries that are touched where the first `rows` count: whole vectors.
constexpr std::size_t padded(std::size_t rows) {
  return (rows + kLanes - 1) / kLanes * kLanes;
}

// Directions as a surface of this normal sees them (brdf/frame.h).
void tilt_batch(const Directions<double>& directions, const Vec3<double>& normal,
                DirectionArrays<double>& out);
// sum_k w[k] column[k][j]
void mix(std::size_t columns, const double* const* column, const double* w, std::size_t entries, double* out);
// out[j] += a[j]
void add(const double* a, std::size_t entries, double* out);
// out[j] = a[j] b[j]
void multiply(const double* a, const double* b, std::size_t entries, double* out);
// h[i * n + j] += a[i] . b[j]. Symmetric: only j >= i, for a and b of m = n.
void add_gram(std::size_t m, const double* const* a, std::size_t n, const double* const* b, bool symmetric,
              std::size_t entries, double* h);
// out[j] *= a[j]
void scale(const double* a, std::size_t entries, double* out);
// out[j] += s a[j]
void add_scaled(double s, const double* a, std::size_t entries, double* out);
// out[j] = a[j] / b[j]
void divide(const double* a, const double* b, std::size_t entries, double* out);
// out[j] += s a[j] b[j]
void add_product(double s, const double* a, const double* b, std::size_t entries, double* out);
// out[j] = a[j]^2 b[j]^2
void multiply_squares(const double* a, const double* b, std::size_t entries, double* out);
// out[j] = sum_ik c_i[j] m[i * n + k] c_k[j] of n columns c
void quadratic_forms(std::size_t n, const double* const* column, const double* m, std::size_t entries,
                     double* out);
// r[j] over the root of what its own influence leaves of its expected square. Of a value's variance that is 1
// less its leverage times the loss's curvature, where all values are as noisy; with `predicted`, the variance
// that all values' noise gives the fit there, and the value's own noise, a share between that and its square,
// which is where no other value is noisy. `predicted` and `noise` may be null.
void free_of_influence(const double* leverage, const double* curvature, const double* predicted,
                       const double* noise, std::size_t entries, double* r);

}  // namespace brdf::fit
