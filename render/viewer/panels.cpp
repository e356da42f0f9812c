#include "render/viewer/panels.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <utility>

#include "io/in_plane.h"
#include "render/compare/lobe_plot.h"
#include "render/compare/lobe_points.h"
#include "render/viewer/editors.h"

namespace brdf::render {
namespace {

void display_panel(ViewState& state, const PanelInfo& info) {
  enum_combo("shading", state.scene.shading);
  if (state.scene.shading != Shading::brdf) {
    ImGui::Checkbox("as coded", &state.scene.as_coded);
    ImGui::SameLine();
    ImGui::Checkbox("per vertex", &state.scene.per_vertex);
  }
  enum_combo("tone map", state.scene.tone_map);
  ImGui::SliderFloat("exposure", &state.scene.exposure, -8, 8, "%.2f stops");
  enum_combo("show", state.display);
  enum_combo("B is", state.other);
  if (ImGui::Button("keep this material as B")) {
    state.material = state.scene.objects[state.selected].material;
    state.material_name = state.scene.objects[state.selected].material_name;
    state.other = Other::material;
    state.everywhere = false;
  }
  if (state.display == Display::split) ImGui::SliderFloat("split at", &state.split, 0, 1);
  const bool compared = state.display == Display::split || state.display == Display::flip ||
                        state.display == Display::difference;
  if (compared && info.pictures->difference()) {
    const Difference& d = *info.pictures->difference();
    ImGui::Text("A against B: relative MSE %.3g, PSNR %.1f dB", d.rel_mse, d.psnr);
  }
  if (compared && info.pictures->difference() && info.pictures->difference()->not_measured > 0)
    ImGui::Text("hatched: not measured, %.0f %%", 100 * info.pictures->difference()->not_measured);
  if (state.display == Display::difference)
    ImGui::TextUnformatted(state.other == Other::samples ? "A darker by 50 % blue, brighter by 50 % red"
                                                         : "blue 1e-6, green 1e-4, yellow 1e-2, red 1");
  if (const std::string note = left_out_note(state); !note.empty()) ImGui::TextWrapped("%s", note.c_str());
}

// Cell names of the seven targets and the two sides' labels, over the picture.
void labels(const ViewState& state, const PanelInfo& info) {
  ImDrawList* list = ImGui::GetForegroundDrawList();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const auto text = [&](float x, float y, const std::string& words) {
    list->AddText(ImVec2(x + 1, y + 1), IM_COL32(0, 0, 0, 255), words.c_str());
    list->AddText(ImVec2(x, y), IM_COL32(255, 255, 255, 255), words.c_str());
  };
  const std::string a = "A: " + state.scene.objects[state.selected].material_name,
                    b = "B: " + info.pictures->other_name(state);
  if (state.display == Display::gbuffer) {
    for (int k = 0; k <= kTargetCount; ++k) {
      text(size.x * float(k % 4) / 4 + 6, size.y * float(k / 4 + 1) / 2 - 20,
           k < kTargetCount ? std::string(name_of(Target(k))) : "lighting");
    }
  } else if (state.display == Display::split) {
    text(size.x * state.split - ImGui::CalcTextSize(a.c_str()).x - 8, size.y - 24, a);
    text(size.x * state.split + 8, size.y - 24, b);
  } else if (state.display == Display::flip) {
    text(size.x / 2, size.y - 24, b);
  }
  char rate[64];
  std::snprintf(rate, sizeof rate, "%.0f frames/s", double(info.frame_rate));
  text(size.x - ImGui::CalcTextSize(rate).x - 8, size.y - 24, rate);
}

ImU32 in_window(const ByteColor& color) {
  return IM_COL32(color[0], color[1], color[2], 255);
}

void draw_lobes(const LobePlot& plot, float width) {
  const float radius = width / 2 - 4;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::Dummy(ImVec2(width, radius + 8));
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const LobePath& path : plot.paths) {
    for (const glm::vec2& p : path.points) {
      list->PathLineTo(ImVec2(corner.x + width / 2 + radius * p.x, corner.y + radius + 4 - radius * p.y));
    }
    list->PathStroke(in_window(path.color), 0, path.width);
  }
  for (const LobePlot::Dot& dot : plot.dots) {
    const ImVec2 at(corner.x + width / 2 + radius * dot.at.x, corner.y + radius + 4 - radius * dot.at.y);
    list->AddCircleFilled(at, 3.5f, IM_COL32(15, 15, 18, 255));
    list->AddCircleFilled(at, 2.5f, in_window(dot.color));
  }
  ImGui::Text("largest f_r %.4g 1/sr (radius: cube root)", double(plot.largest));
}

}  // namespace

