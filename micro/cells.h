// A division of the outgoing hemisphere into nearly square cells.
#pragma once

#include <vector>

#include "brdf/directions.h"
#include "micro/facets.h"

namespace brdf::micro {

// A cell [theta_low, theta_high) x [phi_low, phi_high), in radians.
struct Cell {
  double theta_low, theta_high, phi_low, phi_high;

  // Returns the integral of cos theta over the solid angle of the cell.
  double projected_solid_angle() const;
  // Returns the direction at the centre of the cell, the middle of theta and of phi.
  Vec centre() const { return direction(centre_theta(), centre_phi()); }
  Angle centre_theta() const { return radians((theta_low + theta_high) / 2); }
  Angle centre_phi() const { return radians((phi_low + phi_high) / 2); }
  // Maps the point (u, v) of [0, 1)^2 into the cell; equal areas have equal projected solid angle.
  Vec point(double u, double v) const;
};

// Rows of equal height in theta. The number of cells in each row keeps their width near that height. One
// cell of each row is centred on phi = 0. The number of cells per row is even; phi = 180 degrees is
// therefore a centre too.
class Cells {
 public:
  explicit Cells(Angle width);
  int size() const { return static_cast<int>(cells_.size()); }
  const Cell& operator[](int index) const { return cells_[index]; }
  // Returns the cell that contains the direction (z >= 0), with azimuths measured from `phi_zero`.
  int find(const Vec& w, Angle phi_zero = {}) const;

 private:
  double height_;
  std::vector<int> row_begin_;  // index of the first cell of each row, and the end
  std::vector<Cell> cells_;
};

}  // namespace brdf::micro
