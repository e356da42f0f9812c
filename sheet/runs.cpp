// Finds values that no detector measured: a reading that does not change, and rows that software
// interpolated, ramped down or copied.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "io/files/numbers.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

// --- A reading that does not change ------------------------------------------------------------------------

struct Run {
  Row first;
  // `directions` counts the rows that no symmetry of an isotropic surface makes equal to the row before.
  std::size_t length, directions;
};

// Returns whether an isotropic surface has the same value in both rows. With the light or the viewer along
// the normal, the azimuth has no effect.
bool are_alike(const View& view, Row a, Row b) {
  const io::SampleTable& t = view.table();
  if (t.theta_i[a] != t.theta_i[b] || t.theta_o[a] != t.theta_o[b]) return false;
  return t.theta_i[a] == 0 || t.theta_o[a] == 0 ||
         std::abs(std::abs(view.turn(a)) - std::abs(view.turn(b))) < 1e-6;
}

// Returns runs of two or more rows that follow one another in the file and hold one value.
std::vector<Run> runs_of(const View& view, const std::vector<double>& values) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < values.size();) {
    std::size_t end = k + 1, directions = 1;
    for (; end < values.size() && values[end] == values[k] && view.origin(end) == view.origin(end - 1) + 1;
         ++end)
      directions += !are_alike(view, Row(end - 1), Row(end));
    if (directions > 1) runs.push_back({Row(k), end - k, directions});
    k = end;
  }
  return runs;
}

// Returns whether the run is longer than chance explains. With few digits, or on a flat curve, short runs
// are common.
bool is_beyond_chance(const Run& run, const std::vector<Run>& all, std::size_t rows) {
  constexpr std::size_t kFewest = 4;
  constexpr double kChance = 1e-3;
  if (run.directions < kFewest) return false;
  double equal = 1;
  for (const Run& other : all)
    if (2 * other.directions < run.directions || other.directions < kFewest)
      equal += double(other.directions - 1);
  const double share = equal / double(rows);
  return double(rows) * std::pow(share, double(run.directions - 1)) < kChance;
}

// Returns whether the value of the run hardly occurs elsewhere. A flat curve returns to its value.
bool is_the_only_place(const Run& run, const std::vector<double>& values) {
  const auto count = std::size_t(std::ranges::count(values, values[run.first]));
  return count <= run.length + std::max<std::size_t>(1, run.length / 10);
}

// --- Lines of rows along the viewer's angle ----------------------------------------------------------------

struct Dot {
  double theta, value;
  Row row;
};
using Curve = std::vector<Dot>;  // by theta, at least four dots

std::vector<Curve> curves_of(const View& view, const Scan& scan, const std::vector<double>& values) {
  const io::SampleTable& t = view.table();
  std::map<std::int64_t, Curve> lines;
  for (const Row k : scan.rows)
    if (t.theta_o[k] > 0) lines[std::llround(view.turn(k) * 1e4)].push_back({t.theta_o[k], values[k], k});
  std::vector<Curve> curves;
  for (auto& [azimuth, curve] : lines) {
    if (curve.size() < 4) continue;
    std::ranges::sort(curve, {}, &Dot::theta);
    curves.push_back(std::move(curve));
  }
  return curves;
}

// --- A straight ramp to 0 at 90 degrees --------------------------------------------------------------------

// Returns the relative deviation (root mean square) of the dots from c * law(theta), where c is their mean
// ratio.
template <class Law>
double deviation(std::span<const Dot> dots, Law&& law) {
  double mean = 0, square = 0;
  for (const Dot& d : dots) mean += d.value / law(d.theta) / double(dots.size());
  for (const Dot& d : dots) square += std::pow(d.value / law(d.theta) / mean - 1, 2) / double(dots.size());
  return mean > 0 ? std::sqrt(square) : HUGE_VAL;
}

// In degrees. A curve that ends before this angle gives no information on the horizon.
constexpr double kNearHorizon = 75;

