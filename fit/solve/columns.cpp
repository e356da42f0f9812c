#include "fit/solve/columns.h"

#include <cmath>

#include "brdf/clones.h"
#include "brdf/frame.h"

namespace brdf::fit {
namespace {

// Eight lanes in vectors as wide as the registers. g++ keeps wider vectors in memory and copies them word
// by word, which costs a factor of seven.
struct __attribute__((may_alias)) Quads {
  typedef double Vector __attribute__((vector_size(4 * sizeof(double)), aligned(8), may_alias));
  static constexpr std::size_t width = 4;
  Vector part[kLanes / width];
};
struct __attribute__((may_alias)) Octet {
  typedef double Vector __attribute__((vector_size(8 * sizeof(double)), aligned(8), may_alias));
  static constexpr std::size_t width = 8;
  Vector part[kLanes / width];
};
static_assert(kLanes == 8);

// Upper limit of the share of its own residual that a value explains. A value that alone determines a
// parameter counts as very uncertain, not as infinitely uncertain.
constexpr double kMostLeverage = 0.99;

inline double clamped(double x, double low, double high) {
  return x < low ? low : high < x ? high : x;
}

template <class Lanes>
double lane(const Lanes& v, std::size_t l) {
  return v.part[l / Lanes::width][l % Lanes::width];
}
template <class Lanes>
double sum(const Lanes& v) {
  return ((lane(v, 0) + lane(v, 4)) + (lane(v, 1) + lane(v, 5))) +
         ((lane(v, 2) + lane(v, 6)) + (lane(v, 3) + lane(v, 7)));
}
template <class Lanes>
const Lanes* lanes(const double* column) {
  return reinterpret_cast<const Lanes*>(column);
}
template <class Lanes>
void add_lanes(Lanes& to, const Lanes& a, const Lanes& b) {
  for (std::size_t p = 0; p < kLanes / Lanes::width; ++p) to.part[p] += a.part[p] * b.part[p];
}

template <class Lanes>
void add_gram_in(std::size_t m, const double* const* a, std::size_t n, const double* const* b, bool symmetric,
                 std::size_t entries, double* h) {
  // Processes four columns at a time: one load of the row's column serves four products.
  for (std::size_t i = 0; i < m; ++i) {
    const Lanes* x = lanes<Lanes>(a[i]);
    for (std::size_t j = symmetric ? i : 0; j < n; j += 4) {
      const std::size_t count = n - j < 4 ? n - j : 4;
      const Lanes* y[4];
      for (std::size_t k = 0; k < 4; ++k) y[k] = lanes<Lanes>(b[j + (k < count ? k : 0)]);
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

template <class Lanes>
void quadratic_forms_in(std::size_t n, const double* const* column, const double* m, std::size_t entries,
                        double* __restrict out) {
  for (std::size_t t = 0; t < entries / kLanes; ++t) {
    Lanes sum{};
    for (std::size_t i = 0; i < n; ++i) {
      const Lanes x = lanes<Lanes>(column[i])[t];
      for (std::size_t k = 0; k < n; ++k) {
        const Lanes& y = lanes<Lanes>(column[k])[t];
        for (std::size_t p = 0; p < kLanes / Lanes::width; ++p)
          sum.part[p] += x.part[p] * m[i * n + k] * y.part[p];
      }
    }
    for (std::size_t l = 0; l < kLanes; ++l) out[t * kLanes + l] = lane(sum, l);
  }
}

BRDF_CLONES void add_gram_in_quads(std::size_t m, const double* const* a, std::size_t n,
                                   const double* const* b, bool symmetric, std::size_t entries, double* h) {
  add_gram_in<Quads>(m, a, n, b, symmetric, entries, h);
}
BRDF_CLONES void quadratic_forms_in_quads(std::size_t n, const double* const* column, const double* m,
                                          std::size_t entries, double* __restrict out) {
  quadratic_forms_in<Quads>(n, column, m, entries, out);
}
#ifdef BRDF_WIDEST
BRDF_WIDEST void add_gram_in_octets(std::size_t m, const double* const* a, std::size_t n,
                                    const double* const* b, bool symmetric, std::size_t entries, double* h) {
  add_gram_in<Octet>(m, a, n, b, symmetric, entries, h);
}
BRDF_WIDEST void quadratic_forms_in_octets(std::size_t n, const double* const* column, const double* m,
                                           std::size_t entries, double* __restrict out) {
  quadratic_forms_in<Octet>(n, column, m, entries, out);
}
#endif

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

void add_gram(std::size_t m, const double* const* a, std::size_t n, const double* const* b, bool symmetric,
              std::size_t entries, double* h) {
#ifdef BRDF_WIDEST
  if (has_widest_vectors()) return add_gram_in_octets(m, a, n, b, symmetric, entries, h);
#endif
  add_gram_in_quads(m, a, n, b, symmetric, entries, h);
}

void quadratic_forms(std::size_t n, const double* const* column, const double* m, std::size_t entries,
                     double* __restrict out) {
#ifdef BRDF_WIDEST
  if (has_widest_vectors()) return quadratic_forms_in_octets(n, column, m, entries, out);
#endif
  quadratic_forms_in_quads(n, column, m, entries, out);
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
