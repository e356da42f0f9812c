// Where a goniophotometer measures.
#pragma once

#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::synth {

struct GridOptions {
  // in_plane    detector in the plane of incidence, -85..85 degrees
  // hemisphere  the whole hemisphere of the detector
  // merl        the centres of the 90 x 90 x 180 half-difference cells of the MERL files
  // anything else: a CSV file with the four angles
  std::vector<std::string> parts = {"hemisphere"};
  std::vector<double> theta_i;  // incidences of in_plane and hemisphere in degrees; empty: each grid's own
  double step = 0;              // detector step of in_plane and hemisphere in degrees; 0: 1 and 5
  std::vector<double> azimuths = {0};  // the sample is turned by each of these (degrees) and measured again
  double blind_zone = 0;               // detector and source collide closer than this, degrees
};

// The directions alone (a table without channels). Light comes from phi 180, the mirror direction is at phi
// 0, before the sample is turned. Throws InputError on values out of range and unreadable files.
io::SampleTable make_grid(const GridOptions& options);

}  // namespace brdf::synth
