// The directions at which a goniophotometer measures.
#pragma once

#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::synth {

struct GridOptions {
  // in_plane    detector in the plane of incidence, -85 to 85 degrees
  // hemisphere  the whole hemisphere of the detector
  // merl        the centres of the 90 x 90 x 180 half-difference cells of the MERL files
  // anything else is the path of a CSV file with the four angles
  std::vector<std::string> parts = {"hemisphere"};
  std::vector<double> theta_i;  // of in_plane and hemisphere, degrees; empty: default angles of each grid
  double step = 0;              // detector step of in_plane and hemisphere, degrees; 0: 1 and 5
  std::vector<double> azimuths = {0};  // the sample is rotated by each of these (degrees) and measured
  double blind_zone = 0;               // smallest possible angle between detector and source, degrees
};

// Returns the directions as a table without channels. Before the sample is rotated, light comes from phi
// 180 and the mirror direction is at phi 0. Throws InputError for values out of range and for files that
// cannot be read.
io::SampleTable make_grid(const GridOptions& options);

}  // namespace brdf::synth
