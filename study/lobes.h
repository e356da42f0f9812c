// The fitted lobe as a body with the measured rows as dots: drawn by render, none where this build is without
// it.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::study {

struct Lobe {
  double theta_i;   // of the light, degrees
  std::string png;  // a file's bytes
};

// Whether this build draws lobes.
bool has_lobes();

// Under two of the lights that were measured: one at which a lobe is compact, and one at which it is drawn
// out. Precondition: the material's channels are colours.
std::vector<Lobe> lobes_of(const io::SampleTable& samples, const Material& fitted);

}  // namespace brdf::study
