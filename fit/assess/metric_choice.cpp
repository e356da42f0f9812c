#include "fit/assess/metric_choice.h"

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "io/samples/noise.h"

namespace brdf::fit {
namespace {

constexpr double kLeastNoise = 0.002;  // below this level, noise cannot be distinguished from shape
constexpr std::array kCompared{Metric::log, Metric::cosine_l2, Metric::log_relative};

// Returns the change of the residual per relative change of a value.
double gain(Metric metric, double value, double cos_i, double cos_o) {
  const double x = value * cos_i;
  if (metric == Metric::log) return x / (1 + x);
  if (metric == Metric::log_relative) return x * cos_o / (x * cos_o + kLogRelativeFloor);
  return x;
}

// The relative noise as a function of the size of a value, interpolated between the levels at which it is
// known.
class NoiseOfSize {
 public:
  explicit NoiseOfSize(const std::vector<io::NoiseAtLevel>& levels) {
    for (const io::NoiseAtLevel& x : levels) points_.emplace_back(std::log(x.level), std::log(x.relative));
  }
  double logarithm(double log_value) const {
    const auto above = std::ranges::lower_bound(points_, std::pair(log_value, -HUGE_VAL));
    if (above == points_.begin()) return above->second;
    const auto below = std::prev(above);
    if (above == points_.end()) return below->second;
    const double x = (log_value - below->first) / (above->first - below->first);
    return below->second + x * (above->second - below->second);
  }

 private:
  std::vector<std::pair<double, double>> points_;
};

double unevenness(const FitData& data, Metric metric, const NoiseOfSize& noise) {
  double sum = 0, squares = 0, count = 0;
  for (const std::vector<double>& column : data.values)
    for (std::size_t k = 0; k < data.rows(); ++k) {
      if (!(column[k] > 0)) continue;
      const double x = std::log(gain(metric, column[k], data.wi_z[k], data.wo_z[k])) +
                       noise.logarithm(std::log(column[k]));
      if (!std::isfinite(x)) continue;
      sum += x;
      squares += x * x;
      ++count;
    }
  const double mean = sum / count;
  return std::exp(std::sqrt(std::max(squares / count - mean * mean, 0.0)));
}

}  // namespace

MetricChoice choose_metric(const io::SampleTable& table, const FitData& data, std::optional<double> noise,
                           const FitOptions& options) {
  if (options.metric != Metric::automatic) return {options.metric, true, {}, {}};
  MetricChoice choice{Metric::log, false, {}, {}};
  if (!data.sigma.empty()) {
    choice.reason = "standard deviations are given, which makes the noise of every residual uniform";
    return choice;
  }
  const std::vector<io::NoiseAtLevel> levels =
      noise && *noise > kLeastNoise ? io::noise_by_level(table, data.row) : std::vector<io::NoiseAtLevel>();
  if (levels.empty()) {
    choice.reason = noise && *noise <= kLeastNoise
                        ? "the measurement noise is too small for the choice to matter"
                        : "the measurement noise is not known";
    return choice;
  }
  const NoiseOfSize of_size(levels);
  for (const Metric metric : kCompared)
    choice.unevenness.push_back({metric, unevenness(data, metric, of_size)});
  const auto best = std::ranges::min_element(
      choice.unevenness, [](const auto& a, const auto& b) { return a.factor < b.factor; });
  choice.metric = best->metric;
  choice.reason = "its noise is the most uniform on these data, varying by a factor of " +
                  io::short_number(best->factor, 3);
  std::string others;
  for (const Unevenness& u : choice.unevenness)
    if (u.metric != choice.metric)
      others +=
          (others.empty() ? "" : ", ") + std::string(name_of(u.metric)) + " " + io::short_number(u.factor, 3);
  choice.reason += "; " + others;
  return choice;
}

}  // namespace brdf::fit
