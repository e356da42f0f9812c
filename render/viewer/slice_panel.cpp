// The panels on samples: the slice through the plane of incidence, and the map of residuals.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "io/files/numbers.h"
#include "measured/residual_map.h"
#include "render/compare/lobe_points.h"
#include "render/compare/slice_plot.h"
#include "render/viewer/panels.h"
#include "render/viewer/plot_drawing.h"

namespace brdf::render {
namespace {

// kHigh: the height of a slice over its width; kLowest: the least height of a map over its width
constexpr float kHigh = 0.42f, kLowest = 0.5f;
constexpr double kMostRange = 0.5;  // of the map of residuals
constexpr ImU32 kEmpty = IM_COL32(45, 45, 50, 255);

// An area for a drawing, with its corner at the lower left.
struct Field {
  ImVec2 corner;
  float width, height;

  Field(float wide, float high) : width(wide - 2), height(high) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(wide, high + 2));
    corner = ImVec2(at.x + 1, at.y + 1 + high);
  }
  ImVec2 place(const glm::vec2& p) const { return {corner.x + width * p.x, corner.y - height * p.y}; }
};

// Writes words at both ends of a line.
void ends(const std::string& left, const std::string& right) {
  ImGui::TextDisabled("%s", left.c_str());
  ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(right.c_str()).x);
  ImGui::TextDisabled("%s", right.c_str());
}

// `range`: the difference at the ends of the scale, which signed_color() has at kMostSigned.
ImU32 residual_color(double log_ratio, double range) {
  const glm::vec3 c = signed_color(float(std::expm1(log_ratio) / range) * kMostSigned);
  return ImGui::ColorConvertFloat4ToU32(ImVec4(c.x, c.y, c.z, 1));
}

}  // namespace

void slice_section(Session& session, const PanelInfo& info) {
  const ViewState& state = session.state();
  const double theta = nearest_light(*info.samples, double(state.plot_theta));
  if (std::isnan(theta)) return;
  const SlicePlot plot =
      slice_plot(lobe_curves(state, theta), state.plot_solo, lobe_dots(*info.samples, theta));
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::TextWrapped("incidence %s°, f_r from 1e%d to 1e%d 1/sr", io::short_number(theta, 3).c_str(),
                     plot.low, plot.high);
  const Field field(width, kHigh * width);
  draw_plot(plot, 2, [&](const glm::vec2& p) { return field.place(p); });
  ends("-90°", "viewing angle 90°");
}

double residual_range(const std::vector<double>& cells) {
  std::vector<double> sizes;
  for (const double cell : cells)
    if (!std::isnan(cell)) sizes.push_back(std::abs(std::expm1(cell)));
  if (sizes.empty()) return kMostRange;
  const std::size_t place = sizes.size() * 19 / 20;
  std::nth_element(sizes.begin(), sizes.begin() + std::ptrdiff_t(place), sizes.end());
  for (const double step : {0.01, 0.02, 0.05, 0.1, 0.2})
    if (sizes[place] <= step) return step;
  return kMostRange;
}

void residual_section(const std::vector<double>& cells) {
  constexpr std::size_t kCells = measured::ResidualMap::kCells;
  const double range = residual_range(cells);
  const std::string most = io::percent(range);
  ImGui::TextWrapped("blue: A darker by %s or more, red: brighter", most.c_str());
  const float width = ImGui::GetContentRegionAvail().x;
  const float room = ImGui::GetContentRegionAvail().y - ImGui::GetTextLineHeightWithSpacing() - 8;
  const Field field(width, std::clamp(room, kLowest * width, width));
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(field.place({0, 1}), field.place({1, 0}), kEmpty);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (std::isnan(cells[k])) continue;
    const float x = float(k % kCells) / kCells, y = float(k / kCells) / kCells, step = 1.0f / kCells;
    list->AddRectFilled(field.place({x, y + step}), field.place({x + step, y}),
                        residual_color(cells[k], range));
  }
  ends("theta_h from 0°", "to 90°, theta_d upwards");
}

}  // namespace brdf::render
