#include "render/viewer/panels.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <utility>

#include "render/viewer/polar_plot.h"

namespace brdf::render {
namespace {

// A slider in double; Ctrl-click puts the default back.
bool slider(const char* label, double& value, double min, double max, double initial, bool logarithmic) {
  float shown = float(value);
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_NoInput |
      (logarithmic && min > 0 ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  const bool moved = ImGui::SliderFloat(label, &shown, float(min), float(max), "%.4g", flags);
  if (ImGui::IsItemHovered() && ImGui::GetIO().KeyCtrl && ImGui::GetIO().MouseDown[0]) {
    value = initial;
    return true;
  }
  if (moved) value = double(shown);
  return moved;
}

bool combo(const char* label, std::size_t& index, const std::vector<std::string>& names) {
  bool changed = false;
  if (!ImGui::BeginCombo(label, names.at(index).c_str())) return false;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (ImGui::Selectable(names[k].c_str(), k == index)) {
      index = k;
      changed = true;
    }
  }
  ImGui::EndCombo();
  return changed;
}

template <class Enum, std::size_t N>
void enum_combo(const char* label, Enum& value, const std::array<const char*, N>& names) {
  std::size_t index = std::size_t(value);
  if (combo(label, index, std::vector<std::string>(names.begin(), names.end()))) value = Enum(index);
}

void form_panel(Term& term) {
  std::vector<std::string> families, forms;
  const FormInfo& now = info(term.form);
  std::size_t family = 0, form = 0;
  for_each_form([&](auto f) {
    const std::string name(info(f).family);
    if (families.empty() || families.back() != name) families.push_back(name);
    if (name == now.family) {
      if (info(f).name == now.name) form = forms.size();
      forms.emplace_back(info(f).name);
    }
  });
  for (std::size_t k = 0; k < families.size(); ++k) {
    if (families[k] == now.family) family = k;
  }
  if (combo("family", family, families))
    switch_form(term, *find_form(families[family]));
  else if (combo("form", form, forms))
    switch_form(term, *find_form(forms[form]));
}

void parameter_sliders(Term& term, const std::vector<std::string>& channels) {
  const FormInfo& form = info(term.form);
  for (std::size_t k = 0; k < form.weights.size(); ++k) {
    const ParameterInfo& p = form.weights[k];
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const std::string label = std::string(p.name) + " " + channels[c];
      slider(label.c_str(), term.weights[c][k], p.min, p.usual_max, p.initial, false);
    }
  }
  for (std::size_t set = 0; set < term.shape.size(); ++set) {
    for (std::size_t k = 0; k < form.shape.size(); ++k) {
      const ParameterInfo& p = form.shape[k];
      std::string label(p.name);
      if (term.shape.size() > 1) label += " " + channels[set];
      slider(label.c_str(), term.shape[set][k], p.min, p.usual_max, p.initial, p.log_scale);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(p.doc).c_str());
    }
  }
  if (!form.anisotropic()) return;
  double degrees = term.tangent_phi * 180 / kPi;
  if (slider("tangent_phi", degrees, -90, 90, 0, false)) term.tangent_phi = degrees * kPi / 180;
}

void material_panel(ViewState& state) {
  Object& object = state.scene.objects[state.selected];
  for (std::size_t t = 0; t < object.material.terms.size(); ++t) {
    ImGui::PushID(int(t));
    if (object.material.terms.size() > 1)
      ImGui::Text("term %d of %d", int(t) + 1, int(object.material.terms.size()));
    form_panel(object.material.terms[t]);
    parameter_sliders(object.material.terms[t], object.material.channels);
    ImGui::PopID();
  }
}

void object_panel(Object& object) {
  ImGui::DragFloat3("position", &object.position.x, 0.02f);
  ImGui::DragFloat3("rotation", &object.rotation.x, 1);
  ImGui::DragFloat3("scale", &object.scale.x, 0.01f, 0.01f, 100);
  for (int k = 0; k < 3; ++k) object.scale[k] = std::abs(object.scale[k]) < 0.01f ? 0.01f : object.scale[k];
}

