// Vectorised loops over columns, which are arrays of kBlockRows values, one for each row of a block.
// Functions that loop over `rows` entries are called with padded(rows).
#pragma once

#include <cstddef>

#include "brdf/directions.h"
#include "fit/model/lobe_columns.h"

namespace brdf::fit {

inline constexpr std::size_t kLanes = 8;  // entries of the widest vector
static_assert(kBlockRows % kLanes == 0);

// Returns the number of entries that are processed for `rows` rows: whole vectors.
constexpr std::size_t padded(std::size_t rows) {
  return (rows + kLanes - 1) / kLanes * kLanes;
}

// Transforms directions to the frame of a surface with this normal (brdf/frame.h).
void tilt_batch(const Directions<double>& directions, const Vec3<double>& normal,
                DirectionArrays<double>& out);
// sum_k w[k] column[k][j]
void mix(std::size_t columns, const double* const* column, const double* w, std::size_t entries, double* out);
// out[j] += a[j]
void add(const double* a, std::size_t entries, double* out);
// out[j] = a[j] b[j]
void multiply(const double* a, const double* b, std::size_t entries, double* out);
// h[i * n + j] += a[i] . b[j]. If `symmetric`, only entries with j >= i are computed.
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
// out[j] = sum_ik c_i[j] m[i * n + k] c_k[j] for n columns c
void quadratic_forms(std::size_t n, const double* const* column, const double* m, std::size_t entries,
                     double* out);
// Divides r[j] by the root of the share of its expected square that remains after its own influence on the
// fit. If all values are equally noisy, the share is 1 less the leverage times the curvature of the loss.
// `predicted` is the variance of the fitted value that the noise of all values causes, and `noise` is the
// value's own noise. With `predicted`, the share is between the former share and its square, which applies
// if no other value is noisy. `predicted` and `noise` may be null.
void free_of_influence(const double* leverage, const double* curvature, const double* predicted,
                       const double* noise, std::size_t entries, double* r);

}  // namespace brdf::fit
