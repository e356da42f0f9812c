// What was measured, for a shader: its ratio to the fitted value as bytes.
#pragma once

#include <string>
#include <vector>

#include "io/page/sphere/view.h"

namespace brdf::io::sphere {

// Nodes in Rusinkiewicz' angles (1998): theta_h = 90 degrees (i/(n - 1))^2, dense in the highlight; theta_d
// evenly from 0 to 90; phi_d evenly over 180 degrees, which exchange of the directions continues; phi_h over
// 360, 1 where the measurement is isotropic.
struct TableSize {
  int theta_h = 64, theta_d = 16, phi_d = 16, phi_h = 1;
};
inline constexpr TableSize kIsotropic{}, kTurned{24, 8, 8, 16};

// RGBA for each node, theta_h fastest, then theta_d, phi_d (its first node once more after the last), phi_h.
// A colour is the logarithm of measured/(fitted + floor), 0 to 255 evenly from `low` to `high`; the fourth
// byte is 255 times the share of the node's surroundings that was measured, and the colours are multiplied by
// that share. Isotropic 69,632 bytes, turned 110,592. Accuracy at a node: (high - low)/510, at most 1.1 %,
// for measured values within a factor of 16 of the fitted ones; between nodes as the ratio is smooth.
struct Table {
  TableSize size;
  double low = 0, high = 0, floor = 0;
  std::string bytes;
};
Table table_of(const FittedPairs& fitted, const MeasuredPairs& measured, const TableSize& size = kIsotropic);

}  // namespace brdf::io::sphere
