// Detects angles in a convention that differs from the table format. The format has polar angles from the
// normal, and the mirror direction at phi_o = phi_i + 180. Each check looks for behaviour that no surface
// shows in these coordinates.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "io/files/numbers.h"
#include "io/samples/degrees.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

double sum_of_channels(const io::SampleTable& t, std::size_t k) {
  double sum = 0;
  for (const auto& v : t.values) sum += v[k];
  return sum;
}

// Values in the plane of incidence under one light, summed over all channels.
struct Highlight {
  double theta_i;
  // The largest value near theta_o = theta_i on either side; -1: no row.
  double mirror = -1, back = -1;
  double exact = -1;     // value at theta_o = theta_i on the mirror side
  double shoulder = -1;  // largest value on the light's side, 20 to 30 degrees nearer to the normal
  double middle = 0;     // median of all rows
  double peak = 0, peak_theta = 0;  // on the mirror side
};

std::vector<Highlight> highlights(const View& view) {
  const io::SampleTable& t = view.table();
  constexpr double kReach = 10;  // degrees
  std::vector<Highlight> found;
  for (const Scan& scan : view.scans()) {
    if (scan.theta_i < 15 || scan.theta_i > 75 || scan.rows.size() < 5) continue;
    Highlight h{scan.theta_i};
    std::vector<double> all;
    for (const Row k : scan.rows) {
      const double value = sum_of_channels(t, k), phi = std::abs(view.turn(k));
      all.push_back(value);
      const bool forward = std::abs(phi - 180) <= kReach, backward = phi <= kReach;
      const bool near = std::abs(t.theta_o[k] - scan.theta_i) <= kReach;
      if (std::abs(phi - 180) < 0.5 && std::abs(t.theta_o[k] - scan.theta_i) < 0.5) h.exact = value;
      const double nearer = scan.theta_i - t.theta_o[k];
      if (backward && nearer >= 20 && nearer <= 30) h.shoulder = std::max(h.shoulder, value);
      if (forward && near) h.mirror = std::max(h.mirror, value);
      if (backward && near) h.back = std::max(h.back, value);
      if (forward && value > h.peak) {
        h.peak = value;
        h.peak_theta = t.theta_o[k];
      }
    }
    h.middle = io::median(std::move(all));
    if (h.middle > 0) found.push_back(h);
  }
  return found;
}

// Returns the variation of the logarithm of the values with the azimuth, on the ring of rows at a polar
// angle: the median over the lights at 25 to 65 degrees. Returns std::nullopt if no such light has azimuths
// more than 90 degrees apart on the ring. One row at a pole (where the azimuth has no meaning) is a ring
// without variation.
std::optional<double> variation(const View& view, double theta, bool pole) {
  const io::SampleTable& t = view.table();
  std::vector<double> found;
  for (const Scan& scan : view.scans()) {
    if (scan.theta_i < 25 || scan.theta_i > 65) continue;
    std::vector<double> azimuths, logs;
    for (const Row k : scan.rows)
      if (std::abs(t.theta_o[k] - theta) < 0.5 && sum_of_channels(t, k) > 0) {
        azimuths.push_back(std::abs(view.turn(k)));
        logs.push_back(std::log(sum_of_channels(t, k)));
      }
    if (logs.size() == 1 && pole) found.push_back(0);
    if (logs.size() < 2) continue;
    const auto [low, high] = std::minmax_element(azimuths.begin(), azimuths.end());
    if (*high - *low <= 90) continue;
    std::ranges::sort(logs);
    const std::size_t apart = logs.size() < 6 ? 0 : 1;  // one row may be an outlier
    found.push_back(logs[logs.size() - 1 - apart] - logs[apart]);
  }
  if (found.empty()) return std::nullopt;
  return io::quantile(std::move(found), 0.49);  // the lower of two
}

// Returns whether the peaks on the mirror side lie at 90 degrees minus the light's angle. They lie there if
// one of the two angles is an elevation and the other is not. Returns true if this explains the peaks of
// several lights and the mirror direction does not.
bool peaks_at_the_complement(const std::vector<Highlight>& lights) {
  std::vector<double> mirror, complement;
  std::set<double> angles;
  for (const Highlight& h : lights) {
    if (h.peak < 3 * h.middle) continue;
    mirror.push_back(std::abs(h.peak_theta - h.theta_i));
    complement.push_back(std::abs(h.peak_theta - (90 - h.theta_i)));
    angles.insert(h.theta_i);
  }
  return angles.size() >= 3 && io::median(mirror) > 12 && io::median(complement) < 6;
}

// The change of a quantity with the stated angle of the light.
enum class Change { falls, rises };

