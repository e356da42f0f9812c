#include "libbrdf/src/integrals/rows.h"

#include "brdf/clones.h"
#include "brdf/kernels.h"
#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/functions.h"

namespace brdf {
void quadrature::sinh_cosh(std::size_t count, const double* s, double* sinh, double* cosh) {
  const auto body = [=](std::size_t k) {
    const double x = s[k], up = kernels::exp(x), down = 1 / up;
    const double series = x * kernels::horner(x * x, integrals::kSinh);
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
    const double s = t * kernels::horner(t2, integrals::kSin), c = kernels::horner(t2, integrals::kCos);
    const double inner = 1 - 2 * s * s;
    sine[k] = 2 * s * c;
    cosine[k] = select(x < rest, inner, -inner);
  };
  repeat(body, count);
}

}  // namespace brdf