void light_panel(Scene& scene) {
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    Light& light = scene.lights[k];
    ImGui::PushID(int(k));
    const std::string title =
        std::string(light.point ? "point light " : "directional light ") + std::to_string(k + 1);
    if (ImGui::TreeNodeEx(title.c_str(), k == 0 ? ImGuiTreeNodeFlags_DefaultOpen : 0)) {
      const glm::vec3 before = light.vector;
      ImGui::DragFloat3(light.point ? "position" : "direction", &light.vector.x, 0.02f);
      if (!light.point && !(glm::length(light.vector) > 1e-3f)) light.vector = before;
      ImGui::ColorEdit3("color", &light.color.x, ImGuiColorEditFlags_Float);
      ImGui::DragFloat("intensity", &light.intensity, 0.02f, 0, 1000);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
  if (scene.lights.size() < kMostLights && ImGui::Button("add a point light")) {
    scene.lights.push_back({true, {2, 2, 2}, glm::vec3(1), 3});
  }
  if (!scene.lights.empty()) {
    ImGui::SameLine();
    if (ImGui::Button("remove the last")) scene.lights.pop_back();
  }
  ImGui::ColorEdit3("ambient", &scene.ambient.x, ImGuiColorEditFlags_Float);
}

void display_panel(ViewState& state, const PanelInfo& info) {
  enum_combo("shading", state.scene.shading, kShadingNames);
  if (state.scene.shading != Shading::brdf) {
    ImGui::Checkbox("as coded", &state.scene.as_coded);
    ImGui::SameLine();
    ImGui::Checkbox("per vertex", &state.scene.per_vertex);
  }
  enum_combo("tone map", state.scene.tone_map, kToneMapNames);
  ImGui::SliderFloat("exposure", &state.scene.exposure, -8, 8, "%.2f stops");
  enum_combo("show", state.display, kDisplayNames);
  enum_combo("B is", state.other, kOtherNames);
  if (ImGui::Button("keep this material as B")) {
    state.material = state.scene.objects[state.selected].material;
    state.material_name = state.scene.objects[state.selected].material_name;
    state.other = Other::material;
  }
  if (state.display == Display::split) ImGui::SliderFloat("split at", &state.split, 0, 1);
  const bool compared = state.display == Display::split || state.display == Display::flip ||
                        state.display == Display::difference;
  if (compared && info.pictures->difference()) {
    const Difference& d = *info.pictures->difference();
    ImGui::Text("A against B: relative MSE %.3g, PSNR %.1f dB", d.rel_mse, d.psnr);
  }
  if (state.display == Display::difference)
    ImGui::TextUnformatted("blue 1e-6, green 1e-4, yellow 1e-2, red 1");
}

void probe_panel(const Probe& p) {
  if (!p.hit) {
    ImGui::TextUnformatted("probe: background");
    return;
  }
  const auto degrees = [](float cosine) {
    return double(std::acos(glm::clamp(cosine, -1.0f, 1.0f))) * 180 / kPi;
  };
  const auto azimuth = [](const glm::vec3& w) { return double(std::atan2(w.y, w.x)) * 180 / kPi; };
  const glm::vec3 h = glm::normalize(p.wi + p.wo);
  ImGui::Text("probe: object %d at (%.3f, %.3f, %.3f)", int(p.object) + 1, double(p.position.x),
              double(p.position.y), double(p.position.z));
  ImGui::Text("theta_i %.2f phi_i %.2f, theta_o %.2f phi_o %.2f deg", degrees(p.wi.z), azimuth(p.wi),
              degrees(p.wo.z), azimuth(p.wo));
  ImGui::Text("theta_h %.2f theta_d %.2f deg", degrees(h.z), degrees(glm::dot(p.wi, h)));
  ImGui::Text("f_r (%.5g, %.5g, %.5g) 1/sr", double(p.value.r), double(p.value.g), double(p.value.b));
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
    for (int k = 0; k < 8; ++k) {
      text(size.x * float(k % 4) / 4 + 6, size.y * float(k / 4 + 1) / 2 - 20,
           k < 7 ? kTargetNames[std::size_t(k)] : "lighting");
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

}  // namespace

void Panels::plot(ViewState& state) {
  ImGui::SetNextWindowPos(ImVec2(ImGui::GetIO().DisplaySize.x - 340, 8), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(332, 300), ImGuiCond_FirstUseEver);
  if (ImGui::Begin("lobes", &state.show_plot)) {
    ImGui::SliderFloat("theta_i", &state.plot_theta, 0, 89, "%.0f deg");
    const Object& object = state.scene.objects[state.selected];
    std::vector<LobeCurve> curves = lobe_curves(object.material, "A", double(state.plot_theta));
    if (state.other == Other::material && state.material) {
      for (LobeCurve& curve : lobe_curves(*state.material, "B", double(state.plot_theta))) {
        curves.push_back(std::move(curve));
      }
    }
    if (state.plot_solo >= int(curves.size())) state.plot_solo = -1;
    ImGui::RadioButton("all", &state.plot_solo, -1);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      ImGui::SameLine();
      ImGui::RadioButton(curves[k].name.c_str(), &state.plot_solo, int(k));
    }
    draw_lobes(curves, state.plot_theta, state.plot_solo, ImGui::GetContentRegionAvail().x);
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
    if (ImGui::CollapsingHeader("material", ImGuiTreeNodeFlags_DefaultOpen)) material_panel(state);
    if (ImGui::CollapsingHeader("picture", ImGuiTreeNodeFlags_DefaultOpen)) display_panel(state, info);
    if (ImGui::CollapsingHeader("lights")) light_panel(state.scene);
    if (ImGui::CollapsingHeader("model")) {
      object_panel(state.scene.objects[state.selected]);
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
    if (info.probe) probe_panel(*info.probe);
    ImGui::TextDisabled("%s", info.device.c_str());
    if (!info.message.empty()) ImGui::TextWrapped("%s", info.message.c_str());
  }
  ImGui::End();
}

PanelRequests Panels::draw(ViewState& state, const PanelInfo& info) {
  PanelRequests requests;
  if (state.show_ui) {
    main_panel(state, info, requests);
    if (state.show_plot) plot(state);
    labels(state, info);
  }
  file_prompt(requests);
  return requests;
}

}  // namespace brdf::render