// Returns whether the contrast of the highlight changes steadily, by a factor of two or more in total,
// from the smallest stated angle of the light to the largest. The laws of Fresnel and of microfacets make
// it rise.
bool contrast_changes(const std::vector<Highlight>& lights, Change change) {
  std::map<double, std::vector<double>> contrasts;
  for (const Highlight& h : lights)
    if (h.exact > 0 && h.theta_i >= 20 && h.theta_i <= 70) contrasts[h.theta_i].push_back(h.exact / h.middle);
  std::vector<double> series;
  for (const auto& [theta, values] : contrasts) series.push_back(io::median(values));
  if (change == Change::rises) std::reverse(series.begin(), series.end());
  if (series.size() < 3 || series.front() < 2 || series.front() < 2 * series.back()) return false;
  return std::ranges::adjacent_find(series, [](double a, double b) { return b > 1.05 * a; }) == series.end();
}

// Returns the logarithm of the width of a highlight across the plane of incidence over its width in that
// plane, each between the places at which the value falls to half. Returns std::nullopt if the rows do not
// reach these places.
std::optional<double> shape_of_highlight(const View& view, const Scan& scan) {
  const io::SampleTable& t = view.table();
  constexpr double kNear = 6, kFew = 0.3, kSide = 60;  // degrees
  const Row* top = nullptr;
  for (const Row& k : scan.rows)
    if (std::abs(view.turn(k)) > 180 - kFew && std::abs(t.theta_o[k] - scan.theta_i) <= kNear &&
        !std::isnan(view.level(k)) && (!top || view.level(k) > view.level(*top)))
      top = &k;
  if (!top) return std::nullopt;
  const double half = view.level(*top) - std::log(2.0);
  std::vector<double> levels;
  for (const Row k : scan.rows)
    if (!std::isnan(view.level(k))) levels.push_back(view.level(k));
  const double floor = io::median(std::move(levels)) + std::log(1.5);
  // Returns the first place along a series of rows at which the level falls below half. From the top a
  // parabola leads to that place, unless the next row already lies beyond the highlight.
  const auto reach = [&](std::vector<std::pair<double, double>> series) {
    std::ranges::sort(series);
    double at = 0, level = view.level(*top);
    for (const auto& [distance, next] : series) {
      const double share = (level - half) / (level - next);
      if (next < half && at > 0) return at + (distance - at) * share;
      if (next < half) return next > floor ? distance * std::sqrt(share) : HUGE_VAL;
      at = distance;
      level = next;
    }
    return HUGE_VAL;
  };
  std::vector<std::pair<double, double>> across, inward, outward;
  for (const Row k : scan.rows) {
    const double aside = 180 - std::abs(view.turn(k)), along = t.theta_o[k] - t.theta_o[*top];
    if (std::isnan(view.level(k)) || k == *top) continue;
    if (std::abs(along) < kFew && aside < kSide)
      across.emplace_back(aside * io::sin_degrees(t.theta_o[k]), view.level(k));
    if (aside < kFew && along != 0)
      (along > 0 ? outward : inward).emplace_back(std::abs(along), view.level(k));
  }
  const double width = reach(across), depth = std::min(reach(std::move(inward)), reach(std::move(outward)));
  if (!std::isfinite(width) || !std::isfinite(depth)) return std::nullopt;
  return std::log(width / depth);
}

// How the logarithm of the width of the highlight across the plane, over its width in the plane, changes
// with the stated angle of the light, per degree: over all pairs of lights. A highlight that surrounds the
// mirror direction is as wide across as along. A highlight that surrounds the half vector becomes narrower
// across with steeper light (as the cosine). If elevations are read as polar angles, it grows wider
// instead, as the tangent or faster, by at least 0.035 per degree.
struct Widening {
  double median, quarter;
  static constexpr double kGrows = 0.03;

  bool is_clear() const { return median > kGrows && quarter > 0.7 * kGrows; }
  bool is_excluded() const { return median < 0.5 * kGrows; }
};

// Returns std::nullopt if fewer than two lights, 15 degrees apart, have a highlight.
std::optional<Widening> widening_of(const View& view) {
  constexpr double kApart = 15;  // degrees
  std::vector<std::pair<double, double>> shapes;
  for (const Scan& scan : view.scans())
    if (scan.theta_i >= 10 && scan.theta_i <= 80)
      if (const auto shape = shape_of_highlight(view, scan)) shapes.emplace_back(scan.theta_i, *shape);
  std::vector<double> slopes;
  for (std::size_t a = 0; a < shapes.size(); ++a)
    for (std::size_t b = a + 1; b < shapes.size(); ++b)
      if (std::abs(shapes[b].first - shapes[a].first) >= kApart)
        slopes.push_back((shapes[b].second - shapes[a].second) / (shapes[b].first - shapes[a].first));
  if (slopes.empty()) return std::nullopt;
  return Widening{io::median(slopes), io::quantile(slopes, 0.25)};
}

}  // namespace

