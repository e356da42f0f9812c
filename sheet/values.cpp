// Finds values that are not f_r: saturated, uncalibrated, or another quantity.
#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "io/samples/degrees.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

// Returns the angle between the half vector and the normal, in units of 1/20 degree. Forms that depend on
// this angle alone have equal values for all directions with the same angle. For example, all mirror
// directions have the angle 0.
long half_angle(const io::SampleTable& t, std::size_t k) {
  const Vec3<double> h =
      io::unit_vector(t.theta_i[k], t.phi_i[k]) + io::unit_vector(t.theta_o[k], t.phi_o[k]);
  return std::lround(20 * radians(std::atan2(std::hypot(h.x, h.y), h.z)).degrees());
}

// Returns all rows that hold the largest of the values if they are too many for chance; otherwise an empty
// list. `scatter`: relative noise, 0 if unknown. Noisy values are never equal; exact values are equal if
// their half vectors are.
std::vector<Row> at_ceiling(const io::SampleTable& t, const std::vector<Row>& rows,
                            const std::vector<double>& values, double scatter) {
  constexpr double kEqual = 1e-6, kScatters = 1e-3;
  constexpr std::size_t kFewest = 3, kFewestThatScatter = 4;
  double largest = 0;
  for (const Row k : rows) largest = std::max(largest, values[k]);
  if (!(largest > 0)) return {};
  std::vector<Row> top;
  std::vector<double> below;  // of the upper half, without the top
  for (const Row k : rows) {
    if (values[k] >= largest * (1 - kEqual))
      top.push_back(k);
    else if (values[k] > largest / 2)
      below.push_back(values[k]);
  }
  std::vector<long> places;
  for (const Row k : top) places.push_back(half_angle(t, k));
  std::ranges::sort(places);
  const auto distinct = std::size_t(std::unique(places.begin(), places.end()) - places.begin());
  // Values of few digits, or of a constant surface, are equal below the ceiling as well.
  std::ranges::sort(below);
  std::size_t run = 0, longest = 0;
  for (std::size_t k = 0; k < below.size(); ++k) {
    run = k > 0 && below[k] <= below[k - 1] * (1 + kEqual) ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  const bool enough = distinct >= kFewest || (scatter > kScatters && top.size() >= kFewestThatScatter);
  return enough && top.size() > 3 * longest && top.size() < rows.size() ? top : std::vector<Row>{};
}

// The largest reflected fraction that the samples prove, the likeliest fraction of a covered hemisphere,
// and the fraction that the plane of incidence would reflect if all azimuths were like it.
struct Reflected {
  double least = 0, likely = 0;
  bool is_covered = false;
  Plane plane;
};

Reflected reflected(const std::vector<MeasuredAlbedo>& albedo) {
  Reflected r;
  for (const MeasuredAlbedo& a : albedo) {
    for (std::size_t c = 0; c < a.value.size(); ++c) {
      r.least = std::max(r.least, a.least[c]);
      if (a.coverage < kEnoughCoverage) continue;
      r.is_covered = true;
      r.likely = std::max(r.likely, a.value[c]);
    }
  }
  r.plane = plane_of(albedo);
  return r;
}

struct Range {
  double largest = 0;
  bool whole = true;
};

Range range_of(const io::SampleTable& t) {
  Range r;
  for (const auto& values : t.values)
    for (const double v : values) {
      r.largest = std::max(r.largest, v);
      r.whole = r.whole && v == std::floor(v);
    }
  return r;
}

constexpr std::string_view kUncalibrated = " (not f_r in 1/sr; `brdf fit --free-scale` fits the shape only)";
// The largest fraction that a surface reflects, with a margin. As a reflectance factor the limit is pi
// times this, and 100 pi times in percent.
constexpr double kWhite = 1.1;

// Returns the name of the quantity that values of this scale are, from the fraction of the light that they
// would reflect as f_r; empty if they may be f_r. A percentage of a black sample and the factor of a bright
// one have the same scale.
std::string scale_named(double fraction) {
  const auto over = [&](double by) { return io::short_number(fraction / by, 3); };
  if (fraction > kWhite * 100 * kPi) return "uncalibrated, like counts";
  if (fraction > kWhite * kPi)
    return "reflectance in percent: divided by 100, the albedo would be " + over(100) +
           "; divided by 100 pi, as a reflectance factor in percent, " + over(100 * kPi);
  if (fraction > 1)
    return "the reflectance factor pi f_r (BRF): divided by pi, the albedo would be " + over(kPi);
  return "";
}

// Judges the scale from the plane of incidence. Its rows give no information on the other azimuths: they
// can only raise a suspicion, not prove it.
Finding quantity_in_plane(const io::SampleTable& t, const Reflected& r) {
  constexpr double kSuspicious = 1.35;
  Finding f =
      undecided(t, "quantity", "the angular coverage is too small to determine the scale of the values");
  f.value = r.plane.reflected;
  f.bound = r.plane.is_half ? std::sqrt(kPi) : kSuspicious;
  if (r.plane.reflected == 0) return f;
  const std::string seen =
      "if the plane of incidence represented all azimuths, the albedo without the highlight would be " +
      io::short_number(r.plane.reflected, 3);
  const std::string covered = f.statement;
  f.statement += ": " + seen;
  if (r.plane.reflected <= f.bound) return f;
  f.is_suspicion = true;
  f.statement = "the values look like " + scale_named(r.plane.reflected) + "; " + covered + ", but " + seen;
  return f;
}

}  // namespace

