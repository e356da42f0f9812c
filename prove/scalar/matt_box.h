// Encloses the polynomials of a matt basis on a box of r_i, r_o and the cosine of the azimuths' difference.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "brdf/matt_basis.h"
#include "prove/scalar/enclosed.h"
#include "prove/scalar/interval.h"

namespace brdf::prove {

template <class F>
concept MattForm = requires { F::basis; };

// Returns a bound of the error of pi f as computed in Base, for weights within these bounds. One function
// s_nml takes fewer than kSteps operations, none of which is larger than the product of the sums of the sizes
// of both radial coefficients. The stored directions may differ from unit vectors by 2 units, which the steps
// include. An error of q_i.q_o changes r_i^l r_o^l cos(l dphi) by at most l^2 times as much (Markov).
template <class Base>
double matt_rounding(const MattBasis& basis, std::span<const Interval<double>> weights) {
  constexpr double kSteps = 64;
  const auto size = [](int n, int l) {
    double sum = 0;
    for (int k = 0; k <= (n - l) / 2; ++k) sum += std::fabs(radial_coefficient(n, l, k));
    return sum;
  };
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const auto [n, m, l] = basis.indices[k];
    sum += weights[k].magnitude() * size(n, l) * size(m, l) *
           (kSteps * double(1 + l * l) + double(weights.size()));
  }
  return Interval<Base>::kUnit * sum + Interval<Base>::kTiny;
}

// Encloses f on a box of value_domain_of(form), as rounded in Base. f cos_i has the sign of f and is not
// larger, so that the bounds, with 0 above, are those of both if f is not negative.
template <MattForm F, class Base>
Bounds enclose_matt(std::span<const Bounds> box) {
  using I = Interval<double>;
  constexpr std::size_t kCount = F::basis.indices.size();
  std::array<I, kCount> weights;
  for (std::size_t k = 0; k < kCount; ++k) weights[k] = I::of(box[k].lo, box[k].hi);
  MattBox<I> at;
  for (std::size_t d = 0; d < 3; ++d) {
    const Bounds b = box[kCount + d];
    at.low[d] = I::of(b.lo, b.lo);
    at.high[d] = I::of(b.hi, b.hi);
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  matt_coefficients<I>(F::basis, weights, at, [&](const I& c, std::size_t, std::size_t, std::size_t) {
    low = std::min(low, c.lo);
    high = std::max(high, c.hi);
  });
  const double slack = matt_rounding<Base>(F::basis, weights);
  const I f = Interval<double>::widened(low - slack, std::max(high + slack, 0.0)) * I(1 / kPi);
  return {f.lo, f.hi};
}

}  // namespace brdf::prove
