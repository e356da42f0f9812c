// Draws the fitted lobe as a body with the measurements as dots. Render does the drawing; a build without
// render draws no lobes.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/page/body.h"
#include "io/samples/samples.h"

namespace brdf::study {

struct Lobe {
  double theta_i;   // angle of incidence, degrees
  double outer;     // f_r of the outer circle, 1/sr: the same for all lobes of a sample
  std::string png;  // the content of the PNG file
  io::Body body;    // the same to turn
};

// Returns whether this build draws lobes.
bool has_lobes();

// Draws the lobe for the measured angles of incidence nearest to 30 degrees, at which a lobe is compact,
// and to 65 degrees, at which it is elongated. If both are the same angle, there is one picture. Returns an
// empty vector in a build without render. Precondition: the material's channels are colours.
std::vector<Lobe> lobes_of(const io::SampleTable& samples, const Material& fitted);

}  // namespace brdf::study