// Returns the angle in degrees at which the straight end of a curve begins; std::nullopt if the curve has
// no straight end. f_r times a cosine looks straight over few degrees, so that the line must fit far
// better.
std::optional<double> ramp_from(const Curve& curve) {
  constexpr double kFewestDegrees = 5, kStraight = 0.01, kBetter = 0.4;
  constexpr std::size_t kFewestDots = 4;
  Curve end;
  for (const Dot& d : curve)
    if (d.theta < 89.9 && d.theta > 45) end.push_back(d);
  const auto line = [](double theta) { return 90 - theta; };
  const auto cosine = [](double theta) { return std::cos(degrees(theta).radians()); };
  std::optional<double> found;
  for (std::size_t n = kFewestDots; n <= end.size(); ++n) {
    const std::span<const Dot> dots(end.data() + (end.size() - n), n);
    if (!(dots.back().value > 0) || dots.back().theta < kNearHorizon) return std::nullopt;
    const double straight = deviation(dots, line);
    if (!(straight < kStraight)) break;
    if (dots.back().theta - dots.front().theta >= kFewestDegrees &&
        straight < kBetter * deviation(dots, cosine))
      found = dots.front().theta;
  }
  return found;
}

// --- Interpolated rows -------------------------------------------------------------------------------------

struct Between {
  std::size_t looked = 0;
  std::vector<Row> straight;   // on the line through both neighbours, to the last digits
  std::vector<double> others;  // distance of the other rows from the line, in units of these digits

  // If the steps are so fine that every curve is straight between them, straightness is no evidence.
  bool are_apart() const {
    constexpr double kApart = 30;
    return !others.empty() && io::median(others) > kApart;
  }
};

void look_between(const Curve& curve, double resolution, Between& b) {
  for (std::size_t k = 1; k + 1 < curve.size(); ++k) {
    const Dot &before = curve[k - 1], &at = curve[k], &after = curve[k + 1];
    const double step = after.value - before.value;
    if (!(before.value > 0 && after.value > 0) || std::abs(step) < 0.01 * at.value) continue;
    ++b.looked;
    const double x = (at.theta - before.theta) / (after.theta - before.theta);
    const double digits = std::max(1e-6 * at.value, 0.75 * resolution);
    const double apart = std::abs(before.value + x * step - at.value) / digits;
    if (apart <= 1)
      b.straight.push_back(at.row);
    else
      b.others.push_back(apart);
  }
}

// --- One curve for several lights --------------------------------------------------------------------------

struct PlaneCurve {
  std::size_t scan;
  std::vector<std::pair<double, double>> dots;  // angle, logarithm; by angle
};

std::optional<double> value_at(const std::vector<std::pair<double, double>>& dots, double angle) {
  const auto above = std::ranges::lower_bound(dots, std::pair(angle - 1e-6, -HUGE_VAL));
  if (above == dots.end()) return std::nullopt;
  if (std::abs(above->first - angle) < 1e-3) return above->second;
  return std::nullopt;
}

// Returns whether the second curve is the first one, shifted by some degrees, to the last digits.
bool is_copy(const PlaneCurve& a, const PlaneCurve& b, double shift) {
  constexpr std::size_t kFewest = 6;
  constexpr double kEqual = 1e-4, kFlat = 0.05;
  std::size_t common = 0, equal = 0;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const auto& [angle, level] : a.dots) {
    const auto other = value_at(b.dots, angle + shift);
    if (!other) continue;
    ++common;
    equal += std::abs(*other - level) < kEqual;
    low = std::min(low, level);
    high = std::max(high, level);
  }
  return common >= kFewest && high - low > kFlat && 10 * equal >= 9 * common;
}

}  // namespace

Finding stuck(const Evidence& e) {
  const View& view = e.view;
  const io::SampleTable& t = view.table();
  constexpr std::size_t kFewestRows = 20;
  if (t.rows() < kFewestRows) return not_applicable(t.source, "stuck", "too few rows");
  std::map<Row, std::size_t> found;  // first row, length
  for (const auto& values : t.values) {
    const double largest = *std::ranges::max_element(values);
    const std::vector<Run> runs = runs_of(view, values);
    for (const Run& run : runs)
      if (values[run.first] < largest && is_beyond_chance(run, runs, t.rows()) &&
          is_the_only_place(run, values))
        found[run.first] = std::max(found[run.first], run.length);
  }
  if (is_constant(t))
    return undecided(t, "stuck",
                     "all rows have the same value: a computed table, or a reading that stands still");
  Finding f = start(t, "stuck");
  std::vector<Row> rows;
  for (const auto& [first, length] : found)
    for (std::size_t k = 0; k < length; ++k) rows.push_back(Row(first + k));
  f.value = double(rows.size());
  for (const Row k : rows) f.rows.push_back(named_row(view, k));
  f.conclude(found.empty(), "no more rows in succession have the same value than chance explains",
             found.empty()
                 ? ""
                 : plural(found.begin()->second, "row") +
                       " in succession have the same value, beginning at " +
                       view.where(found.begin()->first) +
                       (found.size() > 1 ? ", and " + plural(found.size() - 1, "other run") : std::string()) +
                       ": the detector seems stuck; remove these rows");
  return f;
}

