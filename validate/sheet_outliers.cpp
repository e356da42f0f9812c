// A value is an outlier where it departs from what its neighbours say: by more than a factor two, and by much
// more than they differ among themselves. Two kinds of neighbours are asked. Those of the viewer under the
// same light know nothing of a highlight narrower than the detector's steps; those of the half vector, under
// any light, know it from other angles of the light, from the mirrored direction and from the reciprocal one.
// A value that either kind explains is no outlier.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "io/numbers.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

constexpr std::size_t kMostRows = 60000;
constexpr std::size_t kNeighbours = 8;
// Rows near a row, none where it has too few.
using Near = std::vector<std::size_t>;

std::vector<Near> near_viewer(const io::SampleTable& t) {
  std::vector<Near> near(t.rows());
  for (const auto& [light, rows] : by_light(t)) {
    if (rows.size() < 12 || rows.size() > 4000) continue;
    std::vector<Vec3<double>> d;
    for (const std::size_t k : rows) d.push_back(direction(degrees(t.theta_o[k]), degrees(t.phi_o[k])));
    std::vector<std::pair<double, std::size_t>> by_distance(rows.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      for (std::size_t n = 0; n < rows.size(); ++n) by_distance[n] = {n == j ? 2 : -dot(d[j], d[n]), rows[n]};
      std::nth_element(by_distance.begin(), by_distance.begin() + kNeighbours, by_distance.end());
      for (std::size_t n = 0; n < kNeighbours; ++n) near[rows[j]].push_back(by_distance[n].second);
    }
  }
  return near;
}

// Slopes of a lobe count in the half vector's angle, in degrees; along the difference angle a lobe is broad.
struct HalfVector {
  double theta, x, y, difference;
};

HalfVector half_vector(const io::SampleTable& t, std::size_t k, bool turned) {
  const Vec3<double> h = direction(degrees(t.theta_i[k]), degrees(t.phi_i[k])) +
                         direction(degrees(t.theta_o[k]), degrees(t.phi_o[k]));
  const double across = std::hypot(h.x, h.y), theta = radians(std::atan2(across, h.z)).degrees();
  const double length = std::sqrt(dot(h, h)) / 2;
  const double difference = radians(std::acos(std::min(length, 1.0))).degrees();
  // Of a sample that was not turned only the angle is known to matter.
  if (!turned || across == 0) return {theta, theta, 0, difference};
  return {theta, theta * h.x / across, theta * h.y / across, difference};
}

// A half turn of the sample changes no form: h and -h are alike.
double apart(const HalfVector& a, const HalfVector& b) {
  return std::min(std::hypot(a.x - b.x, a.y - b.y), std::hypot(a.x + b.x, a.y + b.y));
}

// The rows nearest to each, and those of (nearly) the same half vector that are nearest in the difference
// angle: a peak narrower than the steps has no others of its height.
struct HalfNeighbours {
  std::vector<Near> near, same;
};

HalfNeighbours near_half_vector(const io::SampleTable& t) {
  constexpr double kSlow = 0.25, kSame = 0.3;  // degrees
  constexpr std::size_t kMostSame = 3;
  const bool turned = std::set<double>(t.phi_i.begin(), t.phi_i.end()).size() > 1;
  std::vector<HalfVector> h;
  for (std::size_t k = 0; k < t.rows(); ++k) h.push_back(half_vector(t, k, turned));
  std::vector<std::size_t> order(h.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return h[a].theta < h[b].theta; });
  HalfNeighbours found{std::vector<Near>(h.size()), std::vector<Near>(h.size())};
  using Candidate = std::pair<double, std::size_t>;
  const auto put = [](auto& best, const Candidate& candidate) {
    if (candidate.first >= best.back().first) return;
    best.back() = candidate;
    std::sort(best.begin(), best.end());
  };
  for (std::size_t place = 0; place < order.size(); ++place) {
    const HalfVector& here = h[order[place]];
    std::array<Candidate, kNeighbours> best;
    std::array<Candidate, kMostSame> same;
    best.fill({HUGE_VAL, 0});
    same.fill({HUGE_VAL, 0});
    // Outwards in theta, which is never more than the distance; false where nothing nearer can follow.
    const auto visit = [&](std::size_t k) {
      const double theta = std::abs(h[k].theta - here.theta);
      if (theta >= best.back().first && theta >= kSame) return false;
      const double half = apart(here, h[k]), difference = std::abs(here.difference - h[k].difference);
      put(best, {std::hypot(half, kSlow * difference), k});
      if (half < kSame) put(same, {difference, k});
      return true;
    };
    for (std::size_t p = place; p-- > 0;)
      if (!visit(order[p])) break;
    for (std::size_t p = place + 1; p < order.size(); ++p)
      if (!visit(order[p])) break;
    for (const auto& [distance, k] : best)
      if (std::isfinite(distance)) found.near[order[place]].push_back(k);
    for (const auto& [difference, k] : same)
      if (std::isfinite(difference)) found.same[order[place]].push_back(k);
  }
  return found;
}

