// Angles in another unit or convention than the table format's: degrees, polar angles from the normal, the mirror
// direction at phi_o = phi_i + 180. Each is told by what no surface does in these coordinates.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "io/numbers.h"
#include "io/text.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

bool round_to(double x, double step, double tolerance) {
  return std::abs(x - step * std::round(x / step)) <= tolerance;
}

// Azimuth of the viewer from the light's, 0 to 180 degrees.
double between(const io::SampleTable& t, std::size_t k) {
  return std::abs(std::remainder(t.phi_o[k] - t.phi_i[k], 360.0));
}

double sum_of_channels(const io::SampleTable& t, std::size_t k) {
  double sum = 0;
  for (const auto& v : t.values) sum += v[k];
  return sum;
}

// What the light from one angle shows in the plane of incidence, all channels together.
struct Highlight {
  double theta_i;
  double mirror = -1,
         back = -1;      // largest value within reach of theta_o = theta_i on either side; -1: no row
  double exact = -1;     // value at theta_o = theta_i on the mirror side
  double shoulder = -1;  // the same towards the light, 20 to 30 degrees nearer the normal
  double middle = 0;     // median of all rows
  double peak = 0, peak_theta = 0;  // on the mirror side
};

std::vector<Highlight> highlights(const io::SampleTable& t) {
  constexpr double kReach = 10;  // degrees
  std::vector<Highlight> found;
  for (const auto& [light, rows] : by_light(t)) {
    if (light.first < 15 || light.first > 75 || rows.size() < 5) continue;
    Highlight h{light.first};
    std::vector<double> all;
    for (const std::size_t k : rows) {
      const double value = sum_of_channels(t, k), phi = between(t, k);
      all.push_back(value);
      const bool forward = std::abs(phi - 180) <= kReach, backward = phi <= kReach;
      const bool near = std::abs(t.theta_o[k] - light.first) <= kReach;
      if (std::abs(phi - 180) < 0.5 && std::abs(t.theta_o[k] - light.first) < 0.5) h.exact = value;
      const double nearer = light.first - t.theta_o[k];
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

// How much the logarithm of the values varies with the azimuth on the ring of rows at a polar angle, median over the
// lights of middling angles; none where no such light has two azimuths a right angle apart on it. One row at a pole
// (where the azimuth means nothing) is a ring without variation.
std::optional<double> variation(const io::SampleTable& t, double theta, bool pole) {
  std::vector<double> found;
  for (const auto& [light, rows] : by_light(t)) {
    if (light.first < 25 || light.first > 65) continue;
    std::vector<double> azimuths, logs;
    for (const std::size_t k : rows)
      if (std::abs(t.theta_o[k] - theta) < 0.5 && sum_of_channels(t, k) > 0) {
        azimuths.push_back(between(t, k));
        logs.push_back(std::log(sum_of_channels(t, k)));
      }
    if (logs.size() == 1 && pole) found.push_back(0);
    if (logs.size() < 2) continue;
    const auto [low, high] = std::minmax_element(azimuths.begin(), azimuths.end());
    if (*high - *low <= 90) continue;
    std::sort(logs.begin(), logs.end());
    const std::size_t apart = logs.size() < 6 ? 0 : 1;  // one row may be an outlier
    found.push_back(logs[logs.size() - 1 - apart] - logs[apart]);
  }
  if (found.empty()) return std::nullopt;
  return io::quantile(std::move(found), 0.49);  // the lower of two
}

// Where the peak on the mirror side lies, if a light's angle is an elevation and the viewer's is not, or the reverse:
// at 90 degrees less the light's. True where that explains the peaks of several lights and the mirror does not.
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

// A highlight that stands out less and less as the light goes from the smallest stated angle to the largest, by half at
// least: Fresnel's and the facets' laws make it grow.
bool fades_with_theta(const std::vector<Highlight>& lights) {
  std::map<double, std::vector<double>> contrasts;
  for (const Highlight& h : lights)
    if (h.exact > 0 && h.theta_i >= 20 && h.theta_i <= 70) contrasts[h.theta_i].push_back(h.exact / h.middle);
  std::vector<double> series;
  for (const auto& [theta, values] : contrasts) series.push_back(io::median(values));
  if (series.size() < 3 || series.front() < 2 || series.front() < 2 * series.back()) return false;
  return std::adjacent_find(series.begin(), series.end(), [](double a, double b) { return b > 1.05 * a; }) ==
         series.end();
}

}  // namespace

Finding angle_unit(const io::SampleTable& t) {
  Finding f = start(t, "angle_unit");
  f.bound = kPi / 2;
  double polar = 0, azimuth = 0;
  std::set<double> sizes;
  for (const auto* column : {&t.theta_i, &t.theta_o, &t.phi_i, &t.phi_o}) {
    double& largest = column == &t.theta_i || column == &t.theta_o ? polar : azimuth;
    for (const double x : *column) {
      largest = std::max(largest, std::abs(x));
      if (x != 0 && sizes.size() < 1000) sizes.insert(std::abs(x));
    }
  }
  f.value = polar;
  if (polar > 1.58 || azimuth > 6.29) {
    f.statement = "angles are degrees: polar angles reach " + io::short_number(polar, 6);
    return f;
  }
  if (polar == 0) return not_applicable(t.source, "angle_unit", "every direction is the normal");
  const std::string range =
      "polar angles reach " + io::short_number(polar, 4) + " and azimuths " + io::short_number(azimuth, 4);
  std::size_t in_radians = 0, in_degrees = 0;
  for (const double x : sizes) {
    in_radians += round_to(radians(x).degrees(), 0.25, 0.02);
    in_degrees += round_to(x, 0.01, 1e-9);
  }
  const bool quarter_turns = azimuth > 1 && round_to(azimuth, kPi / 2, 2e-3);
  if (quarter_turns || (2 * in_radians > sizes.size() && in_radians > in_degrees)) {
    f.outcome = Outcome::fail;
    f.statement = "angles look like radians: " + range + "; write them in degrees (times 180/pi)";
  } else if (in_degrees < sizes.size()) {
    f.outcome = Outcome::undecided;
    f.statement = range + ": radians, or a scan of two degrees";
  } else {
    f.statement = "angles are degrees: " + range + ", in steps of a hundredth";
  }
  return f;
}

Finding polar_angle(const io::SampleTable& t, const io::CosineFactor& cosine) {
  const double low = *std::min_element(t.theta_o.begin(), t.theta_o.end());
  const double high = *std::max_element(t.theta_o.begin(), t.theta_o.end());
  Finding f = start(t, "polar_angle");
  const auto fail = [&](const std::string& what) {
    f.outcome = Outcome::fail;
    f.statement =
        what + ": angles look like elevations above the surface, not from the normal (90 less them)";
    return f;
  };
  const std::vector<Highlight> lights = highlights(t);
  if (cosine.found == io::Cosine::none && fades_with_theta(lights))
    return fail("the highlight fades as the light's angle grows");
  if (peaks_at_the_complement(lights))
    return fail("highlights stand at theta_o = 90 - theta_i, so that one of the two is no polar angle");
  if (high < 75) return not_applicable(t.source, "polar_angle", "no row lies near grazing");
  const auto at_low = variation(t, low, low < 1), at_high = variation(t, high, high > 89);
  if (!at_low || !at_high)
    return not_applicable(t.source, "polar_angle", "too few azimuths to tell the normal from grazing");
  f.value = *at_low;
  f.bound = std::max(3 * *at_high, 0.3);
  const auto factor = [](double log) { return io::short_number(std::exp(log), 3); };
  const std::string spread = "values vary with the azimuth by a factor " + factor(*at_low) +
                             " at theta_o = " + io::short_number(low, 3) + " and by " + factor(*at_high) +
                             " at " + io::short_number(high, 3);
  if (low < 20 && f.value > f.bound) return fail(spread);
  f.statement = "polar angles are from the normal: " + spread;
  return f;
}

Finding azimuth(const io::SampleTable& t) {
  constexpr double kHighlight = 3;  // over the median of the rows
  std::vector<double> ratios, contrasts;
  struct Back {
    double theta_i, value, ratio, contrast, shoulder;
  };
  std::vector<Back> back;
  for (const Highlight& h : highlights(t)) {
    if (h.mirror < 0 && h.back < 0) continue;
    const double mirror = h.mirror < 0 ? h.middle : std::max(h.mirror, 1e-3 * h.middle);
    const double light = h.back < 0 ? h.middle : std::max(h.back, 1e-3 * h.middle);
    ratios.push_back(light / mirror);
    contrasts.push_back(std::max(light, mirror) / h.middle);
    back.push_back({h.theta_i, light, ratios.back(), light / h.middle, h.shoulder});
  }
  if (ratios.size() < 2)
    return not_applicable(t.source, "azimuth", "too few lights with rows in the plane of incidence");
  Finding f = start(t, "azimuth");
  f.value = io::median(ratios);
  f.bound = kHighlight;
  std::sort(back.begin(), back.end(), [](const Back& a, const Back& b) { return a.theta_i < b.theta_i; });
  // A faint highlight stands out where the light is steep. There rough surfaces are bright towards the light as well,
  // but broadly: to 0.5 of it within 25 degrees.
  const Back& steepest = back.back();
  const bool narrow = steepest.shoulder >= 0 && steepest.shoulder < 0.3 * steepest.value;
  if (f.value > 1.2 && narrow && steepest.ratio > kHighlight && steepest.contrast > kHighlight)
    f.value = steepest.ratio;
  if ((io::median(contrasts) < 1.5 && f.value <= f.bound) || (f.value > 1 / 1.5 && f.value <= f.bound))
    return not_applicable(t.source, "azimuth", "no highlight stands out on either side of the normal");
  if (f.value <= f.bound) {
    f.statement = "the highlight stands on the mirror side, phi_o = phi_i + 180";
    return f;
  }
  const std::string where =
      "values are " + io::short_number(f.value, 3) +
      " times as large at phi_o = phi_i, towards the light, as at phi_o = phi_i + 180, the "
      "mirror direction";
  // A mirror's highlight grows towards grazing, or stays; a retro-reflector's fades, a rough surface's is broad.
  const bool fades = steepest.value < 0.5 * back.front().value;
  const bool stands_out = std::max(io::median(contrasts), steepest.contrast) >= kHighlight;
  f.outcome = stands_out && narrow && !fades ? Outcome::fail : Outcome::undecided;
  f.statement =
      where + (f.outcome == Outcome::fail
                   ? ": the azimuths look like those of the other convention (add 180 degrees to phi_o)"
                   : ": a surface that sends light back, or the other azimuth convention");
  return f;
}

}  // namespace brdf::validate
