#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"

namespace brdf::render {

// One curve of the lobe plot: f_r in the plane of incidence over theta_o from -90 to 90 degrees, one channel.
struct LobeCurve {
  std::string name;
  std::vector<float> values;
};
inline constexpr int kLobePoints = 181;

// A curve per channel.
std::vector<LobeCurve> lobe_curves(const Material& material, const std::string& name, double theta_i_degrees);

// Draws the curves into the current Dear ImGui window; `solo` -1 shows all. The radius is the cube root of
// f_r, so that a narrow lobe leaves the diffuse part visible.
void draw_lobes(const std::vector<LobeCurve>& curves, float theta_i_degrees, int solo, float width);

}  // namespace brdf::render
