// Reciprocal pairs: the same two directions, light and viewer exchanged (Helmholtz reciprocity: the two
// values are equal).
#pragma once

#include <vector>

#include "sheet/view.h"

namespace brdf::sheet {

struct Pair {
  std::size_t scan_a, scan_b;  // of View::scans(); both 0 where the directions are scattered
  double theta_a, theta_b;     // degrees, the light's angles of the two
  double azimuth;              // degrees between the two directions, 0 to 180
  double log_ratio;       // of the value with the light at a to the value with the light at b (View::level)
  double uncertainty;     // of log_ratio, by interpolation in the viewer's angle; 0 of an exact pair
  double order;           // how much later in the file the first value stands, -1 to 1: a share of all rows
  Row forward, backward;  // the rows (the nearest ones, of interpolated values)
  bool exact() const { return uncertainty == 0; }
  // The exchanged pair of an anisotropic sample is measured only there: half a turn brings it back.
  bool is_in_plane() const { return azimuth < 1 || azimuth > 179; }
};

// Every pair that the scans hold, in logarithms by cubic interpolation along the viewer's polar angle where
// the grid does not hit the exchanged direction; pairs whose interpolation is worse than 30 % are left out.
// Of scattered directions the exact pairs. Directions with equal polar angles are their own partners and are
// left out.
std::vector<Pair> reciprocal_pairs(const View& view);

}  // namespace brdf::sheet
