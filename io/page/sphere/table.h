// Tabulates a measurement for a shader, as the ratio to the fitted value in bytes.
#pragma once

#include <string>

#include "io/page/sphere/view.h"

namespace brdf::io::sphere {

// Numbers of nodes in Rusinkiewicz' angles (1998). theta_h = 90 degrees (i/(n - 1))^2 is dense in the
// highlight. theta_d is uniform from 0 to 90. phi_d is uniform over 180 degrees; exchanging the directions
// continues it. phi_h is uniform over 360 degrees, with 1 node if the measurement is isotropic.
struct TableSize {
  int theta_h = 64, theta_d = 16, phi_d = 16, phi_h = 1;
};
inline constexpr TableSize kIsotropic{}, kTurned{24, 8, 8, 16};

// RGBA for each node: theta_h is the fastest dimension, then theta_d, phi_d (with its first node repeated
// after the last) and phi_h. A colour is the logarithm of measured/(fitted + floor), mapped linearly so
// that `low` becomes 0 and `high` becomes 255. The fourth byte is 255 times the share of the node's
// neighbourhood that was measured, and the colours are multiplied by this share. Size: 69,632 bytes if
// isotropic, 110,592 bytes with kTurned. Accuracy at a node: (high - low)/510, at most 1.1 %, if the
// measured values are within a factor of 16 of the fitted values. Between nodes the accuracy depends on the
// smoothness of the ratio.
struct Table {
  TableSize size;
  double low = 0, high = 0, floor = 0;
  std::string bytes;
};
// Returns the table of a measurement. `fitted` and `measured` are called by several threads at once.
Table table_of(const FittedPairs& fitted, const MeasuredPairs& measured, const TableSize& size = kIsotropic);

}  // namespace brdf::io::sphere