void Panels::plot(ViewState& state, const io::SampleTable* samples) {
  ImGui::SetNextWindowPos(ImVec2(ImGui::GetIO().DisplaySize.x - 340, 8), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(332, 300), ImGuiCond_FirstUseEver);
  if (ImGui::Begin("lobes", &state.show_plot)) {
    ImGui::SliderFloat("theta_i", &state.plot_theta, 0, 89, "%.0f deg");
    const std::vector<LobeCurve> curves = lobe_curves(state);
    if (state.plot_solo >= int(curves.size())) state.plot_solo = -1;
    ImGui::RadioButton("all", &state.plot_solo, -1);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (k != 3) ImGui::SameLine();  // A's channels, then B's
      ImGui::RadioButton(curves[k].name.c_str(), &state.plot_solo, int(k));
    }
    const std::vector<LobeDot> dots =
        samples ? lobe_dots(*samples, double(state.plot_theta)) : std::vector<LobeDot>{};
    draw_lobes(lobe_plot(curves, double(state.plot_theta), state.plot_solo, dots),
               ImGui::GetContentRegionAvail().x);
    if (!dots.empty()) {
      ImGui::Text("dots: measured, within %.1f deg of the plane", io::kInPlane);
    } else if (samples) {
      ImGui::Text("nothing measured within %.0f deg of this light", kNearLight);
      ImGui::SameLine();
      if (ImGui::SmallButton("nearest"))
        state.plot_theta = float(nearest_light(*samples, double(state.plot_theta)));
    }
  }
  ImGui::End();
}

void Panels::file_prompt(PanelRequests& requests) {
  if (open_prompt_) {
    ImGui::OpenPopup("open a file");
    file_name_.assign(1024, '\0');
  }
  const bool accepted = std::exchange(accept_, false);
  if (!ImGui::BeginPopup("open a file")) return;
  ImGui::TextUnformatted("scene, material, samples, model or saved state");
  if (open_prompt_) ImGui::SetKeyboardFocusHere();
  open_prompt_ = false;
  const bool entered =
      ImGui::InputText("##file", file_name_.data(), file_name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
  if (entered || accepted) {
    requests.open = file_name_.c_str();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void Panels::main_panel(ViewState& state, const PanelInfo& info, PanelRequests& requests) {
  ImGui::SetNextWindowPos(ImVec2(8, 8), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(330, 620), ImGuiCond_FirstUseEver);
  if (ImGui::Begin("brdf")) {
    if (state.scene.objects.size() > 1) {
      std::vector<std::string> names;
      for (std::size_t k = 0; k < state.scene.objects.size(); ++k) {
        names.push_back(std::to_string(k + 1) + " " + state.scene.objects[k].material_name);
      }
      combo("object", state.selected, names);
    }
    if (ImGui::CollapsingHeader("material", ImGuiTreeNodeFlags_DefaultOpen))
      edit_material(state.scene.objects[state.selected].material);
    if (ImGui::CollapsingHeader("picture", ImGuiTreeNodeFlags_DefaultOpen)) display_panel(state, info);
    if (ImGui::CollapsingHeader("lights")) edit_lights(state.scene);
    if (ImGui::CollapsingHeader("model")) {
      edit_object(state.scene.objects[state.selected]);
      ImGui::Checkbox("turntable", &state.turntable);
    }
    if (ImGui::Button("reset")) requests.reset_camera = true;
    ImGui::SameLine();
    if (ImGui::Button("fit")) requests.fit_camera = true;
    ImGui::SameLine();
    if (ImGui::Button("lobes")) state.show_plot = !state.show_plot;
    ImGui::SameLine();
    if (ImGui::Button("open")) open_prompt_ = true;
    ImGui::SameLine();
    if (ImGui::Button("screenshot")) requests.screenshot = true;
    if (ImGui::Button("save state")) requests.save = true;
    ImGui::SameLine();
    if (ImGui::Button("load state")) requests.load = true;
    for (const auto& [name, ms] : info.pictures->times()) ImGui::Text("%s %.2f ms", name.c_str(), ms);
    if (info.pictures->samples_drawn() > 0) {
      const std::string samples = std::to_string(info.pictures->samples_drawn()) + " samples per pixel";
      if (info.pictures->noise() < 0)
        ImGui::TextUnformatted(samples.c_str());
      else
        ImGui::Text("%s, noise at most %.2f %%", samples.c_str(), 100 * info.pictures->noise());
    }
    if (info.probe) {
      for (const std::string& line : lines(*info.probe)) ImGui::TextUnformatted(line.c_str());
    }
    ImGui::TextDisabled("%s", info.device.c_str());
    if (!info.message.empty()) ImGui::TextWrapped("%s", info.message.c_str());
  }
  ImGui::End();
}

PanelRequests Panels::draw(ViewState& state, const PanelInfo& info) {
  PanelRequests requests;
  if (state.show_ui) {
    main_panel(state, info, requests);
    if (state.show_plot) plot(state, state.other == Other::samples ? info.pictures->samples() : nullptr);
    labels(state, info);
  }
  file_prompt(requests);
  return requests;
}

}  // namespace brdf::render
