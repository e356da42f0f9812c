#include "sheet/isolated.h"

#include <algorithm>
#include <cmath>

#include "io/samples/degrees.h"

namespace brdf::sheet {
namespace {

constexpr std::size_t kLargestGroup = 5, kFewestAround = 4;

// Returns the larger cosine of two angles: between half vector and normal, and between light and viewer. It
// is near 1 at the mirror direction and at the direction of the light.
double peak_of(const io::SampleTable& t, Row k) {
  const Vec3<double> wi = io::unit_vector(t.theta_i[k], t.phi_i[k]),
                     wo = io::unit_vector(t.theta_o[k], t.phi_o[k]);
  const Vec3<double> sum = wi + wo;
  return std::max(sum.z / std::sqrt(std::max(dot(sum, sum), 1e-300)), dot(wi, wo));
}

class Groups {
 public:
  Groups(const View& view, const std::vector<double>& values, NearRows others, double least)
      : view_(view), values_(values), others_(others), least_(least) {}

  // Returns the group of a row; empty if the row has too many companions, or none.
  std::vector<Row> group_of(Row first) {
    std::vector<Row> group{first}, around;
    for (std::size_t k = 0; k < group.size(); ++k)
      for (const Row n : near(group[k])) {
        const bool is_member = std::ranges::find(group, n) != group.end();
        if (!is_member && agree(group[k], n)) group.push_back(n);
        if (group.size() > kLargestGroup) return {};
        if (!is_member && !agree(group[k], n)) around.push_back(n);
      }
    std::erase_if(around, [&](Row n) { return std::ranges::find(group, n) != group.end(); });
    if (group.size() < 2 || around.size() < kFewestAround || is_slope(group, around) || is_peak(group))
      return {};
    return group;
  }

 private:
  std::vector<Row> near(Row k) const {
    const auto rows = view_.near(k);
    std::vector<Row> out(rows.begin(), rows.end());
    out.insert(out.end(), others_[k].begin(), others_[k].end());
    return out;
  }

  bool agree(Row a, Row b) const {
    constexpr double kFactor = 5;
    const double low = std::min(values_[a], values_[b]), high = std::max(values_[a], values_[b]);
    return high <= kFactor * low || high - low <= least_;
  }

  // Returns whether the rows around lie on both sides of the group's values, as on the slope of a narrow
  // lobe.
  bool is_slope(const std::vector<Row>& group, const std::vector<Row>& around) const {
    const double level = values_[group.front()];
    const auto is_below = [&](Row n) { return values_[n] < level; };
    return std::ranges::any_of(around, is_below) && !std::ranges::all_of(around, is_below);
  }

  // Returns whether a row of the group is nearer to the mirror direction, or to the light, than all rows
  // around it under the same light.
  bool is_peak(const std::vector<Row>& group) const {
    const io::SampleTable& t = view_.table();
    return std::ranges::any_of(group, [&](Row k) {
      return std::ranges::none_of(view_.near(k), [&](Row n) {
        return std::ranges::find(group, n) == group.end() && peak_of(t, n) > peak_of(t, k);
      });
    });
  }

  const View& view_;
  const std::vector<double>& values_;
  const NearRows others_;
  const double least_;
};

}  // namespace

std::vector<Row> isolated_rows(const View& view, const std::vector<double>& values, NearRows others,
                               double least) {
  Groups groups(view, values, others, least);
  std::vector<Row> found;
  for (Row k = 0; k < values.size(); ++k) {
    if (!(values[k] > 0) || view.near(k).empty() || std::ranges::find(found, k) != found.end()) continue;
    const std::vector<Row> group = groups.group_of(k);
    found.insert(found.end(), group.begin(), group.end());
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace brdf::sheet
