// Finds outliers. A value is an outlier if it differs from the value that its neighbours predict by more
// than a factor of two, and by much more than the neighbours differ from each other.
//
// Two kinds of neighbours are used. Rows with nearby viewing directions under the same light do not show a
// highlight that is narrower than the detector's steps. Rows with nearby half vectors, under any light,
// show such a highlight from other angles of the light, from the mirrored direction and from the reciprocal
// direction. A value that either kind of neighbours explains is not an outlier.
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "io/files/numbers.h"
#include "sheet/checks.h"
#include "sheet/isolated.h"

namespace brdf::sheet {
namespace {

constexpr std::size_t kMostRows = 60000;
constexpr std::size_t kNeighbours = 8;
// Rows near a row; empty if the row has too few.
using Near = std::vector<Row>;

// A lobe is steep in the angle of the half vector and broad in the difference angle. All members are in
// degrees.
struct HalfVector {
  double theta, x, y, difference;
};

HalfVector half_vector(const io::SampleTable& t, std::size_t k, bool turned) {
  const Vec3<double> h = direction(degrees(t.theta_i[k]), degrees(t.phi_i[k])) +
                         direction(degrees(t.theta_o[k]), degrees(t.phi_o[k]));
  const double across = std::hypot(h.x, h.y), theta = radians(std::atan2(across, h.z)).degrees();
  const double length = std::sqrt(dot(h, h)) / 2;
  const double difference = radians(std::acos(std::min(length, 1.0))).degrees();
  // For a sample that was not rotated, only the angle is known to matter.
  if (!turned || across == 0) return {theta, theta, 0, difference};
  return {theta, theta * h.x / across, theta * h.y / across, difference};
}

// Returns the squared distance of two half vectors. A half turn of the sample changes no form, so that h
// and -h are equivalent.
double squared_apart(const HalfVector& a, const HalfVector& b) {
  const double minus = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y),
               plus = (a.x + b.x) * (a.x + b.x) + (a.y + b.y) * (a.y + b.y);
  return std::min(minus, plus);
}

// The rows nearest to each row, and the rows of (nearly) the same half vector that are nearest in the
// difference angle. A peak that is narrower than the steps has no other rows of its height.
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
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return h[a].theta < h[b].theta; });
  HalfNeighbours found{std::vector<Near>(h.size()), std::vector<Near>(h.size())};
  using Candidate = std::pair<double, Row>;
  const auto put = [](auto& best, const Candidate& candidate) {
    if (candidate.first >= best.back().first) return;
    best.back() = candidate;
    std::ranges::sort(best);
  };
  for (std::size_t place = 0; place < order.size(); ++place) {
    const HalfVector& here = h[order[place]];
    std::array<Candidate, kNeighbours> best;
    std::array<Candidate, kMostSame> same;
    best.fill({HUGE_VAL, 0});
    same.fill({HUGE_VAL, 0});
    // Visits rows outwards in theta, which is never more than the distance. Returns false if no nearer row
    // can follow.
    const auto visit = [&](std::size_t k) {
      const double theta = std::abs(h[k].theta - here.theta);
      if (theta * theta >= best.back().first && theta >= kSame) return false;
      const double half = squared_apart(here, h[k]), difference = std::abs(here.difference - h[k].difference);
      put(best, {half + kSlow * kSlow * difference * difference, Row(k)});
      if (half < kSame * kSame) put(same, {difference, Row(k)});
      return true;
    };
    for (std::size_t p = place; p-- > 0;)
      if (!visit(order[p])) break;
    for (std::size_t p = place + 1; p < order.size(); ++p)
      if (!visit(order[p])) break;
    for (const auto& [distance, k] : best)
      if (std::isfinite(distance)) found.near[order[place]].push_back(Row(k));
    for (const auto& [difference, k] : same)
      if (std::isfinite(difference)) found.same[order[place]].push_back(Row(k));
  }
  return found;
}

// The prediction that neighbours give for the logarithm of a value.
struct Say {
  double median = 0, spread = HUGE_VAL;
  bool known = false;
  bool contradicts(double x) const { return known && std::abs(x - median) > std::log(2.0) + 3 * spread; }
  bool explains(double x) const { return known && std::abs(x - median) < std::log(2.0); }
};

Say say(const std::vector<double>& values, std::span<const Row> near, std::size_t least) {
  std::vector<double> around;
  for (const Row k : near)
    if (values[k] > 0) around.push_back(std::log(values[k]));
  if (around.size() < least) return {};
  std::ranges::sort(around);
  const double middle = io::median(around);  // the spread without the two extremes
  return {middle, around.size() < 4 ? HUGE_VAL : around[around.size() - 2] - around[1], true};
}

