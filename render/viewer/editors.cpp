#include "render/viewer/editors.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/colour/channel_colours.h"
#include "io/page/glossary.h"
#include "render/gpu/reflectance_glsl.h"
#include "render/viewer/sliders.h"

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

// Shows the families of the catalogue and the forms of the term's family. A form outside the catalogue is a
// family of one.
void form_panel(Session& session, std::size_t place) {
  const Term& term = session.state().scene.objects[session.state().selected].material.terms[place];
  std::vector<std::vector<Reflectance>> groups = families(drawable_forms());
  if (catalogue_index(term.form) < 0) groups.push_back({term.form});
  std::vector<std::string> names, forms;
  std::size_t family = 0, form = 0;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    names.emplace_back(info(groups[k].front()).family);
    const auto own = std::ranges::find(groups[k], term.form);
    if (own == groups[k].end()) continue;
    family = k;
    form = std::size_t(own - groups[k].begin());
  }
  for (const Reflectance& f : groups[family]) forms.emplace_back(info(f).name);
  if (combo("family", family, names))
    session.switch_form(place, groups[family].front());
  else if (combo("form", form, forms))
    session.switch_form(place, groups[family][form]);
}

// Writes for example "diffuse reflectance  kd"; `together`: the name for both axes, "roughness  alpha".
void name_line(const ReflectanceInfo& form, const ParameterInfo& p, bool together = false) {
  const std::string words = io::plain_name(form, p, together), name(together ? form.tied_name() : p.name);
  const std::string plain = words.substr(0, words.find(':'));  // the rest appears in the tooltip
  ImGui::TextUnformatted(plain.empty() ? name.c_str() : plain.c_str());
  if (plain.empty()) return;
  ImGui::SameLine();
  ImGui::TextDisabled("%s", name.c_str());
}

// Draws one swatch for a weight of three channels that are colours, as light of the sRGB primaries.
void swatch(Term& term, std::size_t weight, const ParameterInfo& p,
            const std::vector<std::string>& channels) {
  const auto colours = io::channel_colours(channels);
  if (!colours || channels.size() != 3) return;
  std::array<float, 3> color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = float(term.weights[colours->of[c]][weight]);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * ImGui::GetFrameHeight());
  const std::string label = "##colour of " + std::string(p.name);
  if (!ImGui::ColorEdit3(label.c_str(), color.data(),
                         ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoInputs))
    return;
  for (std::size_t c = 0; c < 3; ++c)
    term.weights[colours->of[c]][weight] = std::clamp(double(color[c]), p.min, p.max);
}

class TermSliders {
 public:
  TermSliders(Session& session, std::size_t place, const std::vector<Interval>& intervals)
      : material_(session.state().scene.objects[session.state().selected].material),
        term_(material_.terms[place]),
        in_file_(session.in_file(place)),
        place_(place),
        intervals_(intervals) {}

  void draw() {
    const ReflectanceInfo& form = info(term_.form);
    for (std::size_t k = 0; k < form.weights.size(); ++k) weight(form, k);
    const bool apart = form.anisotropic() && axes_apart(form);
    for (std::size_t k = 0; k < form.shape.size(); ++k)
      if (apart || int(k) != form.axes().across) shape(form, k, apart);
    if (form.anisotropic()) apart_box(form, apart);
    if (apart) tangent();
  }

 private:
  void weight(const ReflectanceInfo& form, std::size_t k) {
    const ParameterInfo& p = form.weights[k];
    name_line(form, p);
    swatch(term_, k, p, material_.channels);
    for (std::size_t c = 0; c < material_.channels.size(); ++c) {
      ImGui::PushID(int(c));
      ImGui::SetNextItemWidth(-2.5f * ImGui::GetFontSize());
      SliderMarks marks = marks_of(true, k, c);
      if (in_file_) marks.in_file = in_file_->weights[c][k];
      parameter_slider(material_.channels[c] + "##" + std::string(p.name), p, term_.weights[c][k], marks);
      ImGui::PopID();
    }
  }

  // Along and across share one slider while they are equal. Otherwise moving one of them would make an
  // isotropic material anisotropic unintentionally, and a fit that starts from it too.
  bool axes_apart(const ReflectanceInfo& form) const {
    const auto [along, across] = form.axes();
    for (const std::vector<double>& set : term_.shape)
      if (set[std::size_t(along)] != set[std::size_t(across)]) return true;
    return ImGui::GetStateStorage()->GetBool(ImGui::GetID("apart"));
  }

  void apart_box(const ReflectanceInfo& form, bool apart) {
    if (!ImGui::Checkbox("separate along and across", &apart)) return;
    ImGui::GetStateStorage()->SetBool(ImGui::GetID("apart"), apart);
    if (!apart) join_axes(form);
  }

  void join_axes(const ReflectanceInfo& form) {
    const auto [along, across] = form.axes();
    for (std::vector<double>& set : term_.shape) set[std::size_t(across)] = set[std::size_t(along)];
  }

