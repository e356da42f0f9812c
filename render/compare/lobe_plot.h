// The polar plot of a material's lobe in the plane of incidence, for the viewer and for a PNG.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "render/compare/state.h"
#include "render/picture/canvas.h"

namespace brdf::render {

// f_r of one channel in the plane of incidence, for theta_o from -89 to 89 degrees (the mirror side is
// positive). The range ends at 89 degrees because a form that diverges at 90 degrees would dwarf all other
// values of the plot.
struct LobeCurve {
  std::string name;
  std::string channel;
  std::vector<float> values;
  ByteColor color{};
};
inline constexpr int kSteepest = 89, kLobePoints = 2 * kSteepest + 1;

// Returns a curve per channel, in the shades of the first (A) or the second (B) material.
std::vector<LobeCurve> lobe_curves(const Material& material, const std::string& name, double theta_i_degrees,
                                   bool second = false);

// Returns the curves of the selected object's material, of B if B is a material, and of the kept materials.
std::vector<LobeCurve> lobe_curves(const ViewState& state);
// Returns the same for another light, theta_i_degrees from the normal.
std::vector<LobeCurve> lobe_curves(const ViewState& state, double theta_i_degrees);

// A measured value in the plane of incidence, with the name of its channel.
struct LobeDot {
  double theta_o;  // degrees, the mirror side is positive
  float value;     // f_r
  std::string channel;
  ByteColor color;
};

// Returns the rows of a table near the plane of incidence (lobe_points.h), in the colours of the first
// material's channels.
std::vector<LobeDot> lobe_dots(const io::SampleTable& table, double theta_i_degrees);

// Returns whether this curve is shown if `solo` selects one curve (-1: all); the second form: whether this
// dot is shown, which requires that it belongs to the channel of the selected curve.
bool is_shown(int solo, std::size_t curve);
bool is_shown(int solo, const LobeDot& dot, const std::vector<LobeCurve>& curves);

// The plot as lines in the half disc of radius 1 round (0, 0), y upwards: grid, direction of the light,
// curves. The radius is the cube root of f_r over the largest f_r, so that a narrow lobe leaves the diffuse
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
// Returns the plot. If a single curve is shown, only the dots of its channel are included.
LobePlot lobe_plot(const std::vector<LobeCurve>& curves, double theta_i_degrees, int solo,
                   const std::vector<LobeDot>& dots = {});

// Returns the plot as a picture with angles, values, the names of the curves, and a legend of the dots.
BytePicture lobe_picture(const std::vector<LobeCurve>& curves, double theta_i_degrees, int solo, int width,
                         const std::vector<LobeDot>& dots = {});

}  // namespace brdf::render
