#include "render/viewer/editors.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "render/compare/state.h"

namespace brdf::render {

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

// The families of the catalogue and the forms of the term's own; what is not in the catalogue is a family of one.
void form_panel(Term& term) {
  std::vector<std::vector<Reflectance>> groups = families();
  if (catalogue_index(term.form) < 0) groups.push_back({term.form});
  std::vector<std::string> names, forms;
  std::size_t family = 0, form = 0;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    names.emplace_back(info(groups[k].front()).family);
    const auto own = std::find(groups[k].begin(), groups[k].end(), term.form);
    if (own == groups[k].end()) continue;
    family = k;
    form = std::size_t(own - groups[k].begin());
  }
  for (const Reflectance& f : groups[family]) forms.emplace_back(info(f).name);
  if (combo("family", family, names))
    switch_form(term, groups[family].front());
  else if (combo("form", form, forms))
    switch_form(term, groups[family][form]);
}

void parameter_sliders(Term& term, const std::vector<std::string>& channels) {
  const ReflectanceInfo& form = info(term.form);
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
  double in_degrees = term.tangent_phi.degrees();
  if (slider("tangent_phi", in_degrees, -90, 90, 0, false)) term.tangent_phi = degrees(in_degrees);
}

}  // namespace

void edit_material(Material& material) {
  for (std::size_t t = 0; t < material.terms.size(); ++t) {
    ImGui::PushID(int(t));
    if (material.terms.size() > 1) ImGui::Text("term %d of %d", int(t) + 1, int(material.terms.size()));
    form_panel(material.terms[t]);
    parameter_sliders(material.terms[t], material.channels);
    ImGui::PopID();
  }
}

void edit_object(Object& object) {
  ImGui::DragFloat3("position", &object.position.x, 0.02f);
  ImGui::DragFloat3("rotation", &object.rotation.x, 1);
  ImGui::DragFloat3("scale", &object.scale.x, 0.01f, 0.01f, 100);
  for (int k = 0; k < 3; ++k) object.scale[k] = std::abs(object.scale[k]) < 0.01f ? 0.01f : object.scale[k];
}

void edit_lights(Scene& scene) {
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

}  // namespace brdf::render
