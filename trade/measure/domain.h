// The domain of an error: a box of named axes, filled with low-discrepancy points.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trade/measure/kernel.h"

namespace brdf::trade {

struct Axis {
  std::string name;  // with its unit, if any
  double min, max;
  bool log = false;
};

struct Domain {
  std::vector<Axis> axes;
  // Maps a point of the box, one value per axis, to the numbers of a row. Returns an empty vector if the
  // point is rejected (directions below the horizon).
  std::function<std::vector<double>(std::span<const double> at)> row;
  std::string note;  // fixed quantities
};

// Makes a domain from `row`; `row(at)` returns a row or an optional row.
template <class F>
Domain make_domain(std::vector<Axis> axes, F row, std::string note = {}) {
  const auto numbers = [row](std::span<const double> at) -> std::vector<double> {
    const std::optional made = row(at);
    if (!made) return {};
    const auto fields = fields_of(*made);
    return {fields.begin(), fields.end()};
  };
  return {std::move(axes), numbers, std::move(note)};
}

struct Points {
  Columns<double> columns;
  std::vector<std::vector<double>> at;  // [point][axis]
  std::size_t count() const { return at.size(); }
};

// Returns for example "cos 0.01..1, alpha 0.05..1 (log); eta 1.5".
std::string describe(const Domain& domain);
// Returns for example "cos 0.01, alpha 0.05".
std::string describe(const Domain& domain, const std::vector<double>& at);

// Returns the first `count` points of the additive recurrence, then the corners of the box, at which errors
// tend to be largest. Rejected points are left out.
Points sample(const Domain& domain, std::size_t count);

// Returns the nearest float as a double: the argument of a choice that computes in float.
double as_float(double x);
// Returns a domain with rows rounded in this way. Errors over it are then due to the formula alone.
Domain stored_in_float(Domain domain);

// Returns a domain of all pairs of directions with polar angles in this range (degrees), followed by a width
// and f0 if `parameters` has axes for them.
Domain direction_domain(double least_theta, double most_theta, std::vector<Axis> parameters = {});

// Returns a domain around the lobe's peak: the slope of the half vector in units of the width (0..widths),
// the angle between direction and half vector (degrees) and its azimuth; then the width. Lobes of all widths
// are covered equally.
Domain lobe_domain(Axis width, double widths = 3, double most_theta_d = 85);

}  // namespace brdf::trade
