// Pictures of a material and of its samples, where this build can draw.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples.h"

namespace brdf::study {

// PNG files' bytes, under the same light; empty where there is none.
struct Spheres {
  std::string measured, fitted, difference;
  std::string small_measured, small_fitted;
  // The fitted lobe as a body with the measured rows as dots, under two of the lights that were measured.
  struct Lobe {
    double theta_i;  // degrees
    std::string png;
  };
  std::vector<Lobe> lobes;
  std::string missing;  // why there are none
};

// Whether this build has the renderer. No driver is needed: these pictures are traced.
bool can_draw();

// What is missing, the renderer or colours, is said in Spheres::missing.
Spheres draw(const io::SampleTable& samples, const Material& fitted);

}  // namespace brdf::study
