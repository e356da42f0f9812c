// Reciprocal pairs: the same two directions, with light and viewer exchanged. Both values are equal
// (Helmholtz reciprocity).
#pragma once

#include <vector>

#include "sheet/view.h"

namespace brdf::sheet {

struct Pair {
  std::size_t scan_a, scan_b;  // indices in View::scans(); both 0 for scattered directions
  double theta_a, theta_b;     // degrees: the two angles of incidence
  double azimuth;              // degrees between the two directions, 0 to 180
  double log_ratio;       // of the value with the light at a over the value with the light at b (View::level)
  double uncertainty;     // of log_ratio, by interpolation in the viewer's angle; 0 for an exact pair
  double order;           // how much later in the file the first value is, -1 to 1: a share of all rows
  Row forward, backward;  // the two rows (for interpolated values, the nearest rows)
  bool exact() const { return uncertainty == 0; }
  // For an anisotropic sample only pairs in the plane of incidence are reciprocal: a half turn restores the
  // sample.
  bool is_in_plane() const { return azimuth < 1 || azimuth > 179; }
};

// Returns every pair of the scans. If the grid misses the exchanged direction, the logarithm is
// interpolated cubically along the viewer's polar angle; pairs with an interpolation error above 30 % are
// omitted. For scattered directions only exact pairs are returned. Directions with equal polar angles are
// their own partners and are omitted.
std::vector<Pair> reciprocal_pairs(const View& view);

}  // namespace brdf::sheet
