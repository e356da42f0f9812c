#include "fit/solve/residual.h"

#include <cmath>

#include "brdf/clones.h"
#include "brdf/math.h"

namespace brdf::fit {
namespace {

constexpr double kE = kLogRelativeFloor;

// The slope at the measurement: c/(g c + u).
template <bool kWithCosO>
inline double slope_at_value(const ResidualInputs& b, double offset, std::size_t j) {
  const double c = kWithCosO ? b.cos_i[j] * b.cos_o[j] : b.cos_i[j];
  return c / (b.g[j] * c + offset);
}

template <bool kWithCosO>
BRDF_CLONES void slopes_at_values(const ResidualInputs& b, double offset, double* __restrict out) {
  for (std::size_t j = 0; j < b.rows; ++j) out[j] = slope_at_value<kWithCosO>(b, offset, j);
}

// Computes ln((f c + u)/(g c + u)) without cancellation. If linearised, computes its first order in f - g.
// Below f = 0, which only weights of either sign reach, the logarithm continues as its tangent.
template <bool kWithCosO, bool kLinearised, bool kKnown>
BRDF_CLONES void log_residuals(const ResidualInputs& b, double offset, double* __restrict r,
                               double* __restrict d) {
  for (std::size_t j = 0; j < b.rows; ++j) {
    const double measured = kKnown ? b.value_slope[j] : slope_at_value<kWithCosO>(b, offset, j);
    const double at = kLinearised || b.f[j] >= 0 ? b.f[j] : 0, x = (at - b.g[j]) * measured;
    d[j] = kLinearised ? measured : measured / (1 + x);
    r[j] = kLinearised ? x : math::log1p(x) + (b.f[j] - at) * d[j];
  }
}

template <bool kWithCosO>
void log_residuals(const Residual& residual, const ResidualInputs& b, double offset, double* r, double* d) {
  if (residual.linearised)
    log_residuals<kWithCosO, true, false>(b, offset, r, d);
  else if (b.value_slope)
    log_residuals<kWithCosO, false, true>(b, offset, r, d);
  else
    log_residuals<kWithCosO, false, false>(b, offset, r, d);
}

BRDF_CLONES void linear_residuals(const ResidualInputs& b, double* __restrict r, double* __restrict d) {
  for (std::size_t j = 0; j < b.rows; ++j) {
    r[j] = (b.f[j] - b.g[j]) * b.cos_i[j];
    d[j] = b.cos_i[j];
  }
}

// Divides by the standard deviation of a residual: its slope at the measurement, times sigma.
BRDF_CLONES void divide_linear_by_noise(const ResidualInputs& b, double* __restrict r, double* __restrict d) {
  for (std::size_t j = 0; j < b.rows; ++j) {
    const double w = 1 / (b.cos_i[j] * b.sigma[j]);
    r[j] *= w;
    d[j] *= w;
  }
}
template <bool kWithCosO>
BRDF_CLONES void divide_log_by_noise(const ResidualInputs& b, double offset, double* __restrict r,
                                     double* __restrict d) {
  for (std::size_t j = 0; j < b.rows; ++j) {
    const double w = 1 / (slope_at_value<kWithCosO>(b, offset, j) * b.sigma[j]);
    r[j] *= w;
    d[j] *= w;
  }
}

void divide_by_noise(const Residual& residual, const ResidualInputs& b, double* r, double* d) {
  switch (residual.metric) {
    case Metric::log:
      return divide_log_by_noise<false>(b, 1, r, d);
    case Metric::log_relative:
      return divide_log_by_noise<true>(b, kE, r, d);
    default:
      return divide_linear_by_noise(b, r, d);
  }
}

BRDF_CLONES void multiply_by_roots(const ResidualInputs& b, double* __restrict r, double* __restrict d) {
  for (std::size_t j = 0; j < b.rows; ++j) {
    const double w = std::sqrt(b.weight[j]);
    r[j] *= w;
    d[j] *= w;
  }
}

}  // namespace

void slopes_at_values(const Residual& residual, const ResidualInputs& b, double* out) {
  if (residual.metric == Metric::log)
    slopes_at_values<false>(b, 1, out);
  else
    slopes_at_values<true>(b, kE, out);
}

void residuals(const Residual& residual, const ResidualInputs& b, double* r, double* d) {
  switch (residual.metric) {
    case Metric::log:
      log_residuals<false>(residual, b, 1, r, d);
      break;
    case Metric::log_relative:
      log_residuals<true>(residual, b, kE, r, d);
      break;
    default:
      linear_residuals(b, r, d);
  }
  if (b.sigma) divide_by_noise(residual, b, r, d);
  if (b.weight) multiply_by_roots(b, r, d);
}

void apply_loss(const LossFunction& loss, std::size_t rows, const double* r, double* rho, double* root_slope,
                double* curvature) {
  if (loss.kind == LossFunction::Kind::none) {
    for (std::size_t j = 0; j < rows; ++j) {
      rho[j] = r[j] * r[j];
      root_slope[j] = curvature[j] = 1;
    }
    return;
  }
  const double k = loss.scale, k2 = k * k;
  for (std::size_t j = 0; j < rows; ++j) {
    const double s = r[j] * r[j];
    switch (loss.kind) {
      case LossFunction::Kind::none:
        break;
      case LossFunction::Kind::huber: {
        const double a = std::abs(r[j]);
        const bool inside = a <= k;
        rho[j] = inside ? s : 2 * k * a - k2;
        root_slope[j] = inside ? 1 : std::sqrt(k / a);
        curvature[j] = inside ? 1 : 0;
        break;
      }
      case LossFunction::Kind::cauchy: {
        const double x = 1 + s / k2;
        rho[j] = k2 * math::log(x);
        root_slope[j] = 1 / std::sqrt(x);
        curvature[j] = (1 - s / k2) / (x * x);
        break;
      }
      case LossFunction::Kind::cube_root: {
        // (s + k^2)^(1/3), scaled to slope 1 at 0: 3 k^2 ((1 + s/k^2)^(1/3) - 1).
        const double x = 1 + s / k2, c = std::cbrt(x);
        rho[j] = 3 * k2 * (c - 1);
        root_slope[j] = 1 / c;  // sqrt(x^(-2/3))
        curvature[j] = (1 - s / (3 * k2)) / (x * c * c);
        break;
      }
    }
  }
}

}  // namespace brdf::fit
