// The measured values that belong into a plot of a lobe.
#pragma once

#include <vector>

#include "io/samples/samples.h"

namespace brdf::render {

// Degrees: rows whose light stands within this of the plot's are drawn, in the plot of the plane of incidence
// those of io/samples/in_plane.h.
inline constexpr double kNearLight = 1;

// A row's viewer as seen from the plane of incidence: the mirror direction is at theta_i, phi 0.
struct LobePoint {
  double theta = 0, phi = 0;  // degrees; theta from -90 in the plane (phi 0), otherwise from 0
  std::size_t row = 0;
};

// Of the rows in the plane of incidence, or of all that have this light. A turned sample: only the rows whose
// light comes from azimuth 0 or 180 (within kNearLight), where the plots' light stands.
std::vector<LobePoint> points_in_plane(const io::SampleTable& table, double theta_i);
std::vector<LobePoint> points_of_light(const io::SampleTable& table, double theta_i);

// The polar angle of the table's light that is nearest to this one. NaN without rows.
double nearest_light(const io::SampleTable& table, double theta_i);

}  // namespace brdf::render
