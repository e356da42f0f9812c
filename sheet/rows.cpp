// Checks of single rows: values below 0, entries without a value, directions that are listed twice.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

struct AroundNormal {
  double spread;  // of the values, over the largest
  // The mean square of the steps from azimuth to azimuth over twice the variance: 1 for noise.
  double jumps;
};

// Compares values along the normal by the azimuth that each row states.
AroundNormal around_normal(std::vector<std::pair<double, double>> values) {
  std::ranges::sort(values);
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

// Returns the standard deviation of dark values about 0, which does not depend on their size: the distance
// of the values from their neighbours, over the tenth of the rows with the darkest neighbours. Noise that
// is proportional to the value never leads below 0.
double dark_noise(const View& view, const std::vector<double>& values) {
  constexpr double kDarkest = 0.1;
  constexpr std::size_t kFewest = 8, kAround = 4;
  std::vector<std::pair<double, double>> rows;  // median of the neighbours, distance from it
  for (Row k = 0; k < values.size(); ++k) {
    std::vector<double> around;
    for (const Row n : view.near(k)) around.push_back(values[n]);
    if (around.size() < kAround) continue;
    const double middle = io::median(std::move(around));
    rows.emplace_back(middle, std::abs(values[k] - middle));
  }
  const std::size_t count = std::max(kFewest, std::size_t(kDarkest * double(rows.size())));
  if (count > rows.size()) return 0;
  std::ranges::partial_sort(rows, rows.begin() + std::ptrdiff_t(count));
  std::vector<double> distances;
  for (std::size_t k = 0; k < count; ++k) distances.push_back(rows[k].second);
  const double deviation = 1.4826 * io::median(std::move(distances)), level = rows[count / 2].first;
  // Rows that stay above 0 by many deviations are not dark: their noise is proportional to the value.
  constexpr double kAbove0 = 5;
  return level > kAbove0 * deviation ? 0 : deviation;
}

// The direction of a row: the angles in units of 1e-4 degrees, with azimuths reduced to one turn.
using Angles = std::tuple<long, long, long, long>;
Angles angles_of(const io::SampleTable& t, std::size_t k) {
  const auto unit = [](double angle) { return std::lround(angle * 1e4); };
  const auto azimuth = [&](double phi, double theta) {
    constexpr long kTurn = 3600000;
    return theta == 0 ? 0L : (unit(std::remainder(phi, 360.0)) + kTurn) % kTurn;
  };
  return {unit(t.theta_i[k]), azimuth(t.phi_i[k], 90), unit(t.theta_o[k]), azimuth(t.phi_o[k], t.theta_o[k])};
}

std::uint64_t mixed(const Angles& angles) {
  std::uint64_t hash = 0;
  const auto mix = [&](long x) { hash = (hash ^ std::uint64_t(x)) * 0x9E3779B97F4A7C15u ^ (hash >> 29); };
  std::apply([&](auto... x) { (mix(x), ...); }, angles);
  return hash;
}

}  // namespace

Finding negative_of(const View& view) {
  constexpr double kBeyond = 6;  // standard deviations
  const io::SampleTable& t = view.table();
  std::set<Row> below, beyond;
  if (!has_light(t)) {
    Finding f = start(t, "negative");
    f.outcome = Outcome::fail;
    f.statement =
        "no value is above 0: the table holds no light; look at its dark level, its sign and its unit";
    return f;
  }
  for (const auto& values : t.values) {
    std::vector<Row> rows;
    for (Row k = 0; k < t.rows(); ++k)
      if (values[k] < 0) rows.push_back(k);
    if (rows.empty()) continue;
    below.insert(rows.begin(), rows.end());
    const double noise = dark_noise(view, values);
    std::copy_if(rows.begin(), rows.end(), std::inserter(beyond, beyond.end()),
                 [&](Row k) { return values[k] < -kBeyond * noise; });
  }
  return counted(view, "negative", {beyond.begin(), beyond.end()},
                 below.empty() ? "no negative value"
                               : plural(below.size(), "row") + (below.size() == 1 ? " has" : " have") +
                                     " a value below 0, within the noise of dark measurements",
                 "with a negative value beyond the noise of dark measurements");
}

Finding negative(const Evidence& e) {
  return negative_of(e.view);
}

Finding missing_of(const io::SampleTable& t) {
  Finding f = start(t, "missing");
  f.value = double(t.skipped);
  f.statement =
      t.skipped == 0 ? "every row holds a number" : plural(t.skipped, "entry") + " without a value left out";
  return f;
}

Finding missing(const Evidence& e) {
  return missing_of(e.read);
}

Finding duplicates(const Evidence& e) {
  const View& view = e.view;
  const io::SampleTable& t = view.table();
  std::vector<std::pair<std::uint64_t, Row>> order;
  for (Row k = 0; k < t.rows(); ++k) order.emplace_back(mixed(angles_of(t, k)), k);
  std::ranges::sort(order);
  std::vector<Row> copies;
  std::size_t repeated = 0;
  for (std::size_t j = 1, first = 0; j < order.size(); ++j) {
    const Row k = order[j].second, earlier = order[first].second;
    if (order[j].first != order[first].first || angles_of(t, k) != angles_of(t, earlier)) {
      first = j;
      continue;
    }
    const bool same = std::ranges::all_of(t.values, [&](const auto& v) { return v[k] == v[earlier]; });
    if (same)
      copies.push_back(k);
    else
      ++repeated;
  }
  std::ranges::sort(copies);
  Finding f = counted(view, "duplicates", copies, "no row occurs twice",
                      "duplicated: the same directions and values as in an earlier row");
  if (copies.empty() && repeated > 0)
    f.statement = plural(repeated, "direction") + " measured again, with different values";
  return f;
}

Finding directions(const Evidence& e) {
  constexpr std::size_t kSeries = 5;  // the fewest values that distinguish noise from a curve
  const io::SampleTable& t = e.view.table();
  std::map<std::tuple<double, double, std::size_t>, std::vector<std::pair<double, double>>> poles;
  for (std::size_t k = 0; k < t.rows(); ++k)
    if (t.theta_o[k] == 0)
      for (std::size_t c = 0; c < t.channels.size(); ++c)
        poles[{t.theta_i[k], t.phi_i[k], c}].emplace_back(t.phi_o[k], t.values[c][k]);
  if (poles.empty())
    return not_applicable(t.source, "directions",
                          "no row with the viewing direction along the normal (theta_o = 0)");
  std::vector<double> spreads, jumps;
  std::size_t longest = 0;
  for (const auto& [place, values] : poles) {
    longest = std::max(longest, values.size());
    const AroundNormal around = around_normal(values);
    spreads.push_back(around.spread);
    if (values.size() >= kSeries) jumps.push_back(around.jumps);
  }
  if (longest < 2)
    return not_applicable(t.source, "directions",
                          "only one azimuth is listed along the normal, so no comparison is possible");
  Finding f = start(t, "directions");
  f.value = io::median(spreads);
  f.bound = 0.15;
  const bool noise = !jumps.empty() && io::median(jumps) > 0.5;
  f.conclude(!(f.value > f.bound) || noise,
             "along the normal (theta_o = 0) values do not depend on phi_o, as expected",
             "along the normal (theta_o = 0) values change with phi_o by " + io::percent_to_tenths(f.value) +
                 ", although the direction is the same: theta_o and phi_o may be exchanged");
  return f;
}

}  // namespace brdf::sheet
