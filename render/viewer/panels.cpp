#include "render/viewer/panels.h"
#include "render/viewer/sliders.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

#include "io/files/numbers.h"

namespace brdf::render {
namespace {

constexpr ImGuiWindowFlags kDocked = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                     ImGuiWindowFlags_NoBringToFrontOnFocus;

bool begin_docked(const char* name, const Area& area) {
  ImGui::SetNextWindowPos(ImVec2(area.x, area.y));
  ImGui::SetNextWindowSize(ImVec2(area.width, area.height));
  return ImGui::Begin(name, nullptr, kDocked);
}

// Buttons of commands, as many per line as fit.
class Buttons {
 public:
  Buttons(Session& session, const Whereabouts& where, std::vector<Request>& requests)
      : session_(session), where_(where), requests_(requests) {}

  void add(std::string_view name) { add(name, name); }
  // `words`: the button's text, if it is not the command's name.
  void add(std::string_view name, std::string_view words) {
    const Command& c = command(name);
    const std::string label(words);
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    if (used_ > 0 && used_ + ImGui::GetStyle().ItemSpacing.x + width < ImGui::GetContentRegionAvail().x)
      ImGui::SameLine();
    else
      used_ = 0;
    used_ += width + (used_ > 0 ? ImGui::GetStyle().ItemSpacing.x : 0);
    if (ImGui::Button(label.c_str())) {
      if (c.edit) c.edit(session_, where_);
      if (c.request != Request::none) requests_.push_back(c.request);
    }
    if (ImGui::IsItemHovered())
      ImGui::SetTooltip("%s (%s)", std::string(c.does).c_str(), readable_keys(c).c_str());
  }

