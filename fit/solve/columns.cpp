#include "fit/solve/columns.h"

#include "brdf/clones.h"

namespace brdf::fit {
namespace {

typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double)), aligned(8), may_alias));

inline double sum(const Lanes& v) {
  return ((v[0] + v[4]) + (v[1] + v[5])) + ((v[2] + v[6]) + (v[3] + v[7]));
}
inline const Lanes* lanes(const double* column) {
  return reinterpret_cast<const Lanes*>(column);
}

}  // namespace

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
        s0 += v * y[0][t];
        s1 += v * y[1][t];
        s2 += v * y[2][t];
        s3 += v * y[3][t];
      }
      const double s[4] = {sum(s0), sum(s1), sum(s2), sum(s3)};
      for (std::size_t k = 0; k < count; ++k) h[i * n + j + k] += s[k];
    }
  }
}

BRDF_CLONES void quadratic_forms(std::size_t n, const double* const* column, const double* m,
                                 std::size_t entries, double* __restrict out) {
  for (std::size_t j = 0; j < entries; ++j) out[j] = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const double *x = column[i], *y = column[k];
      const double s = m[i * n + k];
      for (std::size_t j = 0; j < entries; ++j) out[j] += x[j] * s * y[j];
    }
}

}  // namespace brdf::fit
