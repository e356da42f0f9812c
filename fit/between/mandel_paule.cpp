#include "fit/between/mandel_paule.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "brdf/scalar.h"
#include "fit/assess/student.h"

namespace brdf::fit {
namespace {

constexpr int kMostSteps = 200;
constexpr double kSameVariance = 1e-14;  // relative change of tau^2 that ends the search

// The weighted mean for a variance between the laboratories.
struct WeightedMean {
  double value = 0, weights = 0;
  double deviations = 0;  // the sum of w (x - m)^2
  double slope = 0;       // its derivative by the variance, without the sign: the sum of w^2 (x - m)^2
};

WeightedMean weighted_mean(std::span<const LaboratoryValue> values, double variance) {
  WeightedMean out;
  for (const LaboratoryValue& v : values) {
    const double weight = 1 / (square(v.uncertainty) + variance);
    out.weights += weight;
    out.value += weight * v.value;
  }
  out.value /= out.weights;
  for (const LaboratoryValue& v : values) {
    const double weight = 1 / (square(v.uncertainty) + variance);
    out.deviations += weight * square(v.value - out.value);
    out.slope += square(weight * (v.value - out.value));
  }
  return out;
}

// Returns tau^2. The sum of the deviations is a falling, convex function of tau^2, so that Newton's steps
// from 0 never pass the solution.
double variance_between(std::span<const LaboratoryValue> values) {
  const double wanted = double(values.size() - 1);
  double variance = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const WeightedMean mean = weighted_mean(values, variance);
    if (!(mean.deviations > wanted)) break;
    const double change = (mean.deviations - wanted) / mean.slope;
    variance += change;
    if (change <= kSameVariance * variance) break;
  }
  return variance;
}

}  // namespace

Consensus consensus_of(std::span<const LaboratoryValue> values) {
  if (values.size() < 2) throw std::logic_error("consensus_of: at least two values");
  for (const LaboratoryValue& v : values)
    if (!(v.uncertainty > 0)) throw std::logic_error("consensus_of: every uncertainty must be above 0");
  const double freedom = double(values.size() - 1), variance = variance_between(values);
  const WeightedMean mean = weighted_mean(values, variance);
  Consensus out;
  out.value = mean.value;
  out.uncertainty = 1 / std::sqrt(mean.weights);
  out.half_width = t_quantile(freedom) * out.uncertainty;
  out.between = std::sqrt(variance);
  out.chi_square = weighted_mean(values, 0).deviations;
  out.probability = quadratic_tail(out.chi_square, freedom, std::numeric_limits<double>::infinity());
  for (const LaboratoryValue& v : values)
    out.degrees.push_back(
        {v.value - out.value,
         std::sqrt(std::max(square(v.uncertainty) + variance - square(out.uncertainty), 0.0))});
  return out;
}

}  // namespace brdf::fit
