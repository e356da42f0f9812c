// A sphere that a reader turns: the block of a report.
#pragma once

#include <string>

#include "io/page/html_report.h"
#include "io/page/sphere/table.h"

namespace brdf::io::sphere {

struct Shown {
  std::string title;  // of what is shown: a material's or a sample's name
  Material fitted;
  MeasuredPairs measured{};  // empty: the fitted one alone
  TableSize table = kIsotropic;
  std::string still = {};  // a PNG file's bytes: the picture for where nothing turns; empty: drawn here
};

// Why a page can have no sphere of a material: channels that are no colours, or a reflectance without GLSL;
// empty where it can.
std::string obstacle(const Material& material);

// Fitted, measured and their difference on a sphere under one light: drawn by WebGL 2 from the formulas of
// glsl-es, turned by mouse and keys, the light too, with an exposure. What was not measured is hatched.
// Without WebGL 2 a picture of the same stays. Adds 30 to 57 kB (shader and picture), with a measurement 150
// to 215 kB; 10 kB once (script). Throws InputError where there is an obstacle.
void add(HtmlReport& report, const Shown& shown);

}  // namespace brdf::io::sphere
