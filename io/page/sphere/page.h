// Adds an interactive sphere to a report.
#pragma once

#include <string>

#include "io/page/html_report.h"
#include "io/page/sphere/table.h"

namespace brdf::io::sphere {

struct Shown {
  std::string title;  // name of the material or sample
  Material fitted;
  MeasuredPairs measured{};  // empty: only the fitted material
  TableSize table = kIsotropic;
  std::string caption = {};  // whole sentences on the measurement, for example that it is smoothed
  std::string still = {};    // bytes of a PNG file of the ball in the studio; empty: drawn here
};

// Returns the reason that a page cannot show a sphere of a material: its channels are not colours, or a
// reflectance has no GLSL. Returns an empty string if there is no obstacle.
std::string obstacle(const Material& material);

// Adds the fitted material on a sphere in the studio (studio.h) and, if there is a measurement, next to it
// the fitted material, the measurement and their difference under one light. WebGL 2 draws them from the
// formulas of glsl-es. Readers turn the sphere and the light by mouse and keys, and choose the exposure.
// Directions without measurements are hatched. Without WebGL 2 still pictures of the same remain. The report
// grows by 50 to 110 kB (shader 35 to 60 kB, picture 20 to 45 kB), with a measurement by 190 to 300 kB, and
// once by 13 kB (script). Throws InputError if there is an obstacle.
void add(HtmlReport& report, const Shown& shown);

}  // namespace brdf::io::sphere
