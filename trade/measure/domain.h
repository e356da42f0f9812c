// Where an error is measured: a box of named axes, filled with low-discrepancy points.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "trade/measure/kernel.h"

namespace brdf::trade {

struct Axis {
  std::string name;  // with its unit where it has one
  double min, max;
  bool log = false;
};

// `inputs` turns a point of the box (one value per axis) into a kernel's row, or refuses it (directions below
// the horizon). Without it the axes are the row.
struct Domain {
  std::vector<Axis> axes;
  std::function<bool(std::span<const double> at, Row<double>& row)> inputs;
  std::string note;  // what is fixed
};

struct Points {
  Columns<double> columns;
  std::vector<std::vector<double>> at;  // [point][axis]
  std::size_t count() const { return at.size(); }
};

// "cos 0.01..1, alpha 0.05..1 (log); eta 1.5"
std::string describe(const Domain& domain);
// "cos 0.01, alpha 0.05"
std::string describe(const Domain& domain, const std::vector<double>& at);

// The first `count` points of the additive recurrence on the generalised golden ratio (Roberts 2018, R_d),
// then the corners of the box, where errors tend to be largest. The refused ones are left out.
Points sample(const Domain& domain, std::size_t count);

// The nearest float, widened again: what a choice that computes in float is given.
double as_float(double x);

// Row of a pair of directions and two parameters: wi, wo, p, q.
bool direction_row(double theta_i, double theta_o, double phi, double p, double q, Row<double>& row);

// Directions around the lobe's peak: the half vector's slope in units of alpha (0..widths), the angle between
// direction and half vector (degrees) and its azimuth; then alpha and one more parameter. Every lobe is
// covered alike, however narrow.
Domain lobe_domain(Axis alpha, Axis parameter, double widths = 3, double most_theta_d = 85);

// Any pair of directions, by their angles in degrees, then two parameters.
Domain direction_domain(Axis p, Axis q, double most_theta = 89);

// Any pair of directions whose polar angles lie in a range, in degrees.
Domain pairs_domain(double least_theta, double most_theta);

}  // namespace brdf::trade
