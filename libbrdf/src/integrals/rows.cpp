#include "libbrdf/src/integrals/rows.h"

#include <array>

#include "brdf/clones.h"
#include "brdf/kernels.h"
#include "brdf/quadrature.h"

namespace brdf {
namespace {

// The coefficients 1/n! of Taylor's series.
constexpr std::array kSinh{1.0,          1.0 / 6,        1.0 / 120,        1.0 / 5040,
                           1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800, 1.0 / 1307674368000};
constexpr std::array kSin{1.0,          -1.0 / 6,        1.0 / 120,        -1.0 / 5040,
                          1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000};
constexpr std::array kCos{1.0,
                          -1.0 / 2,
                          1.0 / 24,
                          -1.0 / 720,
                          1.0 / 40320,
                          -1.0 / 3628800,
                          1.0 / 479001600,
                          -1.0 / 87178291200,
                          1.0 / 20922789888000};

}  // namespace

void quadrature::sinh_cosh(std::size_t count, const double* s, double* sinh, double* cosh) {
  const auto body = [=](std::size_t k) {
    const double x = s[k], up = kernels::exp(x), down = 1 / up;
    const double series = x * kernels::horner(x * x, kSinh);
    sinh[k] = select(x < 0.5, series, 0.5 * (up - down));
    cosh[k] = 0.5 * (up + down);
  };
  repeat(body, count);
}

void integrals::sin_cos(std::size_t count, const double* angle, double* sine, double* cosine) {
  // Sine and cosine of half the distance to the nearer end. 1 - 2 sin^2 is then rounded only once if it is
  // near 1.
  const auto body = [=](std::size_t k) {
    const double x = angle[k], rest = kPi - x;
    const double t = 0.5 * smaller(x, rest), t2 = t * t;
    const double s = t * kernels::horner(t2, kSin), c = kernels::horner(t2, kCos);
    const double inner = 1 - 2 * s * s;
    sine[k] = 2 * s * c;
    cosine[k] = select(x < rest, inner, -inner);
  };
  repeat(body, count);
}

}  // namespace brdf
