// The outgoing hemisphere cut into nearly square cells.
#pragma once

#include <vector>

#include "brdf/directions.h"
#include "micro/facets.h"

namespace brdf::micro {

// A cell [theta_low, theta_high) x [phi_low, phi_high), radians.
struct Cell {
  double theta_low, theta_high, phi_low, phi_high;

  // Integral of cos theta over the cell's solid angle.
  double projected_solid_angle() const;
  // Direction at its centre: the middle of theta (0 for a polar cap) and phi.
  Vec centre() const { return direction(centre_theta(), centre_phi()); }
  Angle centre_theta() const { return radians((theta_low + theta_high) / 2); }
  Angle centre_phi() const { return radians((phi_low + phi_high) / 2); }
  // The point (u, v) of [0, 1)^2 mapped so that equal areas have equal projected solid angle.
  Vec point(double u, double v) const;
};

// Rows of equal height in theta; in each, as many cells as keep their width near that height. One cell of
// each row is centred on phi = 0; the number per row is even, so that phi = 180 degrees is a centre too.
class Cells {
 public:
  explicit Cells(Angle width);
  int size() const { return static_cast<int>(cells_.size()); }
  const Cell& operator[](int index) const { return cells_[index]; }
  // The cell that holds the direction (z >= 0), with azimuths counted from `phi_zero`.
  int find(const Vec& w, Angle phi_zero = {}) const;

 private:
  double height_;
  std::vector<int> row_begin_;  // index of each row's first cell, and the end
  std::vector<Cell> cells_;
};

}  // namespace brdf::micro
