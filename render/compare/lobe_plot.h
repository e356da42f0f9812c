// The polar plot of a material's lobe in the plane of incidence, for the viewer and for a PNG.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "render/compare/state.h"
#include "render/picture/canvas.h"

namespace brdf::render {

// f_r in the plane of incidence over theta_o from -89 to 89 degrees (mirror side positive), one channel.
// Forms that diverge at 90 degrees would show nothing else there.
struct LobeCurve {
  std::string name;
  std::string channel;
  std::vector<float> values;
  ByteColor color{};
};
inline constexpr int kSteepest = 89, kLobePoints = 2 * kSteepest + 1;

// A curve per channel, in the shades of the first (A) or the second (B) material.
std::vector<LobeCurve> lobe_curves(const Material& material, const std::string& name, double theta_i_degrees,
                                   bool second = false);

// Of the selected object's material, of B where it is a material, and of those that are kept.
std::vector<LobeCurve> lobe_curves(const ViewState& state);
// The same of another light.
std::vector<LobeCurve> lobe_curves(const ViewState& state, double theta_i_degrees);

// A measured value in the plane of incidence, by the name of its curve's channel.
struct LobeDot {
  double theta_o;  // degrees, mirror side positive
  float value;     // f_r
  std::string channel;
  ByteColor color;
};

// The rows of a table near the plane of incidence (lobe_points.h), in the colours of the first material's
// channels.
std::vector<LobeDot> lobe_dots(const io::SampleTable& table, double theta_i_degrees);

// Whether the choice of one curve (-1: all) shows this curve; and this dot, which is one of its channel.
bool is_shown(int solo, std::size_t curve);
bool is_shown(int solo, const LobeDot& dot, const std::vector<LobeCurve>& curves);

// The plot as lines in the half disc of radius 1 round (0, 0), y upwards: grid, direction of the light,
// curves. The radius is the cube root of f_r over the largest one, so that a narrow lobe leaves the diffuse
// part visible. `solo` -1 shows all curves.
struct LobePath {
  std::vector<glm::vec2> points;
  ByteColor color;
  float width;  // pixels
};
struct LobePlot {
  std::vector<LobePath> paths;
  struct Dot {
    glm::vec2 at;
    ByteColor color;
  };
  std::vector<Dot> dots;
  float largest = 0;  // f_r at radius 1
};
// Of a curve shown alone: the dots of its channel.
LobePlot lobe_plot(const std::vector<LobeCurve>& curves, double theta_i_degrees, int solo,
                   const std::vector<LobeDot>& dots = {});

// The plot as a picture, with angles, values and the curves' names; and what the dots are.
BytePicture lobe_picture(const std::vector<LobeCurve>& curves, double theta_i_degrees, int solo, int width,
                         const std::vector<LobeDot>& dots = {});

}  // namespace brdf::render
