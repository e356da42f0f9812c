// Detects angles in radians, where the format has degrees.
#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "io/files/text.h"
#include "sheet/checks.h"

namespace brdf::sheet {
namespace {

bool round_to(double x, double step, double tolerance) {
  return std::abs(x - step * std::round(x / step)) <= tolerance;
}

// The numbers in the column of one angle, as in the file.
struct AngleColumn {
  std::string name;
  bool is_polar;
  double largest = 0;
  std::vector<double> sizes;  // distinct magnitudes except 0, at most 1000

  bool fits_radians() const { return largest <= (is_polar ? 0.5 : 2) * kPi + 0.01; }
  std::size_t hundredths() const {
    return std::size_t(std::ranges::count_if(sizes, [](double x) { return round_to(x, 0.01, 1e-9); }));
  }
  // Counts the magnitudes that are quarters of a degree after conversion to degrees.
  std::size_t round_in_degrees() const {
    return std::size_t(
        std::ranges::count_if(sizes, [](double x) { return round_to(radians(x).degrees(), 0.25, 0.02); }));
  }
  bool looks_like_radians() const {
    if (!fits_radians() || sizes.empty()) return false;
    if (!is_polar && largest > 1 && round_to(largest, kPi / 2, 2e-3)) return true;
    if (2 * round_in_degrees() > sizes.size() && round_in_degrees() > hundredths()) return true;
    // A scan within a degree and a half of the normal has round set points.
    constexpr double kWide = 0.7;
    return is_polar && largest > kWide && sizes.size() >= 4 && 4 * hundredths() < sizes.size();
  }
  bool may_be_radians() const { return fits_radians() && hundredths() < sizes.size(); }
};

AngleColumn column_of(std::string name, bool is_polar, const std::vector<double>& angles) {
  constexpr std::size_t kMost = 1000;
  AngleColumn c{std::move(name), is_polar};
  std::set<double> sizes;
  for (const double x : angles) {
    c.largest = std::max(c.largest, std::abs(x));
    if (x != 0 && sizes.size() < kMost) sizes.insert(std::abs(x));
  }
  c.sizes.assign(sizes.begin(), sizes.end());
  return c;
}

// Returns the angle columns. If the reader kept the cells of the file, they are used, since signs and
// conventions hide a unit. A column with a stated unit is omitted.
std::vector<AngleColumn> angle_columns(const io::SampleTable& t) {
  const std::pair<const char*, const std::vector<double>*> of_table[] = {
      {"theta_i", &t.theta_i}, {"phi_i", &t.phi_i}, {"theta_o", &t.theta_o}, {"phi_o", &t.phi_o}};
  std::vector<AngleColumn> columns;
  for (std::size_t a = 0; a < std::size(of_table); ++a) {
    const io::RawAngle& raw = t.raw_angles[a];
    const bool is_polar = a % 2 == 0;
    if (raw.name.empty()) {
      columns.push_back(column_of(of_table[a].first, is_polar, *of_table[a].second));
      continue;
    }
    if (raw.has_unit) continue;
    columns.push_back({raw.name, is_polar, raw.largest, raw.magnitudes});
    std::erase(columns.back().sizes, 0.0);
  }
  return columns;
}

std::string named(const std::vector<const AngleColumn*>& columns) {
  std::vector<std::string> names;
  for (const AngleColumn* c : columns)
    names.push_back(c->name + " (up to " + io::short_number(c->largest, 4) + ")");
  return io::joined(names, ", ");
}

}  // namespace

Finding angle_unit(const Evidence& e) {
  const io::SampleTable& t = e.read;
  const std::vector<AngleColumn> columns = angle_columns(t);
  std::vector<const AngleColumn*> radian, open;
  const double polar = std::max(*std::ranges::max_element(t.theta_i), *std::ranges::max_element(t.theta_o));
  if (columns.empty()) {
    Finding stated = start(t, "angle_unit");
    stated.statement = "the file states the unit of every angle";
    return stated;
  }
  for (const AngleColumn& c : columns) {
    if (c.looks_like_radians())
      radian.push_back(&c);
    else if (c.may_be_radians())
      open.push_back(&c);
  }
  if (polar == 0) return not_applicable(t.source, "angle_unit", "every direction is the normal");
  const bool polar_fits =
      std::ranges::all_of(columns, [](const AngleColumn& c) { return !c.is_polar || c.fits_radians(); });
  // An azimuth of 3 next to polar angles of 60 is 3 degrees.
  if (!polar_fits) std::erase_if(radian, [](const AngleColumn* c) { return !c->is_polar; });
  Finding f = start(t, "angle_unit");
  f.value = polar;
  f.bound = kPi / 2;
  if (!radian.empty()) {
    f.outcome = Outcome::fail;
    f.statement =
        "angles look like radians: " + named(radian) +
        (radian.size() < columns.size() && !polar_fits ? ", while other angles are in degrees" : "") +
        "; convert them to degrees (multiply by 180/pi)";
  } else if (polar_fits && !open.empty()) {
    f.outcome = Outcome::undecided;
    f.is_suspicion = true;
    f.statement = named(open) +
                  ": the unit is ambiguous: radians, or degrees in a scan within two degrees of the normal";
  } else {
    f.statement = "angles are in degrees: polar angles reach " + io::short_number(polar, 6);
  }
  return f;
}

}  // namespace brdf::sheet
