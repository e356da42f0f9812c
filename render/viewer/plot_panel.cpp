// Draws the plot of the lobes and the sections on samples.
#include <imgui.h>

#include "io/files/numbers.h"
#include "io/samples/in_plane.h"
#include "render/compare/lobe_plot.h"
#include "render/compare/lobe_points.h"
#include "render/viewer/panels.h"
#include "render/viewer/plot_drawing.h"
#include "render/viewer/sliders.h"

namespace brdf::render {
namespace {

void draw_lobes(const LobePlot& plot, float width) {
  const float radius = width / 2 - 4;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy(ImVec2(width, radius + 8));
  const auto place = [&](const glm::vec2& p) {
    return ImVec2(corner.x + width / 2 + radius * p.x, corner.y + radius + 4 - radius * p.y);
  };
  draw_plot(plot, 2.5f, place);
  ImGui::TextWrapped("largest f_r %s 1/sr (radius: cube root of f_r)",
                     io::short_number(double(plot.largest), 4).c_str());
}

void choose_curve(ViewState& state, const std::vector<LobeCurve>& curves) {
  if (state.plot_solo >= int(curves.size())) state.plot_solo = -1;
  ImGui::RadioButton("all", &state.plot_solo, -1);
  const float end = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const float width = ImGui::CalcTextSize(curves[k].name.c_str()).x + 2 * ImGui::GetFrameHeight();
    if (ImGui::GetItemRectMax().x + width < end) ImGui::SameLine();
    ImGui::PushID(int(k));
    ImGui::PushStyleColor(ImGuiCol_Text, in_window(curves[k].color));
    ImGui::RadioButton(curves[k].name.c_str(), &state.plot_solo, int(k));
    ImGui::PopStyleColor();
    ImGui::PopID();
  }
}

}  // namespace

void plot_panel(Session& session, const PanelInfo& info, bool room) {
  ViewState& state = session.state();
  float_slider("theta_i", state.plot_theta, 0, 89, "%.0f°");
  const std::vector<LobeCurve> curves = lobe_curves(state);
  choose_curve(state, curves);
  const auto theta = double(state.plot_theta);
  const std::vector<LobeDot> dots = info.samples ? lobe_dots(*info.samples, theta) : std::vector<LobeDot>{};
  draw_lobes(lobe_plot(curves, theta, state.plot_solo, dots), ImGui::GetContentRegionAvail().x);
  if (!state.kept.empty() && ImGui::SmallButton("remove the last kept")) state.kept.pop_back();
  if (!dots.empty()) {
    ImGui::TextWrapped("dots: measurements within %.1f° of the plane", io::kInPlane);
  } else if (info.samples) {
    ImGui::TextWrapped("no measurements within %.0f° of this incidence", kNearLight);
    if (ImGui::SmallButton("nearest")) state.plot_theta = float(nearest_light(*info.samples, theta));
  }
  const ImGuiTreeNodeFlags open = room ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None;
  if (info.samples && ImGui::CollapsingHeader("slice", open)) slice_section(session, info);
  if (info.residuals && ImGui::CollapsingHeader("residuals", open)) residual_section(*info.residuals);
}

}  // namespace brdf::render