Finding saturation_of(const View& view, double scatter) {
  const io::SampleTable& t = view.table();
  std::vector<Row> all(t.rows());
  for (Row k = 0; k < all.size(); ++k) all[k] = k;
  Finding f = start(t, "saturation");
  f.statement = "no more rows share the largest value than chance explains";
  constexpr std::size_t kFewestRows = 20;
  if (t.rows() >= kFewestRows && is_constant(t))
    return undecided(t, "saturation",
                     "all rows have the same value: a computed table, or complete saturation");
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const std::vector<Row> top = at_ceiling(t, all, t.values[c], scatter);
    f.value += double(top.size());
    if (top.empty()) continue;
    if (f.outcome == Outcome::pass)
      f.statement = plural(top.size(), "row") + " share the largest value of channel " + t.channels[c] +
                    ", " + io::short_number(t.values[c][top.front()], 6) +
                    ": the detector seems saturated; first " + view.where(top.front());
    f.outcome = Outcome::fail;
    for (const Row k : top) f.rows.push_back(named_row(view, k, c));
  }
  if (f.outcome == Outcome::pass && t.rows() < kFewestRows)
    return not_applicable(t.source, "saturation", "too few rows");
  return f;
}

Finding saturation(const Evidence& e) {
  return saturation_of(e.view, e.neighbours.value.value_or(0));
}

// Judges the scale from the largest reflected fraction, which is 1 for a white f_r, pi for a white
// reflectance factor, 100 for a percentage of f_r, 100 pi for a percentage of the factor, and arbitrary for
// counts. Between 1 and pi the nearer scale, in ratio, is assumed, so that f_r extends up to their
// geometric mean. If a white surface cannot be excluded there, the energy check decides.
Finding quantity_of(const View& view, const std::vector<MeasuredAlbedo>& albedo) {
  constexpr double kDarkest = 1e-4;  // the blackest coatings reflect 2e-4
  const io::SampleTable& t = view.table();
  if (!has_light(t)) return not_applicable(t.source, "quantity", "no value is above 0");
  const Reflected r = reflected(albedo);
  const Range range = range_of(t);
  Finding f = start(t, "quantity");
  f.value = r.is_covered ? r.likely : r.least;
  f.bound = std::sqrt(kPi);
  const std::string as_f_r =
      "as f_r, their directional albedo would be at least " + io::short_number(r.least, 3);
  const auto fail = [&](const std::string& what) {
    f.outcome = Outcome::fail;
    f.statement = what;
    return f;
  };
  if (range.whole && range.largest >= 256)
    return fail("uncalibrated: whole numbers up to " + io::short_number(range.largest, 8) + ", like counts" +
                std::string(kUncalibrated));
  if (kPi * range.largest < kDarkest && range.largest > 0)
    return fail("uncalibrated: as f_r, their directional albedo would be at most " +
                io::short_number(kPi * range.largest, 3) + ", less than that of the blackest surface" +
                std::string(kUncalibrated));
  if (r.least > kWhite * 100 * kPi) return fail("uncalibrated: " + as_f_r + std::string(kUncalibrated));
  if (r.least > kWhite * kPi || (r.least > 1 && r.likely > f.bound))
    return fail("the values look like " + scale_named(std::max(r.least, r.is_covered ? r.likely : 0)) + "; " +
                as_f_r);
  if (!r.is_covered) return quantity_in_plane(t, r);
  if (r.likely > f.bound) {
    f.outcome = Outcome::undecided;
    f.is_suspicion = true;
    f.statement = "the values look like " + scale_named(r.likely) +
                  "; as f_r, their directional albedo would be " + io::short_number(r.likely, 3) +
                  ", of which consistent neighbours prove " + io::short_number(r.least, 3);
    return f;
  }
  const std::string reflected =
      "as f_r, the values have a directional albedo of up to " + io::short_number(r.likely, 3);
  f.statement =
      r.likely > 1
          ? reflected +
                ", closer to the scale of f_r than to any other; the check of energy judges whether a "
                "surface can have it"
          : reflected + ", possible for a surface; smaller units of a darker sample would look the same";
  return f;
}

Finding quantity(const Evidence& e) {
  return quantity_of(e.view, e.albedo);
}

}  // namespace brdf::sheet