// The smooth surface through the logarithms of the rows around a row, evaluated at that row:
// a + b x + c y + d (x^2 + y^2) in the plane that touches the sphere of directions there. On the slope of a
// lobe the neighbours differ from each other, and yet predict the row well.
class Surface {
 public:
  Surface(const View& view, Row k) : near_(view.near(k)) {
    const io::SampleTable& t = view.table();
    const auto towards = [&](Row n) { return direction(degrees(t.theta_o[n]), degrees(t.phi_o[n])); };
    const Vec3<double> d = towards(k),
                       x = std::abs(d.z) > 0.5 ? Vec3<double>{d.z, 0, -d.x} : Vec3<double>{-d.y, d.x, 0};
    const Vec3<double> y{d.y * x.z - d.z * x.y, d.z * x.x - d.x * x.z, d.x * x.y - d.y * x.x};
    for (std::size_t n = 0; n < near_.size(); ++n) {
      const Vec3<double> to = towards(near_[n]);
      const double a = dot(to, x), b = dot(to, y);
      terms_.row(Eigen::Index(n)) << 1, a, b, a * a + b * b;
    }
    // At an edge of the table the surface would be an extrapolation.
    if (near_.size() < View::kNeighbours) return;
    const Eigen::Matrix4d normal = terms_.transpose() * terms_;
    solver_.compute(normal + 1e-9 * normal.trace() * Eigen::Matrix4d::Identity());
    is_between_ = solver_.info() == Eigen::Success && solver_.solve(Eigen::Vector4d::UnitX())[0] < 1;
  }

  Say say(const std::vector<double>& values) const {
    Eigen::Matrix<double, int(View::kNeighbours), 1> levels;
    if (!is_between_) return {};
    for (std::size_t n = 0; n < near_.size(); ++n) {
      if (!(values[near_[n]] > 0)) return {};
      levels[Eigen::Index(n)] = std::log(values[near_[n]]);
    }
    const Eigen::Vector4d p = solver_.solve(terms_.transpose() * levels);
    constexpr double kFreedom = 4, kLeast = 0.02;
    const double deviation = std::sqrt((terms_ * p - levels).squaredNorm() / kFreedom);
    // The spread of neighbours about the median corresponds to about two standard deviations.
    return {p[0], 2 * std::max(deviation, kLeast), true};
  }

 private:
  std::span<const Row> near_;
  Eigen::Matrix<double, int(View::kNeighbours), 4> terms_;
  Eigen::LDLT<Eigen::Matrix4d> solver_;
  bool is_between_ = false;
};

// Returns the distance that a value of a channel may have from its neighbours because the dark level is
// uncertain. It is twice the 95 % quantile of the departures, among the tenth of the rows with the darkest
// neighbours. A factor of two means nothing in the dark.
double dark_floor(const std::vector<double>& values, const std::vector<Near>& near) {
  constexpr double kDarkest = 0.1, kUsual = 0.95;
  constexpr std::size_t kFewest = 40;
  std::vector<std::pair<double, double>> rows;  // median of the neighbours, departure from it
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (near[k].empty()) continue;
    std::vector<double> around;
    for (const Row n : near[k]) around.push_back(values[n]);
    const double middle = io::median(std::move(around));
    rows.emplace_back(middle, std::abs(values[k] - middle));
  }
  const auto count = std::size_t(kDarkest * double(rows.size()));
  if (count < kFewest) return 0;
  std::ranges::nth_element(rows, rows.begin() + std::ptrdiff_t(count));
  std::vector<double> departures;
  for (std::size_t k = 0; k < count; ++k) departures.push_back(rows[k].second);
  return 2 * io::quantile(std::move(departures), kUsual);
}

// Compares the values of one channel with both kinds of neighbours. contradiction() returns the median from
// which a value departs, if the value is an outlier.
class Witnesses {
 public:
  Witnesses(const View& view, const std::vector<double>& values, const HalfNeighbours& half)
      : view_(view), values_(values), half_(half), floor_(dark_floor(values, half.near)) {
    // Below a tenth of the median value there is little light and much noise.
    constexpr double kDark = 0.1;
    floor_ = std::max(floor_, kDark * io::median(values));
  }

  // Returns the rows that agree with each other only.
  std::vector<Row> isolated() const { return isolated_rows(view_, values_, half_.near, floor_); }

  std::optional<double> contradiction(Row k, const Surface& around) const {
    const double v = values_[k];
    const Say half = say(values_, half_.near[k], 6);
    Say viewer = say(values_, view_.near(k), 6);
    if (const Say surface = around.say(values_); surface.known && surface.spread < viewer.spread)
      viewer = surface;
    if (!(v > 0)) return dark_hole(v, viewer, half);
    const double x = std::log(v);
    if (say(values_, half_.same[k], 1).explains(x)) return std::nullopt;
    const bool by_viewer = viewer.contradicts(x) && !half.explains(x);
    if (!by_viewer && !(half.contradicts(x) && !viewer.explains(x))) return std::nullopt;
    const double expected = std::exp(by_viewer ? viewer.median : half.median);
    if (std::abs(v - expected) <= floor_) return std::nullopt;
    if (lies_on_a_ridge(k, x)) return std::nullopt;
    if (v > expected && (is_retroreflected(k) || is_at_the_mirror(k))) return std::nullopt;
    return expected;
  }