Finding polar_angle(const Evidence& e) {
  const View& view = e.whole;  // the rows near 90 degrees matter here
  const io::SampleTable& t = view.table();
  const double low = *std::ranges::min_element(t.theta_o);
  const double high = *std::ranges::max_element(t.theta_o);
  Finding f = start(t, "polar_angle");
  const auto fail = [&](const std::string& what) {
    f.outcome = Outcome::fail;
    f.statement = what +
                  ": the polar angles look like elevations above the surface; convert them to angles from "
                  "the normal (90 - elevation)";
    return f;
  };
  const std::vector<Highlight> lights = highlights(view);
  // A cosine factor makes highlights fade too.
  const bool has_cosine = e.causes.found && e.causes.found->cause == Cause::cosine;
  if (!has_cosine && contrast_changes(lights, Change::falls))
    return fail("the highlight fades with increasing angle of incidence");
  const std::optional<Widening> widening = widening_of(view);
  if (widening && widening->is_clear())
    return fail(
        "the highlight becomes wider across the plane of incidence with increasing angle of incidence");
  if (peaks_at_the_complement(lights))
    return fail("highlights are at theta_o = 90 - theta_i, so one of the two is not a polar angle");
  if (high < 75) return not_applicable(t.source, "polar_angle", "no row is at grazing angles");
  const auto at_low = variation(view, low, low < 1), at_high = variation(view, high, high > 89);
  if (!at_low || !at_high)
    return not_applicable(t.source, "polar_angle",
                          "too few azimuths to distinguish the normal from grazing angles");
  f.value = *at_low;
  f.bound = std::max(3 * *at_high, 0.3);
  const auto factor = [](double log) { return io::short_number(std::exp(log), 3); };
  const std::string spread = "values vary with the azimuth by a factor of " + factor(*at_low) +
                             " at theta_o = " + io::short_number(low, 3) + " and by " + factor(*at_high) +
                             " at " + io::short_number(high, 3);
  if (low < 20 && f.value > f.bound) return fail(spread);
  // Elevations above the surface would have shown the opposite.
  if (*at_high > std::max(3 * *at_low, 0.3))
    f.statement = "polar angles are measured from the normal: " + spread;
  else if (contrast_changes(lights, Change::rises))
    f.statement =
        "polar angles are measured from the normal: the highlight grows with the angle of incidence";
  else if (widening && widening->is_excluded())
    f.statement =
        "polar angles are measured from the normal: the highlight does not become wider across the plane of "
        "incidence with increasing angle of incidence";
  else
    return undecided(
        t, "polar_angle",
        spread +
            ", and no highlight tells the angle of incidence from its complement: both conventions "
            "are possible");
  return f;
}

Finding azimuth(const Evidence& e) {
  const View& view = e.view;
  const io::SampleTable& t = view.table();
  constexpr double kHighlight = 3;  // relative to the median of the rows
  std::vector<double> ratios, contrasts;
  struct Back {
    double theta_i, value, ratio, contrast, shoulder;
  };
  std::vector<Back> back;
  for (const Highlight& h : highlights(view)) {
    if (h.mirror < 0 && h.back < 0) continue;
    const double mirror = h.mirror < 0 ? h.middle : std::max(h.mirror, 1e-3 * h.middle);
    const double light = h.back < 0 ? h.middle : std::max(h.back, 1e-3 * h.middle);
    ratios.push_back(light / mirror);
    contrasts.push_back(std::max(light, mirror) / h.middle);
    back.push_back({h.theta_i, light, ratios.back(), light / h.middle, h.shoulder});
  }
  if (ratios.size() < 2)
    return not_applicable(t.source, "azimuth", "too few angles of incidence with in-plane rows");
  Finding f = start(t, "azimuth");
  f.value = io::median(ratios);
  f.bound = kHighlight;
  std::ranges::sort(back, {}, &Back::theta_i);
  // A faint highlight is visible if the light is steep. There rough surfaces are bright towards the light
  // as well, but broadly: the value falls only to half within 25 degrees.
  const Back& steepest = back.back();
  const bool narrow = steepest.shoulder >= 0 && steepest.shoulder < 0.3 * steepest.value;
  if (f.value > 1.2 && narrow && steepest.ratio > kHighlight && steepest.contrast > kHighlight)
    f.value = steepest.ratio;
  if ((io::median(contrasts) < 1.5 && f.value <= f.bound) || (f.value > 1 / 1.5 && f.value <= f.bound))
    return not_applicable(t.source, "azimuth", "no distinct highlight on either side of the normal");
  if (f.value <= f.bound) {
    f.statement = "the highlight is on the mirror side, phi_o = phi_i + 180";
    return f;
  }
  const std::string where =
      "values are " + io::short_number(f.value, 3) +
      " times as large on the side of incidence (phi_o = phi_i) as on the mirror side (phi_o = phi_i + 180)";
  // The highlight of a mirror grows or stays towards grazing incidence. That of a retroreflector fades, and
  // that of a rough surface is broad.
  const bool fades = steepest.value < 0.5 * back.front().value;
  const bool stands_out = std::max(io::median(contrasts), steepest.contrast) >= kHighlight;
  f.outcome = stands_out && narrow && !fades ? Outcome::fail : Outcome::undecided;
  f.statement =
      where + (f.outcome == Outcome::fail
                   ? ": the azimuths seem to follow the other convention (add 180 degrees to phi_o)"
                   : ": the surface is retroreflective, or the azimuths follow the other convention");
  return f;
}

}  // namespace brdf::sheet
