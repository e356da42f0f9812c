#include "render/viewer/polar_plot.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdf::render {

std::vector<LobeCurve> lobe_curves(const Material& material, const std::string& name,
                                   double theta_i_degrees) {
  const std::size_t channels = material.channels.size();
  std::vector<LobeCurve> curves(channels);
  std::vector<double> f(channels);
  const Vec3<double> wi = direction(theta_i_degrees * kPi / 180, 0);
  for (int k = 0; k < kLobePoints; ++k) {
    // The mirror side (azimuth 180 degrees) is positive.
    const double theta = (k - 90) * kPi / 180;
    eval(material, wi, direction(std::abs(theta), theta > 0 ? kPi : 0), f);
    for (std::size_t c = 0; c < channels; ++c) curves[c].values.push_back(float(f[c]));
  }
  for (std::size_t c = 0; c < channels; ++c) curves[c].name = name + " " + material.channels[c];
  return curves;
}

void draw_lobes(const std::vector<LobeCurve>& curves, float theta_i_degrees, int solo, float width) {
  constexpr std::array kColors{IM_COL32(230, 80, 70, 255),   IM_COL32(90, 200, 90, 255),
                               IM_COL32(90, 140, 255, 255),  IM_COL32(255, 170, 150, 255),
                               IM_COL32(170, 240, 170, 255), IM_COL32(170, 200, 255, 255)};
  const float radius = width / 2 - 4;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 origin(corner.x + width / 2, corner.y + radius + 4);
  ImGui::Dummy(ImVec2(width, radius + 8));
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 grid = IM_COL32(120, 120, 120, 160);
  list->PathArcTo(origin, radius, float(kPi), float(2 * kPi), 48);
  list->PathStroke(grid, 0);
  list->AddLine(ImVec2(origin.x - radius, origin.y), ImVec2(origin.x + radius, origin.y), grid);
  list->AddLine(origin, ImVec2(origin.x, origin.y - radius), grid);
  const float incidence = theta_i_degrees * float(kPi) / 180;
  list->AddLine(origin,
                ImVec2(origin.x - radius * std::sin(incidence), origin.y - radius * std::cos(incidence)),
                IM_COL32(255, 220, 120, 255));
  float largest = 1e-6f;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (solo >= 0 && std::size_t(solo) != c) continue;
    for (const float f : curves[c].values) largest = std::max(largest, f);
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (solo >= 0 && std::size_t(solo) != c) continue;
    for (int k = 0; k < kLobePoints; ++k) {
      const float angle = float(k - 90) * float(kPi) / 180;
      const float r = radius * std::cbrt(std::max(0.0f, curves[c].values[std::size_t(k)]) / largest);
      list->PathLineTo(ImVec2(origin.x + r * std::sin(angle), origin.y - r * std::cos(angle)));
    }
    list->PathStroke(kColors[c % kColors.size()], 0, 1.5f);
  }
  ImGui::Text("largest f_r %.4g 1/sr (radius: cube root)", double(largest));
}

}  // namespace brdf::render
