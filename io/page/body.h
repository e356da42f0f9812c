// A body over the hemisphere of directions, which readers of a page turn. The radius shows a value.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace brdf::io {

// Directions have polar angles from the normal and azimuths in degrees. Ring k has the polar angle
// k * reach / (rings - 1), and sector j has the azimuth 360 j / sectors. All radii are in [0, 1].
struct Body {
  struct Point {
    double radius = 0;
    std::array<unsigned char, 3> colour{};  // before the shading
  };
  struct Dot {
    double theta = 0, phi = 0, radius = 0;  // theta in [0, 90]
  };
  int rings = 0, sectors = 0;
  double reach = 90;
  std::vector<Point> points;  // ring by ring
  std::vector<Dot> dots;
  double theta_i = 0;                                 // of the light, at azimuth 180
  std::array<unsigned char, 3> dot_colour{};          // of all dots
  std::array<unsigned char, 3> line_colours[3] = {};  // of the ground, the light and the mirror direction
  std::array<unsigned char, 3> background{};
  double turn = 0, above = 0;  // of the first view, degrees
};

// Returns the body as one line of JSON for io/page/body.js: radii have 8 bits, dots 16 bits per coordinate.
std::string body_json(const Body& body);

}  // namespace brdf::io