// What neighbours say of the logarithm of a value.
struct Say {
  double median = 0, spread = HUGE_VAL;
  bool known = false;
  bool contradicts(double x) const { return known && std::abs(x - median) > std::log(2.0) + 3 * spread; }
  bool explains(double x) const { return known && std::abs(x - median) < std::log(2.0); }
};

Say say(const std::vector<double>& values, const Near& near, std::size_t least) {
  std::vector<double> around;
  for (const std::size_t k : near)
    if (values[k] > 0) around.push_back(std::log(values[k]));
  if (around.size() < least) return {};
  std::sort(around.begin(), around.end());
  const double middle = io::median(around);  // the spread without the two extremes
  return {middle, around.size() < 4 ? HUGE_VAL : around[around.size() - 2] - around[1], true};
}

// How far a value of a channel may lie from its neighbours because the dark level is no better known: twice what all
// but a twentieth depart by, of the tenth of the rows whose neighbours are darkest. A factor of two is nothing where
// there is no light.
double dark_floor(const std::vector<double>& values, const std::vector<Near>& near) {
  constexpr double kDarkest = 0.1, kUsual = 0.95;
  constexpr std::size_t kFewest = 40;
  std::vector<std::pair<double, double>> rows;  // neighbours' median, departure from it
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (near[k].empty()) continue;
    std::vector<double> around;
    for (const std::size_t n : near[k]) around.push_back(values[n]);
    const double middle = io::median(std::move(around));
    rows.emplace_back(middle, std::abs(values[k] - middle));
  }
  const auto count = std::size_t(kDarkest * double(rows.size()));
  if (count < kFewest) return 0;
  std::nth_element(rows.begin(), rows.begin() + std::ptrdiff_t(count), rows.end());
  std::vector<double> departures;
  for (std::size_t k = 0; k < count; ++k) departures.push_back(rows[k].second);
  return 2 * io::quantile(std::move(departures), kUsual);
}

// One channel against both kinds of neighbours: the median that a value departs from, of values that do.
class Witnesses {
 public:
  Witnesses(const std::vector<double>& values, const std::vector<Near>& viewer, const HalfNeighbours& half)
      : values_(values), viewer_(viewer), half_(half), floor_(dark_floor(values, half.near)) {}

  std::optional<double> contradiction(std::size_t k) const {
    if (!(values_[k] > 0)) return std::nullopt;
    const double x = std::log(values_[k]);
    const Say viewer = say(values_, viewer_[k], 6), half = say(values_, half_.near[k], 6);
    if (say(values_, half_.same[k], 1).explains(x)) return std::nullopt;
    const bool by_viewer = viewer.contradicts(x) && !half.explains(x);
    if (!by_viewer && !(half.contradicts(x) && !viewer.explains(x))) return std::nullopt;
    const double expected = std::exp(by_viewer ? viewer.median : half.median);
    if (std::abs(values_[k] - expected) <= floor_) return std::nullopt;
    return expected;
  }

 private:
  const std::vector<double>& values_;
  const std::vector<Near>& viewer_;
  const HalfNeighbours& half_;
  double floor_;
};

}  // namespace

Finding outliers(const io::SampleTable& t, double max_theta) {
  if (t.rows() > kMostRows)
    return not_applicable(t.source, "outliers",
                          "not sought in tables of more than " + std::to_string(kMostRows) + " rows");
  const std::vector<Near> of_viewer = near_viewer(t);
  const HalfNeighbours of_half = near_half_vector(t);
  std::vector<NamedRow> found;
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const Witnesses witnesses(t.values[c], of_viewer, of_half);
    for (std::size_t k = 0; k < t.rows(); ++k)
      if (const auto expected = witnesses.contradiction(k)) {
        found.push_back(named_row(t, k, c));
        found.back().expected = *expected;
      }
  }
  return outliers_of(t, std::move(found), max_theta);
}

}  // namespace brdf::validate