 private:
  // A value of 0 has no logarithm; both kinds of neighbours must agree that there is light. Values below 0
  // have a check of their own.
  std::optional<double> dark_hole(double v, const Say& viewer, const Say& half) const {
    constexpr double kSure = 0.5;  // spread of the logarithms
    if (v < 0 || !viewer.known || !half.known || viewer.spread > kSure || half.spread > kSure)
      return std::nullopt;
    const double expected = std::exp(viewer.median);
    if (expected - v <= floor_) return std::nullopt;
    return expected;
  }

  // Returns whether the value agrees with the two adjacent rows on its line through the normal, or on its
  // ring. A highlight that is narrow across the line is a ridge along it.
  bool lies_on_a_ridge(Row k, double x) const {
    const io::SampleTable& t = view_.table();
    constexpr double kSame = 0.3;  // degrees
    double below[2] = {-HUGE_VAL, -HUGE_VAL}, above[2] = {HUGE_VAL, HUGE_VAL}, low[2] = {}, high[2] = {};
    for (const Row n : view_.near(k)) {
      if (!(values_[n] > 0)) continue;
      const double along = t.theta_o[n] - t.theta_o[k],
                   around = std::remainder(t.phi_o[n] - t.phi_o[k], 360.0);
      const bool on_line = std::abs(around) < kSame && along != 0,
                 on_ring = std::abs(along) < kSame && around != 0;
      if (!on_line && !on_ring) continue;
      const double distance = on_line ? along : around, level = std::log(values_[n]);
      const std::size_t which = on_line ? 0 : 1;
      if (distance < 0 && distance > below[which]) {
        below[which] = distance;
        low[which] = level;
      } else if (distance > 0 && distance < above[which]) {
        above[which] = distance;
        high[which] = level;
      }
    }
    for (const std::size_t which : {0u, 1u}) {
      const bool has_below = std::isfinite(below[which]), has_above = std::isfinite(above[which]);
      if (!has_below && !has_above) continue;
      // At the end of a line, the one adjacent row.
      const double expected = !has_above   ? low[which]
                              : !has_below ? high[which]
                                           : low[which] - below[which] / (above[which] - below[which]) *
                                                              (high[which] - low[which]);
      if (std::abs(expected - x) < std::log(2.0)) return true;
    }
    return false;
  }

  // Returns whether the row may be the peak of a retroreflector. Such a peak is narrower than the
  // detector's steps, so that only the row next to the light shows it.
  bool is_retroreflected(Row k) const {
    const io::SampleTable& t = view_.table();
    const auto towards = [&](double theta, double phi) { return direction(degrees(theta), degrees(phi)); };
    const Vec3<double> wi = towards(t.theta_i[k], t.phi_i[k]), wo = towards(t.theta_o[k], t.phi_o[k]);
    double nearest = 0;  // cosine
    for (const Row n : view_.near(k)) nearest = std::max(nearest, dot(wo, towards(t.theta_o[n], t.phi_o[n])));
    return dot(wi, wo) >= nearest;
  }

  // Returns whether the row has the half vector nearest to the normal in its neighbourhood. A narrow
  // highlight appears in only this row of its scan.
  bool is_at_the_mirror(Row k) const {
    const io::SampleTable& t = view_.table();
    const double own = half_vector(t, k, false).theta;
    return !view_.near(k).empty() &&
           std::ranges::none_of(view_.near(k), [&](Row n) { return half_vector(t, n, false).theta < own; });
  }

  const View& view_;
  const std::vector<double>& values_;
  const HalfNeighbours& half_;
  double floor_;
};

// So many outliers are a texture, or noise that is not proportional to the value; outliers are rare.
bool are_many(std::size_t outliers, std::size_t rows) {
  constexpr double kRare = 0.01;
  constexpr std::size_t kFew = 3;
  return outliers > kFew && double(outliers) > kRare * double(rows);
}

}  // namespace

