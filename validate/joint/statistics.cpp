#include "validate/joint/statistics.h"

#include <algorithm>
#include <cmath>

namespace brdf::validate {
namespace {

// The regularised incomplete gamma function Q(a, x), by its series below a + 1 and by its continued fraction
// (Lentz's method) above.
double upper_gamma(double a, double x) {
  if (x <= 0) return 1;
  const double front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (int n = 1; n < 100000 && term > 1e-17 * sum; ++n) sum += term *= x / (a + n);
    return std::max(0.0, 1 - front * sum);
  }
  constexpr double kLeast = 1e-300;
  double b = x + 1 - a, c = 1 / kLeast, d = 1 / b, value = d;
  for (int n = 1; n < 100000; ++n) {
    const double an = -n * (n - a);
    b += 2;
    d = an * d + b;
    c = b + an / c;
    if (std::abs(d) < kLeast) d = kLeast;
    if (std::abs(c) < kLeast) c = kLeast;
    d = 1 / d;
    value *= d * c;
    if (std::abs(d * c - 1) < 1e-15) break;
  }
  return front * value;
}

}  // namespace

double two_sided_tail(double z) {
  return std::erfc(std::abs(z) / std::sqrt(2.0));
}

double two_sided_quantile(double probability) {
  double low = 0, high = 40;
  for (int step = 0; step < 100; ++step) {
    const double middle = (low + high) / 2;
    (two_sided_tail(middle) > probability ? low : high) = middle;
  }
  return low;
}

double chi_square_tail(double x, double degrees_of_freedom) {
  return upper_gamma(degrees_of_freedom / 2, x / 2);
}

double poisson_two_sided(double count, double mean) {
  if (mean <= 0) return count > 0 ? 0 : 1;
  // P(N >= k) is the lower incomplete gamma function P(k, mean).
  const double at_least = count <= 0 ? 1 : 1 - upper_gamma(count, mean);
  const double at_most = upper_gamma(count + 1, mean);
  return std::min(1.0, 2 * std::min(at_least, at_most));
}

double sidak(double overall, int tests) {
  return -std::expm1(std::log1p(-overall) / tests);
}

}  // namespace brdf::validate
