#include "fit/between/common_values.h"

#include <array>
#include <cmath>
#include <map>

namespace brdf::fit {
namespace {

constexpr std::size_t kFewest = 30;
constexpr double kLevel = 0.001;
constexpr double kSameAngle = 1e-6;  // degrees

using Angles = std::array<long long, 4>;  // in units of kSameAngle

Angles angles_of(const io::SampleTable& table, std::size_t row) {
  constexpr double kFullTurn = 360;
  const auto rounded = [](double angle) { return std::llround(angle / kSameAngle); };
  const auto azimuth = [&](double phi) { return rounded(phi - kFullTurn * std::floor(phi / kFullTurn)); };
  return {rounded(table.theta_i[row]), azimuth(table.phi_i[row]), rounded(table.theta_o[row]),
          azimuth(table.phi_o[row])};
}

// One value of both tables: the place of the row in each budget.
struct Pair {
  std::size_t channel, first, second;
};

}  // namespace

std::optional<CommonValues> common_values(const std::vector<FittedTable>& fits,
                                          const std::vector<TableToFit>& tables) {
  for (const FittedTable& f : fits)
    if (!f.fit.budget || !f.fit.about.least_scatter) return std::nullopt;
  const RowBudget &a = *fits[0].fit.budget, &b = *fits[1].fit.budget;
  const io::SampleTable &one = tables[0].samples.table, &other = tables[1].samples.table;
  std::map<Angles, std::size_t> places;
  for (std::size_t k = 0; k < a.row.size(); ++k) places.emplace(angles_of(one, a.row[k]), k);
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < b.row.size(); ++k)
    if (const auto at = places.find(angles_of(other, b.row[k])); at != places.end()) {
      for (std::size_t c = 0; c < a.values.size(); ++c)
        if (one.values[c][a.row[at->second]] > 0 && other.values[c][b.row[k]] > 0)
          pairs.push_back({c, at->second, k});
      places.erase(at);
    }
  if (pairs.size() < kFewest) return std::nullopt;
  CommonValues out{.count = pairs.size()};
  const double noise = std::hypot(*fits[0].fit.about.least_scatter, *fits[1].fit.about.least_scatter);
  double most = 0;
  for (const Pair& p : pairs) {
    const std::size_t row = a.row[p.first];
    const double difference = std::log(other.values[p.channel][b.row[p.second]] / one.values[p.channel][row]),
                 uncertainty =
                     std::hypot(a.combined(p.channel, p.first), b.combined(p.channel, p.second), noise),
                 size = std::abs(difference) / uncertainty;
    out.beyond += std::erfc(size / std::sqrt(2.0)) < kLevel / double(out.count);  // two sides
    if (!(size > most)) continue;
    most = size;
    out.channel = p.channel;
    out.theta_i = one.theta_i[row];
    out.phi_i = one.phi_i[row];
    out.theta_o = one.theta_o[row];
    out.phi_o = one.phi_o[row];
    out.difference = difference;
    out.uncertainty = uncertainty;
  }
  return out;
}

}  // namespace brdf::fit
