// The kinks in the masking of V-cavities, G = min(1, 2 h_z o_z/(o.h), 2 h_z i_z/(o.h)), in the slopes
// (p, q) of the half vector.
#pragma once

#include <vector>

namespace brdf::integrals {

// Returns the q in (q_low, q_high) at which G changes its branch at this p, in ascending order.
std::vector<double> v_cavity_kinks(double ox, double oy, double oz, double p, double q_low, double q_high);

// Returns the p in (p_low, p_high) at which the branches of a row change, in ascending order.
std::vector<double> v_cavity_breaks(double ox, double oy, double oz, double p_low, double p_high);

// A point at which a kink crosses q = 0: its p, and |dp/dq| and |d^2p/dq^2| of the curve of the kink there.
struct Crossing {
  double p, steepness, curvature;
};
std::vector<Crossing> v_cavity_crossings(double ox, double oy, double oz);

}  // namespace brdf::integrals
