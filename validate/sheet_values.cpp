// Values that are no f_r: saturated, uncalibrated, or another quantity.
#include <algorithm>
#include <cmath>

#include "io/numbers.h"
#include "validate/sheet_checks.h"

namespace brdf::validate {
namespace {

// The half vector's angle from the normal in twentieths of a degree. All directions of one are alike to forms that know
// nothing else, as to the mirror direction of a highlight.
long half_angle(const io::SampleTable& t, std::size_t k) {
  const Vec3<double> h =
      io::unit_vector(t.theta_i[k], t.phi_i[k]) + io::unit_vector(t.theta_o[k], t.phi_o[k]);
  return std::lround(20 * radians(std::atan2(std::hypot(h.x, h.y), h.z)).degrees());
}

// Rows that hold the largest of some values, all of them, where they are too many for chance; else none.
std::vector<std::size_t> at_ceiling(const io::SampleTable& t, const std::vector<std::size_t>& rows,
                                    const std::vector<double>& values) {
  constexpr double kEqual = 1e-6;
  constexpr std::size_t kFewest = 3;
  double largest = 0;
  for (const std::size_t k : rows) largest = std::max(largest, values[k]);
  if (!(largest > 0)) return {};
  std::vector<std::size_t> top;
  std::vector<double> below;  // of the upper half, without the top
  for (const std::size_t k : rows) {
    if (values[k] >= largest * (1 - kEqual))
      top.push_back(k);
    else if (values[k] > largest / 2)
      below.push_back(values[k]);
  }
  std::vector<long> places;
  for (const std::size_t k : top) places.push_back(half_angle(t, k));
  std::sort(places.begin(), places.end());
  const auto distinct = std::size_t(std::unique(places.begin(), places.end()) - places.begin());
  // Values of few digits, or of a constant surface, are equal below the ceiling as well.
  std::sort(below.begin(), below.end());
  std::size_t run = 0, longest = 0;
  for (std::size_t k = 0; k < below.size(); ++k) {
    run = k > 0 && below[k] <= below[k - 1] * (1 + kEqual) ? run + 1 : 1;
    longest = std::max(longest, run);
  }
  const bool all = 10 * top.size() > 9 * rows.size();
  return distinct >= kFewest && top.size() > 3 * longest && !all ? top : std::vector<std::size_t>{};
}

// The largest reflected fraction that the samples prove, the largest that they allow, and the likeliest one where
// most is proven.
struct Reflected {
  double least = 0, most = 0, likely = 0;
};

Reflected reflected(const std::vector<MeasuredAlbedo>& albedo) {
  Reflected r;
  for (const MeasuredAlbedo& a : albedo)
    for (std::size_t c = 0; c < a.value.size(); ++c) {
      if (const double least = proven(a, c); least > r.least) {
        r.least = least;
        r.likely = a.coverage < kEnoughCoverage ? least : a.value[c];
      }
      r.most = std::max(r.most, a.value[c] + a.bound[c]);
    }
  return r;
}

}  // namespace

Finding saturation(const io::SampleTable& t) {
  std::vector<std::size_t> all(t.rows());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  Finding f = start(t, "saturation");
  f.statement = "no ceiling: the largest values differ";
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const std::vector<std::size_t> top = at_ceiling(t, all, t.values[c]);
    f.value += double(top.size());
    if (top.empty()) continue;
    if (f.outcome == Outcome::pass)
      f.statement = plural(top.size(), "row") + " share the largest value of channel " + t.channels[c] +
                    ", " + io::short_number(t.values[c][top.front()], 6) +
                    ": the detector looks saturated; first " + t.where(top.front());
    f.outcome = Outcome::fail;
    for (const std::size_t k : top) f.rows.push_back(named_row(t, k, c));
  }
  return f;
}

// The largest reflected fraction tells the scale: 1 of a white f_r, pi of a white reflectance factor, a hundred of a
// percentage of f_r, 100 pi of a percentage of the factor, and anything of counts. Between 1 and pi the nearer one, in
// ratio, is meant: up to their geometric mean, and where a white surface cannot be excluded, it is a matter of energy.
Finding quantity(const io::SampleTable& t, const std::vector<MeasuredAlbedo>& albedo) {
  constexpr double kMargin = 1.1, kDarkest = 1e-4;  // the blackest coatings reflect 2e-4
  const Reflected r = reflected(albedo);
  double largest = 0;
  bool whole = true;
  for (const auto& values : t.values)
    for (const double v : values) {
      largest = std::max(largest, v);
      whole = whole && v == std::floor(v);
    }
  Finding f = start(t, "quantity");
  f.value = r.likely;
  f.bound = std::sqrt(kPi);
  f.statement = "values are as large as those of f_r can be";
  const auto fail = [&](const std::string& what) {
    f.outcome = Outcome::fail;
    f.statement = what;
  };
  const std::string uncalibrated = " (no f_r in 1/sr; `brdf fit --free-scale` fits the shape alone)";
  const auto divided = [&](double by) { return io::short_number(r.least / by, 3); };
  const std::string as_f_r =
      "as f_r they would reflect at least " + io::short_number(r.least, 3) + " of the light";
  if (r.least > kMargin * 100 * kPi || (whole && largest >= 256))
    fail("uncalibrated: " +
         (whole ? "whole numbers up to " + io::short_number(largest, 8) + ", like counts" : as_f_r) +
         uncalibrated);
  else if (r.most < kDarkest && largest > 0)
    fail("uncalibrated: as f_r they would reflect at most " + io::short_number(r.most, 3) +
         " of the light, less than the blackest surface" + uncalibrated);
  else if (r.least > kMargin * kPi)
    fail("values look like percent: " + as_f_r + ", over 100 " + divided(100) +
         ", as a reflectance factor in percent (over 100 pi) " + divided(100 * kPi));
  else if (r.least > 1 && r.likely > f.bound)
    fail("values look like BRF, the reflectance factor pi f_r: " + as_f_r + ", over pi " + divided(kPi));
  return f;
}

}  // namespace brdf::validate
