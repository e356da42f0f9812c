// The measured values that belong in the plot of a lobe.
#pragma once

#include <vector>

#include "io/samples/samples.h"

namespace brdf::render {

// Degrees: a row is drawn if its light lies within this angle of the plot's light. The plot of the plane of
// incidence draws only the rows that io/samples/in_plane.h counts as in-plane.
inline constexpr double kNearLight = 1;

// The viewing direction of a row relative to the plane of incidence: the mirror direction has theta =
// theta_i and phi = 0.
struct LobePoint {
  // Degrees; theta starts at -90 in the plane (phi is 0 there), otherwise at 0.
  double theta = 0, phi = 0;
  std::size_t row = 0;
};

// Returns the rows in the plane of incidence, or all rows with this light (theta_i in degrees). If the
// sample was rotated, only rows with light from azimuth 0 or 180 degrees (within kNearLight) are returned,
// because the light of the plots has this azimuth.
std::vector<LobePoint> points_in_plane(const io::SampleTable& table, double theta_i);
std::vector<LobePoint> points_of_light(const io::SampleTable& table, double theta_i);

// Returns the polar angle, in degrees, of the table's light that is nearest to this angle. NaN if the table
// has no rows.
double nearest_light(const io::SampleTable& table, double theta_i);

}  // namespace brdf::render