Finding outliers_of(const View& view, std::vector<NamedRow> rows, double max_theta) {
  constexpr double kNearGrazing = 75;  // degrees
  const io::SampleTable& t = view.table();
  std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.row < b.row; });
  std::vector<NamedRow> inside;
  std::size_t beyond = 0, last_beyond = t.rows();
  std::map<std::string, std::size_t> of_channel;
  bool are_shaded = true;
  for (NamedRow& row : rows) {
    row.apart = t.is_beyond(row.row, max_theta);
    if (row.apart) {
      beyond += row.row != std::exchange(last_beyond, row.row);
      continue;
    }
    if (inside.empty() || inside.back().row != row.row) inside.push_back(row);
    ++of_channel[row.channel];
    are_shaded = are_shaded && std::max(row.theta_i, row.theta_o) > kNearGrazing && row.value < row.expected;
  }
  Finding f = start(t, "outliers");
  f.value = double(inside.size());
  std::string where;
  for (std::size_t k = 0; k < std::min<std::size_t>(inside.size(), 5); ++k)
    where += (k ? "; " : "") + view.file_place(inside[k].row);
  if (inside.size() > 5) where += "; ...";
  const std::string count = plural(inside.size(), "row");
  if (inside.empty()) {
    f.statement = "every value agrees with its neighbours";
  } else if (are_many(inside.size(), t.rows())) {
    f.outcome = Outcome::undecided;
    f.statement = count +
                  " differ from all neighbours by more than a factor of two: a texture of the sample, or "
                  "noise of dark measurements: " +
                  where;
  } else if (are_shaded) {
    f.outcome = Outcome::undecided;
    f.statement = count + (inside.size() == 1 ? " is" : " are") +
                  " darker than all neighbours by more than a factor of two at grazing angles, possibly "
                  "shaded by an edge of the sample or its holder: " +
                  where;
  } else {
    f.outcome = Outcome::fail;
    f.statement = count + (inside.size() == 1 ? " is" : " are") + " far from all neighbours: " + where;
  }
  f.rows = std::move(rows);
  if (t.channels.size() > 1 && !inside.empty()) {
    f.statement += " (";
    for (auto it = of_channel.begin(); it != of_channel.end(); ++it)
      f.statement += (it == of_channel.begin() ? "" : ", ") + it->first + " " + std::to_string(it->second);
    f.statement += ")";
  }
  if (beyond > 0)
    f.statement +=
        "; not counting " + plural(beyond, "row") + " beyond " + io::short_number(max_theta) + " degrees";
  return f;
}

namespace {

bool has_neighbours(const View& view) {
  for (Row k = 0; k < view.table().rows(); ++k)
    for (const Row n : view.near(k))
      if (n != k) return true;
  return false;
}

// Makes the finding undecided if some rows agree with each other only.
void doubt_isolated(const View& view, const std::vector<Witnesses>& witnesses, double max_theta, Finding& f) {
  std::vector<Row> rows;
  for (std::size_t c = 0; c < witnesses.size(); ++c)
    for (const Row k : witnesses[c].isolated()) {
      if (view.table().is_beyond(k, max_theta)) continue;
      f.rows.push_back(named_row(view, k, c));
      if (std::ranges::find(rows, k) == rows.end()) rows.push_back(k);
    }
  if (rows.empty()) return;
  f.outcome = Outcome::undecided;
  f.value = double(rows.size());
  f.statement = plural(rows.size(), "row") +
                " agree with each other only, and differ from all rows around them by more than a factor of "
                "five: a narrow feature of the sample, or a fault of the measurement: " +
                places(view, rows);
}

}  // namespace

Finding outliers(const Evidence& e) {
  const View& view = e.whole;
  const io::SampleTable& t = view.table();
  if (t.rows() > kMostRows)
    return not_applicable(t.source, "outliers",
                          "not checked in tables of more than " + std::to_string(kMostRows) + " rows");
  if (!has_light(t)) return not_applicable(t.source, "outliers", "no value is above 0");
  constexpr double kHides = 0.7;  // a factor of two, below which no value counts as an outlier
  if (const double noise = e.scatter.least().value_or(0); noise > kHides)
    return undecided(t, "outliers", "the noise of " + io::percent(noise, 2) + " hides outliers");
  if (!has_neighbours(view)) return not_applicable(t.source, "outliers", "no row has neighbours");
  const HalfNeighbours of_half = near_half_vector(t);
  std::vector<NamedRow> found;
  std::vector<Witnesses> witnesses;
  for (const auto& values : t.values) witnesses.emplace_back(view, values, of_half);
  for (Row k = 0; k < t.rows(); ++k) {
    const Surface around(view, k);
    for (std::size_t c = 0; c < t.channels.size(); ++c)
      if (const auto expected = witnesses[c].contradiction(k, around)) {
        found.push_back(named_row(view, k, c));
        found.back().expected = *expected;
      }
  }
  Finding f = outliers_of(view, std::move(found), e.max_theta);
  if (f.outcome == Outcome::pass) doubt_isolated(view, witnesses, e.max_theta, f);
  return f;
}

}  // namespace brdf::sheet