 private:
  Session& session_;
  const Whereabouts& where_;
  std::vector<Request>& requests_;
  float used_ = 0;
};

void add_all(Buttons buttons, std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) buttons.add(name);
}

// The presets of light, in two labelled rows.
void light_presets(Buttons soft) {
  Buttons hard = soft;
  ImGui::TextUnformatted("soft light:");
  ImGui::SameLine();
  ImGui::BeginGroup();
  for (const char* name : {"studio", "sky", "uniform"}) soft.add(name);
  ImGui::EndGroup();
  ImGui::TextUnformatted("hard light:");
  ImGui::SameLine();
  ImGui::BeginGroup();
  hard.add("light from the left", "left");
  hard.add("light from the front", "front");
  hard.add("light from behind", "behind");
  ImGui::EndGroup();
}

void picture_section(ViewState& state, const PanelInfo& info) {
  enum_combo("shading", state.scene.shading);
  if (state.scene.shading != Shading::brdf) {
    ImGui::Checkbox("as coded", &state.scene.as_coded);
    ImGui::SameLine();
    ImGui::Checkbox("per vertex", &state.scene.per_vertex);
  }
  enum_combo("tone map", state.scene.tone_map);
  float_slider("exposure", state.scene.exposure, -8, 8, "%.2f stops");
  enum_combo("show", state.display);
  enum_combo("B is", state.other);
  if (state.display == Display::split) float_slider("split at", state.split, 0, 1, "%.3f");
  const bool compared = state.display == Display::split || state.display == Display::flip ||
                        state.display == Display::difference;
  const std::optional<Difference>& d = info.pictures->difference();
  if (compared && d) ImGui::TextWrapped("A against B: relative MSE %.3g, PSNR %.1f dB", d->rel_mse, d->psnr);
  if (compared && d && d->not_measured > 0)
    ImGui::TextWrapped("hatched: not measured, %.0f %%", 100 * d->not_measured);
  if (state.display == Display::difference)
    ImGui::TextWrapped("%s", state.other == Other::samples ? "A darker by 50 % blue, brighter by 50 % red"
                                                           : "blue 1e-6, green 1e-4, yellow 1e-2, red 1");
  if (const std::string note = left_out_note(state); !note.empty()) ImGui::TextWrapped("%s", note.c_str());
}

void fit_section(Session& session, const PanelInfo& info, Buttons buttons) {
  if (info.error) {
    // Always two lines: sliders must not move while one of them is held or a number is typed.
    ImGui::Text("median error at the samples %.2f %%", 100 * *info.error);
    const bool differs = info.error_before && *info.error_before != *info.error;
    ImGui::TextDisabled("%s", differs ? ("before " + io::percent(*info.error_before)).c_str() : " ");
  } else if (session.state().samples.empty()) {
    ImGui::TextDisabled("open samples for a comparison");
  }
  if (!info.can_fit) return;
  if (info.fitting < 0) return buttons.add("fit from here");
  ImGui::Text("fitting, %.1f s", info.fitting);
  buttons.add("stop fitting");
}

void timings(const PanelInfo& info) {
  for (const auto& [name, ms] : info.pictures->times()) ImGui::Text("%s %.2f ms", name.c_str(), ms);
  ImGui::TextDisabled("%s", info.device.c_str());
}

void main_panel(Session& session, const Layout& layout, const PanelInfo& info, const Whereabouts& where,
                std::vector<Request>& requests) {
  ViewState& state = session.state();
  const Buttons buttons(session, where, requests);
  if (begin_docked("panel", layout.panel)) {
    ImGui::PushItemWidth(0.6f * ImGui::GetContentRegionAvail().x);
    add_all(buttons, {"open", "save material", "save state", "picture", "undo", "redo", "revert", "help"});
    if (state.scene.objects.size() > 1) {
      std::vector<std::string> names;
      for (std::size_t k = 0; k < state.scene.objects.size(); ++k)
        names.push_back(object_name(state.scene.objects[k], k));
      combo("object", state.selected, names);
    }
    constexpr ImGuiTreeNodeFlags kOpen = ImGuiTreeNodeFlags_DefaultOpen;
    if (layout.plot_in_panel && ImGui::CollapsingHeader("lobes", kOpen)) plot_panel(session, info, false);
    if (ImGui::CollapsingHeader("material", kOpen)) {
      fit_section(session, info, buttons);
      edit_material(session, *info.intervals);
    }
    if (ImGui::CollapsingHeader("picture", kOpen)) {
      light_presets(buttons);
      add_all(buttons, {"split", "flip", "difference", "targets", "keep as B", "keep in plot", "lobes"});
      picture_section(state, info);
    }
    if (ImGui::CollapsingHeader("camera", kOpen))
      add_all(buttons, {"home", "frame", "frame selected", "turntable"});
    if (ImGui::CollapsingHeader("lights")) {
      add_all(buttons, {"light follows"});
      if (state.light_follows) ImGui::TextUnformatted("the light follows the camera");
      edit_lights(state.scene);
    }
    if (ImGui::CollapsingHeader("object")) edit_object(state.scene.objects[state.selected]);
    if (ImGui::CollapsingHeader("timings")) timings(info);
    ImGui::PopItemWidth();
  }
  ImGui::End();
}

void help_overlay(bool& wanted) {
  constexpr const char* kName = "help";
  if (std::exchange(wanted, false)) ImGui::OpenPopup(kName);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(size.x / 2, size.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(size.x, size.y));
  if (!ImGui::BeginPopup(kName)) return;
  ImGui::TextDisabled("Esc closes");
  std::string group;
  if (ImGui::BeginTable("commands", 3, ImGuiTableFlags_SizingFixedFit)) {
    for (const Command& c : commands()) {
      ImGui::TableNextRow();
      if (group != c.group) {
        group = c.group;
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", group.c_str());
        ImGui::TableNextRow();
      }
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(readable_keys(c).c_str());
      for (const std::string_view words : {c.name, c.does}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(words.data(), words.data() + words.size());
      }
    }
    ImGui::EndTable();
  }
  ImGui::EndPopup();
}

}  // namespace

bool Panels::dismiss() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.OpenPopupStack.Size == 0) return std::exchange(help_, false);
  ImGui::ClosePopupToLevel(context.OpenPopupStack.Size - 1, true);
  return true;
}

std::vector<Request> Panels::draw(Session& session, const Layout& layout, const PanelInfo& info,
                                  const Whereabouts& where) {
  std::vector<Request> requests;
  if (session.state().show_ui) {
    main_panel(session, layout, info, where, requests);
    if (layout.plot.width > 0) {
      if (begin_docked("plot", layout.plot)) plot_panel(session, info, true);
      ImGui::End();
    }
  }
  picture_lines(session, layout, info);
  help_overlay(help_);
  return requests;
}

}  // namespace brdf::render