Finding invented(const Evidence& e) {
  const View& view = e.view;
  const io::SampleTable& t = view.table();
  if (view.scans().empty())
    return not_applicable(t.source, "invented",
                          "the directions are irregular: there are no curves to compare");
  std::size_t curves = 0;
  std::vector<double> ramps;
  Between between;
  std::vector<PlaneCurve> planes;
  const View& to_the_horizon = e.all;
  for (const Scan& scan : to_the_horizon.scans())
    for (const Curve& curve : curves_of(to_the_horizon, scan, to_the_horizon.table().values.front())) {
      if (curve.back().theta < kNearHorizon) continue;
      ++curves;
      if (const auto from = ramp_from(curve)) ramps.push_back(*from);
    }
  const double digits = resolution(t.values.front());
  for (std::size_t s = 0; s < view.scans().size(); ++s) {
    for (const Curve& curve : curves_of(view, view.scans()[s], t.values.front()))
      look_between(curve, digits, between);
    PlaneCurve plane{s, {}};
    for (const InPlane& p : in_plane(view, view.scans()[s]))
      if (!std::isnan(view.level(p.row))) plane.dots.emplace_back(p.angle, view.level(p.row));
    planes.push_back(std::move(plane));
  }
  if (curves == 0 && between.looked == 0)
    return not_applicable(t.source, "invented",
                          "no curve is long enough to be compared with a straight line");
  Finding f = start(t, "invented");
  constexpr std::size_t kMostLights = 60;
  // Computed values may follow a law that only shifts. Noise does not repeat.
  constexpr double kNoise = 5e-4;
  if (e.neighbours.value.value_or(0) < kNoise) planes.clear();
  for (std::size_t a = 0; a < std::min(planes.size(), kMostLights); ++a)
    for (std::size_t b = a + 1; b < std::min(planes.size(), kMostLights); ++b) {
      const Scan &first = view.scans()[planes[a].scan], &second = view.scans()[planes[b].scan];
      const double shift = second.theta_i - first.theta_i;
      if (std::abs(shift) < 1e-6) continue;
      const bool is_shifted = is_copy(planes[a], planes[b], shift);
      if (!is_shifted && !is_copy(planes[a], planes[b], 0)) continue;
      f.outcome = Outcome::fail;
      f.value = 1;
      f.statement = "the curves at incidences " + io::short_number(first.theta_i, 4) + " and " +
                    io::short_number(second.theta_i, 4) + " degrees are identical" +
                    (is_shifted ? ", shifted by " + io::short_number(shift, 4) + " degrees" : std::string()) +
                    ": one of the two curves was not measured; remove this curve";
      return f;
    }
  constexpr double kMostCurves = 0.5, kManyRows = 0.2;
  constexpr std::size_t kFewestRamps = 2, kFewestRows = 12;
  f.value = curves > 0 ? double(ramps.size()) / double(curves) : 0;
  f.bound = kMostCurves;
  if (ramps.size() >= kFewestRamps && f.value > kMostCurves) {
    f.outcome = Outcome::fail;
    const double from = io::median(ramps);
    f.statement = "from theta_o = " + io::short_number(from, 3) +
                  " values fall in a straight line to 0 at 90 degrees in " + std::to_string(ramps.size()) +
                  " of " + plural(curves, "curve") +
                  ", which no measurement does; exclude these rows with --max-theta " +
                  io::short_number(from, 3);
  } else if (between.straight.size() >= kFewestRows &&
             double(between.straight.size()) > kManyRows * double(between.looked) && between.are_apart()) {
    f.outcome = Outcome::fail;
    f.value = double(between.straight.size()) / double(between.looked);
    f.bound = kManyRows;
    f.statement = plural(between.straight.size(), "row") + " of " + std::to_string(between.looked) +
                  " are on the straight line between their neighbours to the last digit, so they were "
                  "interpolated, not measured; first " +
                  view.where(between.straight.front());
  } else {
    f.statement = "no linear decrease to 0 at the horizon, no interpolated rows, no copied curves";
  }
  return f;
}

}  // namespace brdf::sheet
