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
  std::string still = {};  // bytes of a PNG file for browsers without WebGL 2; empty: drawn here
};

// Returns the reason that a page cannot show a sphere of a material: its channels are not colours, or a
// reflectance has no GLSL. Returns an empty string if there is no obstacle.
std::string obstacle(const Material& material);

// Adds the fitted material, the measurement and their difference on a sphere under one light. WebGL 2 draws
// them from the formulas of glsl-es. Readers turn the sphere and the light by mouse and keys, and choose
// the exposure. Directions without measurements are hatched. Without WebGL 2 a still picture of the same
// remains. The report grows by 30 to 57 kB (shader and picture), with a measurement by 150 to 215 kB, and
// once by 10 kB (script). Throws InputError if there is an obstacle.
void add(HtmlReport& report, const Shown& shown);

}  // namespace brdf::io::sphere
