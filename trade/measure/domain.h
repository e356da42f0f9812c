// Where an error is measured: a box of named axes, filled with low-discrepancy points.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trade/measure/kernel.h"

namespace brdf::trade {

struct Axis {
  std::string name;  // with its unit where it has one
  double min, max;
  bool log = false;
};

struct Domain {
  std::vector<Axis> axes;
  // A point of the box, one value per axis, as the numbers of a row; none where it is refused (directions
  // below the horizon).
  std::function<std::vector<double>(std::span<const double> at)> row;
  std::string note;  // what is fixed
};

// `row(at)` gives a row, or an optional one.
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

// "cos 0.01..1, alpha 0.05..1 (log); eta 1.5"
std::string describe(const Domain& domain);
// "cos 0.01, alpha 0.05"
std::string describe(const Domain& domain, const std::vector<double>& at);

// The first `count` points of the additive recurrence, then the corners of the box, where errors tend to be
// largest. The refused ones are left out.
Points sample(const Domain& domain, std::size_t count);

// The nearest float, widened again: what a choice that computes in float is given.
double as_float(double x);
// Rows of such numbers: only a formula's own error counts.
Domain stored_in_float(Domain domain);

// Any pair of directions whose polar angles lie in the range, in degrees; then a width and f0, where there
// are axes for them.
Domain direction_domain(double least_theta, double most_theta, std::vector<Axis> parameters = {});

// Directions around the lobe's peak: the half vector's slope in units of the width (0..widths), the angle
// between direction and half vector (degrees) and its azimuth; then the width. Every lobe is covered alike,
// however narrow.
Domain lobe_domain(Axis width, double widths = 3, double most_theta_d = 85);

}  // namespace brdf::trade
