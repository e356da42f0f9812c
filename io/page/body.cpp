#include "io/page/body.h"

#include <algorithm>
#include <cmath>

#include "io/files/base64.h"
#include "io/files/json.h"

namespace brdf::io {
namespace {

// Adds a share of the whole, in [0, 1], as two bytes, the low one first.
void add_share(std::string& bytes, double share) {
  const auto whole = unsigned(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
  bytes += char(whole & 255);
  bytes += char(whole >> 8);
}

double whole_turn(double degrees) {
  const double rest = std::fmod(degrees, 360);
  return rest < 0 ? rest + 360 : rest;
}

}  // namespace

std::string body_json(const Body& body) {
  std::string points, dots;
  for (const Body::Point& p : body.points) {
    points += char(std::lround(255 * std::clamp(p.radius, 0.0, 1.0)));
    for (const unsigned char channel : p.colour) points += char(channel);
  }
  for (const Body::Dot& d : body.dots) {
    add_share(dots, d.theta / 90);
    add_share(dots, whole_turn(d.phi) / 360);
    add_share(dots, d.radius);
  }
  return to_line({{"rings", body.rings},
                  {"sectors", body.sectors},
                  {"reach", body.reach},
                  {"light", body.theta_i},
                  {"view", {body.turn, body.above}},
                  {"colours",
                   {{"background", body.background},
                    {"ground", body.line_colours[0]},
                    {"light", body.line_colours[1]},
                    {"mirror", body.line_colours[2]},
                    {"dots", body.dot_colour}}},
                  {"points", base64(points)},
                  {"dots", base64(dots)}});
}

}  // namespace brdf::io