  void shape(const ReflectanceInfo& form, std::size_t k, bool apart) {
    const ParameterInfo& p = form.shape[k];
    const bool together = !apart && int(k) == form.axes().along;
    name_line(form, p, together);
    for (std::size_t set = 0; set < term_.shape.size(); ++set) {
      ImGui::PushID(int(set));
      ImGui::SetNextItemWidth(-2.5f * ImGui::GetFontSize());
      SliderMarks marks = marks_of(false, k, set);
      if (in_file_) marks.in_file = in_file_->shape[set][k];
      const std::string label = term_.shape.size() > 1 ? material_.channels[set] : "";
      if (parameter_slider(label + "##" + std::string(p.name), p, term_.shape[set][k], marks) && together)
        join_axes(form);
      // A slider that is held stays visible, also when it passes the value of the other.
      if (apart && ImGui::IsItemActive()) ImGui::GetStateStorage()->SetBool(ImGui::GetID("apart"), true);
      ImGui::PopID();
    }
  }

  void tangent() {
    constexpr ParameterInfo kTurned{"tangent", -90, 90, 0, 90, "deg", false, "azimuth of the tangent"};
    ImGui::TextUnformatted("rotation, degrees");
    double shown = term_.tangent_phi.degrees();
    SliderMarks marks;
    if (in_file_) marks.in_file = in_file_->tangent_phi.degrees();
    ImGui::SetNextItemWidth(-2.5f * ImGui::GetFontSize());
    if (parameter_slider("##tangent", kTurned, shown, marks)) term_.tangent_phi = degrees(shown);
  }

  SliderMarks marks_of(bool is_weight, std::size_t parameter, std::size_t channel) const {
    SliderMarks marks;
    for (const Interval& i : intervals_)
      if (i.term == place_ && i.is_weight == is_weight && i.parameter == parameter && i.channel == channel)
        marks.known = {i.low, i.high};
    return marks;
  }

  Material& material_;
  Term& term_;
  const Term* in_file_;
  std::size_t place_;
  const std::vector<Interval>& intervals_;
};

}  // namespace

void edit_material(Session& session, const std::vector<Interval>& intervals) {
  const Material& material = session.state().scene.objects[session.state().selected].material;
  for (std::size_t t = 0; t < material.terms.size(); ++t) {
    ImGui::PushID(int(t));
    if (material.terms.size() > 1) ImGui::Text("term %d of %d", int(t) + 1, int(material.terms.size()));
    form_panel(session, t);
    TermSliders(session, t, intervals).draw();
    ImGui::PopID();
  }
}

void edit_object(Object& object) {
  ImGui::DragFloat3("position", &object.position.x, 0.02f);
  ImGui::DragFloat3("rotation", &object.rotation.x, 1);
  ImGui::DragFloat3("scale", &object.scale.x, 0.01f, 0.01f, 100);
  for (int k = 0; k < 3; ++k) object.scale[k] = std::abs(object.scale[k]) < 0.01f ? 0.01f : object.scale[k];
}

namespace {

// Edits the direction of incidence: the angle round the vertical axis, 0 being the side of the usual
// camera, and the angle above the horizon.
void edit_direction(Light& light) {
  const glm::vec3 from = -glm::normalize(light.vector);
  float round = glm::degrees(std::atan2(from.x, from.z)), above = glm::degrees(std::asin(from.y));
  bool moved = float_slider("round", round, -180, 180, "%.0f°");
  moved |= float_slider("above", above, -89, 89, "%.0f°");
  if (!moved) return;
  const float r = glm::radians(round), a = glm::radians(above);
  light.vector = -glm::length(light.vector) *
                 glm::vec3(std::sin(r) * std::cos(a), std::sin(a), std::cos(r) * std::cos(a));
}

void edit_environment(Scene& scene) {
  if (!scene.environment) return;
  float_slider("turned", scene.environment->rotation, -180, 180, "%.0f°");
  ImGui::DragFloat("radiance", &scene.environment->intensity, 0.02f, 0, 1000);
}

}  // namespace

void edit_lights(Scene& scene) {
  edit_environment(scene);
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    Light& light = scene.lights[k];
    ImGui::PushID(int(k));
    const std::string title =
        std::string(light.point ? "point light " : "directional light ") + std::to_string(k + 1);
    if (ImGui::TreeNodeEx(title.c_str(), k == 0 ? ImGuiTreeNodeFlags_DefaultOpen : 0)) {
      if (light.point)
        ImGui::DragFloat3("position", &light.vector.x, 0.02f);
      else
        edit_direction(light);
      ImGui::ColorEdit3("color", &light.color.x, ImGuiColorEditFlags_Float);
      ImGui::DragFloat("intensity", &light.intensity, 0.02f, 0, 1000);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }
  if (scene.lights.size() < kMostLights && ImGui::Button("add a point light"))
    scene.lights.push_back({true, {2, 2, 2}, glm::vec3(1), 3});
  if (!scene.lights.empty()) {
    ImGui::SameLine();
    if (ImGui::Button("remove the last light")) scene.lights.pop_back();
  }
  ImGui::ColorEdit3("ambient", &scene.ambient.x, ImGuiColorEditFlags_Float);
}

}  // namespace brdf::render
