#include "fit/solve/columns.h"

#include <cmath>

#include "brdf/clones.h"
#include "brdf/frame.h"

namespace brdf::fit {
namespace {

// Eight lanes in two vectors of four: g++ keeps one that is wider than the machine's registers in memory, copied word by word,
// which costs a factor of eight where there is no AVX-512.
typedef double Quad __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias));
static_assert(kLanes == 8);
struct __attribute__((may_alias)) Lanes {
  Quad low, high;
};

// A value explains at most so much of its own residual: one that fixes a parameter alone counts as very uncertain, not as
// infinitely so.
constexpr double kMostLeverage = 0.99;

inline double clamped(double x, double low, double high) {
  return x < low ? low : high < x ? high : x;
}

inline double sum(const Lanes& v) {
  return ((v.low[0] + v.high[0]) + (v.low[1] + v.high[1])) +
         ((v.low[2] + v.high[2]) + (v.low[3] + v.high[3]));
}
inline const Lanes* lanes(const double* column) {
  return reinterpret_cast<const Lanes*>(column);
}
inline void add_lanes(Lanes& to, const Lanes& a, const Lanes& b) {
  to.low += a.low * b.low;
  to.high += a.high * b.high;
}

}  // namespace

void tilt_batch(const Directions<double>& directions, const Vec3<double>& normal,
                DirectionArrays<double>& out) {
  repeat(
      [to = &out, directions, normal](std::size_t j) {
        to->set(j, in_frame_of(normal, directions.wi(j)), in_frame_of(normal, directions.wo(j)));
      },
      directions.count);
}

BRDF_CLONES void mix(std::size_t columns, const double* const* column, const double* w, std::size_t entries,
                     double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] = w[0] * column[0][j];
  for (std::size_t k = 1; k < columns; ++k) {
    const double* x = column[k];
    const double s = w[k];
    for (std::size_t j = 0; j < entries; ++j) out[j] += s * x[j];
  }
}

BRDF_CLONES void add(const double* a, std::size_t entries, double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] += a[j];
}

BRDF_CLONES void multiply(const double* a, const double* b, std::size_t entries, double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] = a[j] * b[j];
}

BRDF_CLONES void scale(const double* a, std::size_t entries, double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] *= a[j];
}

BRDF_CLONES void add_scaled(double s, const double* a, std::size_t entries, double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] += s * a[j];
}

BRDF_CLONES void divide(const double* a, const double* b, std::size_t entries, double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] = a[j] / b[j];
}

BRDF_CLONES void add_product(double s, const double* a, const double* b, std::size_t entries,
                             double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] += s * a[j] * b[j];
}

BRDF_CLONES void multiply_squares(const double* a, const double* b, std::size_t entries,
                                  double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] = a[j] * a[j] * b[j] * b[j];
}

BRDF_CLONES void add_gram(std::size_t m, const double* const* a, std::size_t n, const double* const* b,
                          bool symmetric, std::size_t entries, double* h) {
  // Four columns at a time: one load of the row's column serves four products.
  for (std::size_t i = 0; i < m; ++i) {
    const Lanes* x = lanes(a[i]);
    for (std::size_t j = symmetric ? i : 0; j < n; j += 4) {
      const std::size_t count = n - j < 4 ? n - j : 4;
      const Lanes* y[4];
      for (std::size_t k = 0; k < 4; ++k) y[k] = lanes(b[j + (k < count ? k : 0)]);
      Lanes s0{}, s1{}, s2{}, s3{};
      for (std::size_t t = 0; t < entries / kLanes; ++t) {
        const Lanes v = x[t];
        add_lanes(s0, v, y[0][t]);
        add_lanes(s1, v, y[1][t]);
        add_lanes(s2, v, y[2][t]);
        add_lanes(s3, v, y[3][t]);
      }
      const double s[4] = {sum(s0), sum(s1), sum(s2), sum(s3)};
      for (std::size_t k = 0; k < count; ++k) h[i * n + j + k] += s[k];
    }
  }
}

BRDF_CLONES void quadratic_forms(std::size_t n, const double* const* column, const double* m,
                                 std::size_t entries, double* __restrict out) {
  for (std::size_t t = 0; t < entries / kLanes; ++t) {
    Lanes sum{};
    for (std::size_t i = 0; i < n; ++i) {
      const Lanes x = lanes(column[i])[t];
      for (std::size_t k = 0; k < n; ++k) {
        const Lanes& y = lanes(column[k])[t];
        sum.low += x.low * m[i * n + k] * y.low;
        sum.high += x.high * m[i * n + k] * y.high;
      }
    }
    for (std::size_t l = 0; l < kLanes; ++l) out[t * kLanes + l] = l < 4 ? sum.low[l] : sum.high[l - 4];
  }
}

BRDF_CLONES void free_of_influence(const double* leverage, const double* curvature, const double* predicted,
                                   const double* noise, std::size_t entries, double* __restrict r) {
  if (!predicted) {
    for (std::size_t j = 0; j < entries; ++j)
      r[j] /= std::sqrt(1 - clamped(leverage[j] * curvature[j], 0, kMostLeverage));
    return;
  }
  for (std::size_t j = 0; j < entries; ++j) {
    const double rest = 1 - clamped(leverage[j] * curvature[j], 0, kMostLeverage);
    const double variance = noise[j] * noise[j];
    const double share = 2 * rest - 1 + predicted[j] / variance;
    r[j] /= std::sqrt(clamped(variance > 0 ? share : rest, rest * rest, rest));
  }
}

}  // namespace brdf::fit
