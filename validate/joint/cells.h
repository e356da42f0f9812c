// The hemisphere in cells of about equal probability, with the integrals of a density and of f cos in each.
#pragma once

#include <span>
#include <vector>

#include "validate/joint/trio.h"

namespace brdf::validate {

// A rectangle in 1 - cos theta and azimuth, in which solid angle is the product of the sides.
struct Cell {
  double s0, s1, phi0, phi1;
};

class Cells {
 public:
  // Divides the hemisphere at the medians of these directions, first into 16 groups, then into about 256
  // cells. Without directions the cells are a regular grid.
  explicit Cells(std::span<const Vec3<double>> directions);

  const std::vector<Cell>& all() const { return cells_; }
  // Returns the group (0 to 15) of a cell.
  int group(std::size_t cell) const { return groups_[cell]; }
  // Returns the cell of a direction above the horizon.
  std::size_t find(const Vec3<double>& wi) const;

 private:
  struct Node {
    bool by_phi = false;
    double at = 0;
    int below = -1, above = -1;  // nodes; of a leaf: -1 and its cell
  };
  int divide(std::vector<Vec3<double>>& points, std::size_t begin, std::size_t end, Cell cell, int depth,
             int group, std::size_t least);

  std::vector<Node> nodes_;
  std::vector<int> roots_;  // of the quarters of the azimuth
  std::vector<Cell> cells_;
  std::vector<int> groups_;
};

// Integrals over the hemisphere, with estimates of their errors.
struct Integrals {
  std::vector<double> density;  // of each cell
  double mass = 0, mass_error = 0;
  std::vector<double> albedo;           // of each channel
  std::vector<double> without_density;  // the part of it at directions with density 0
  double albedo_error = 0;
  Vec3<double> unreached{};    // the direction with density 0 and the largest f cos
  double unreached_value = 0;  // f cos there
  Vec3<double> not_finite{};   // a direction with a density that is not finite or below 0
  bool all_finite = true;
  long evaluations = 0;
};

// Integrates by Gauss-Legendre rules of 4 x 4 points on cells that are divided where the error is largest,
// until the error is below `tolerance` or the number of evaluations reaches `most`. The cell around the
// mirror direction is divided first, and all cells until the rules see the density at the given directions
// (samples above the horizon), so that no narrow lobe is missed between the points of a rule. The share of
// directions that were not used for this and are missed is part of mass_error.
Integrals integrals_of(const Trio& trio, const Cells& cells, std::span<const Vec3<double>> directions,
                       double tolerance, long most);

}  // namespace brdf::validate
