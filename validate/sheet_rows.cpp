#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/numbers.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

struct Around {
  double spread;  // of the values, over the largest
  double jumps;   // mean square of the steps from azimuth to azimuth over twice the variance: 1 for noise
};

// Values along the normal by azimuth, as one table row after the other claims.
Around around_normal(std::vector<std::pair<double, double>> values) {
  std::sort(values.begin(), values.end());
  double mean = 0, variance = 0, steps = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& [phi, v] : values) {
    mean += v / double(values.size());
    low = std::min(low, v);
    high = std::max(high, v);
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    variance += (values[k].second - mean) * (values[k].second - mean) / double(values.size());
    if (k > 0)
      steps += (values[k].second - values[k - 1].second) * (values[k].second - values[k - 1].second) /
               double(values.size() - 1);
  }
  return {high > 0 ? (high - low) / high : 0, variance > 0 ? steps / (2 * variance) : 1};
}

}  // namespace

Finding negative(const io::SampleTable& t) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < t.rows(); ++k)
    for (const auto& channel : t.values)
      if (channel[k] < 0) {
        rows.push_back(k);
        break;
      }
  return counted(t, "negative", rows, "no negative value", "with a negative value");
}

Finding missing(const io::SampleTable& t) {
  Finding f = start(t, "missing");
  f.value = double(t.skipped);
  f.statement =
      t.skipped == 0 ? "every row holds a value" : plural(t.skipped, "entry") + " without a value, left out";
  return f;
}

Finding duplicates(const io::SampleTable& t) {
  std::map<std::tuple<double, double, double, double>, std::size_t> seen;
  std::vector<std::size_t> copies;
  std::size_t repeated = 0;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    const auto [first, fresh] = seen.try_emplace({t.theta_i[k], t.phi_i[k], t.theta_o[k], t.phi_o[k]}, k);
    if (fresh) continue;
    const std::size_t earlier = first->second;
    const bool same =
        std::all_of(t.values.begin(), t.values.end(), [&](const auto& v) { return v[k] == v[earlier]; });
    if (same)
      copies.push_back(k);
    else
      ++repeated;
  }
  Finding f = counted(t, "duplicates", copies, "no row occurs twice",
                      "duplicated: directions and values of an earlier row");
  if (copies.empty() && repeated > 0)
    f.statement = plural(repeated, "direction") + " measured again, with other values";
  return f;
}

Finding directions(const io::SampleTable& t) {
  std::map<std::tuple<double, double, std::size_t>, std::vector<std::pair<double, double>>> poles;
  for (std::size_t k = 0; k < t.rows(); ++k)
    if (t.theta_o[k] == 0)
      for (std::size_t c = 0; c < t.channels.size(); ++c)
        poles[{t.theta_i[k], t.phi_i[k], c}].emplace_back(t.phi_o[k], t.values[c][k]);
  if (poles.empty()) return not_applicable(t.source, "directions", "no row along the normal (theta_o = 0)");
  constexpr std::size_t kSeries = 5;  // from here on noise and a curve can be told apart
  std::vector<double> spreads, jumps;
  for (const auto& [place, values] : poles) {
    const Around around = around_normal(values);
    spreads.push_back(around.spread);
    if (values.size() >= kSeries) jumps.push_back(around.jumps);
  }
  Finding f = start(t, "directions");
  f.value = io::median(spreads);
  f.bound = 0.15;
  const bool noise = !jumps.empty() && io::median(jumps) > 0.5;
  f.conclude(!(f.value > f.bound) || noise, "along the normal the azimuth is without effect, as it must be",
             "along the normal (theta_o = 0) values change with phi_o by " + io::percent_to_tenths(f.value) +
                 ", though the direction is the same: are theta_o and phi_o exchanged?");
  return f;
}

}  // namespace brdf::validate
