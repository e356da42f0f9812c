#include "fit/assess/student.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace brdf::fit {

// In double on every machine: long double has another width, and is slow in software, on some of them.
using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Students = boost::math::students_t_distribution<double, InDouble>;
using ChiSquare = boost::math::chi_squared_distribution<double, InDouble>;
using Fisher = boost::math::fisher_f_distribution<double, InDouble>;

double t_quantile(double freedom) {
  if (freedom < 1) return std::numeric_limits<double>::infinity();
  return boost::math::quantile(Students(freedom), 0.975);
}

namespace {

constexpr double kManyFree = 60;  // from here on Student's t is accurate enough
constexpr double kWidest = 12.8;  // for a single value the quantile is 12.706
constexpr int kAngles = 48, kHalvings = 16;

// Returns P(z^2 > c^2 variance): the mean over an angle of the product of (1 + c^2 share/sin^2)^(-1/2).
double beyond(double c, const std::array<double, NoiseShares::kLargest>& largest,
              const NoiseShares::Others& others) {
  double mean = 0;
  for (int k = 0; k < kAngles; ++k) {
    const double sine = std::sin((k + 0.5) / kAngles * std::numbers::pi / 2), scale = c * c / (sine * sine);
    double logarithm =
        others.share > 0 ? others.freedom * std::log1p(scale * others.share / others.freedom) : 0;
    for (const double share : largest) logarithm += std::log1p(scale * share);
    mean += std::exp(-0.5 * logarithm) / kAngles;
  }
  return mean;
}

}  // namespace

double t_quantile(const NoiseShares& shares) {
  if (!shares.any()) return t_quantile(std::numeric_limits<double>::max());
  if (shares.freedom() > kManyFree) return t_quantile(shares.freedom());
  const auto largest = shares.largest();
  const NoiseShares::Others others = shares.others();
  double low = t_quantile(kManyFree) / 2, high = kWidest;
  for (int k = 0; k < kHalvings; ++k) {
    const double middle = (low + high) / 2;
    (beyond(middle, largest, others) > 0.05 ? low : high) = middle;
  }
  return high;
}

double t_tail(double freedom, double t) {
  return boost::math::cdf(boost::math::complement(Students(freedom), t));
}

double quadratic_tail(double value, double dimension, double freedom) {
  using boost::math::complement;
  if (freedom > kManyFree) return boost::math::cdf(complement(ChiSquare(dimension), value));
  if (freedom < 1) return 1;
  return boost::math::cdf(complement(Fisher(dimension, freedom), value / dimension));
}

double quadratic_quantile(double dimension, double freedom) {
  if (freedom > kManyFree) return boost::math::quantile(ChiSquare(dimension), 0.95);
  if (freedom < 1) return std::numeric_limits<double>::infinity();
  return dimension * boost::math::quantile(Fisher(dimension, freedom), 0.95);
}

double widening(double freedom) {
  // Tabulated over 1/freedom, in which the function is nearly linear.
  constexpr std::size_t kParts = 1024;
  static const std::vector<double> table = [] {
    std::vector<double> out{1};
    const double known = t_quantile(std::numeric_limits<double>::infinity());
    for (std::size_t k = 1; k <= kParts; ++k) out.push_back(t_quantile(double(kParts) / double(k)) / known);
    return out;
  }();
  if (freedom < 1) return std::numeric_limits<double>::infinity();
  const double place = double(kParts) / freedom;
  const std::size_t k = std::min(std::size_t(place), kParts - 1);
  return table[k] + (place - double(k)) * (table[k + 1] - table[k]);
}

}  // namespace brdf::fit
