#include <algorithm>
#include <cmath>
#include <set>

#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

constexpr std::size_t kMostRowsForNeighbours = 60000;

}  // namespace

// A value is an outlier where it leaves its eight neighbours' median by more than a factor two and by much
// more than they differ among themselves: beside a highlight neighbours differ, and nothing is claimed.
Finding outliers(const io::SampleTable& t) {
  if (t.rows() > kMostRowsForNeighbours)
    return not_applicable(
        t, "outliers",
        "not sought in tables of more than " + std::to_string(kMostRowsForNeighbours) + " rows");
  std::set<std::size_t> found;
  for (const auto& [light, rows] : by_light(t)) {
    if (rows.size() < 12 || rows.size() > 4000) continue;
    std::vector<Direction> d;
    for (const std::size_t k : rows) d.push_back(unit(t.theta_o[k], t.phi_o[k]));
    std::vector<std::pair<double, std::size_t>> near(rows.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      for (std::size_t n = 0; n < rows.size(); ++n) near[n] = {n == j ? 2 : -cosine(d[j], d[n]), n};
      std::nth_element(near.begin(), near.begin() + 8, near.end());
      for (const auto& values : t.values) {
        const double here = values[rows[j]];
        if (!(here > 0)) continue;
        std::vector<double> around;
        for (std::size_t n = 0; n < 8; ++n)
          if (const double v = values[rows[near[n].second]]; v > 0) around.push_back(std::log(v));
        if (around.size() < 6) continue;
        std::sort(around.begin(), around.end());
        const double spread = around[around.size() - 2] - around[1];  // without the two extremes
        if (std::abs(std::log(here) - median(around)) > std::log(2.0) + 3 * spread) found.insert(rows[j]);
      }
    }
  }
  return counted(t, "outliers", {found.begin(), found.end()}, "no value stands apart from its neighbours",
                 "far from all neighbours");
}

}  // namespace brdf::validate
