#include "render/compare/state.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "io/error.h"
#include "io/json.h"
#include "io/material_json.h"
#include "io/samples.h"
#include "render/mesh/mesh.h"

namespace brdf::render {
namespace {

using io::Json;
using io::JsonPlace;

template <std::size_t N>
std::size_t index_of(const JsonPlace& place, const std::array<const char*, N>& names) {
  const std::string text = place.text();
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) place.fail("is not known");
  return std::size_t(found - names.begin());
}

bool flag(const JsonPlace& place) {
  if (!place.value().is_boolean()) place.fail("must be true or false");
  return place.value().get<bool>();
}

// Relative names start from the scene's folder, which a state saved elsewhere does not know.
Scene with_absolute_names(Scene scene) {
  for (Object& object : scene.objects) {
    const std::filesystem::path file = scene.folder / object.mesh;
    if (std::filesystem::is_regular_file(file)) object.mesh = std::filesystem::absolute(file).string();
    for (auto& texture : object.textures) {
      if (texture) texture = std::filesystem::absolute(scene.folder / *texture);
    }
  }
  return scene;
}

std::string lower_case_suffix(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return suffix;
}

// The value of "format" where the file is JSON, "" where it is not. A file that calls itself JSON must be.
std::string json_format(const std::filesystem::path& file) {
  const bool named_so = lower_case_suffix(file) == ".json";
  try {
    const Json json = io::read_json(file);
    if (json.is_object() && json.contains("format") && json["format"].is_string())
      return json["format"].get<std::string>();
  } catch (const InputError&) {
    if (named_so) throw;
  }
  if (named_so)
    throw InputError(file.string() + ": has no \"format\" (brdf-scene, brdf-material, brdf-view)");
  return "";
}

void put_material(ViewState& state, const std::filesystem::path& file) {
  Object& object = state.scene.objects.at(state.selected);
  object.material = io::read_material(file);
  object.material_name = file.stem().string();
}

bool is_model(const std::filesystem::path& file) {
  const std::string suffix = lower_case_suffix(file);
  const std::array known{".obj", ".x", ".ply", ".stl", ".fbx", ".dae", ".gltf", ".glb", ".3ds"};
  return std::find(known.begin(), known.end(), suffix) != known.end();
}

}  // namespace

std::string state_text(const ViewState& state) {
  Json json;
  json["format"] = "brdf-view";
  json["version"] = 1;
  json["scene"] = io::parse_json(scene_text(with_absolute_names(state.scene)), "scene");
  json["selected"] = state.selected;
  json["compare_with"] = kOtherNames[std::size_t(state.other)];
  if (state.material) {
    json["material"] = io::to_json(*state.material);
    json["material_name"] = state.material_name;
    json["everywhere"] = state.everywhere;
  }
  if (!state.samples.empty()) json["samples"] = std::filesystem::absolute(state.samples).string();
  json["display"] = kDisplayNames[std::size_t(state.display)];
  json["split"] = state.split;
  json["turntable"] = state.turntable;
  json["plot"] = {{"shown", state.show_plot}, {"theta", state.plot_theta}, {"solo", state.plot_solo}};
  return io::to_text(json);
}

ViewState parse_state(const std::string& text, const std::string& name) {
  const Json json = io::parse_json(text, name);
  const JsonPlace root(json, name);
  if (root.at("format").text() != "brdf-view") root.at("format").fail("must be \"brdf-view\"");
  root.allow_keys({"format", "version", "scene", "selected", "compare_with", "material", "material_name",
                   "everywhere", "samples", "display", "split", "turntable", "plot"});
  if (root.at("version").number() != 1) root.at("version").fail("must be 1");
  ViewState state;
  state.scene = parse_scene(root.at("scene").value().dump(), name + ": $.scene", "");
  state.selected = std::size_t(root.at("selected").number(0, double(state.scene.objects.size() - 1)));
  state.other = Other(index_of(root.at("compare_with"), kOtherNames));
  if (root.has("material")) {
    state.material = io::material_from_json(root.at("material")).material;
    state.material_name = root.at("material_name").text();
    if (root.has("everywhere")) state.everywhere = flag(root.at("everywhere"));
  }
  if (root.has("samples")) state.samples = root.at("samples").text();
  state.display = Display(index_of(root.at("display"), kDisplayNames));
  state.split = float(root.at("split").number(0, 1));
  state.turntable = flag(root.at("turntable"));
  const JsonPlace plot = root.at("plot");
  plot.allow_keys({"shown", "theta", "solo"});
  state.show_plot = flag(plot.at("shown"));
  state.plot_theta = float(plot.at("theta").number(0, 90));
  state.plot_solo = int(plot.at("solo").number(-1, 5));
  return state;
}

ViewState load_state(const std::filesystem::path& file) {
  return parse_state(io::read_json(file).dump(), file.string());
}

void open_file(ViewState& state, const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": no such file");
  const std::string format = json_format(file);
  ViewState next = state;
  if (format == "brdf-view") {
    next = load_state(file);
  } else if (format == "brdf-scene") {
    next.scene = load_scene(file);
    next.selected = 0;
  } else if (format == "brdf-material") {
    put_material(next, file);
  } else if (!format.empty()) {
    throw InputError(file.string() + ": the format \"" + format + "\" cannot be opened");
  } else if (is_model(file)) {
    load_model(file);  // refused here rather than in the next frame
    next.scene.objects.at(next.selected).mesh = std::filesystem::absolute(file).string();
  } else {
    const std::size_t channels = io::read_samples(file).channels.size();
    if (channels != 1 && channels != 3) {
      throw InputError(file.string() + ": has " + std::to_string(channels) +
                       " channels; the viewer takes 1 or 3");
    }
    next.samples = file;
    next.other = Other::samples;
    next.display = Display::split;
  }
  state = next;
}

void switch_form(Term& term, const Reflectance& form) {
  const ReflectanceInfo &from = info(term.form), &to = info(form);
  Term next = make_term(form, term.weights.size());
  for (std::size_t k = 0; k < to.shape.size(); ++k) {
    const int same = from.shape_index(to.shape[k].name);
    if (same >= 0) next.shape[0][k] = term.shape[0][std::size_t(same)];
  }
  for (std::size_t k = 0; k < to.weights.size(); ++k) {
    int same = from.weight_index(to.weights[k].name);
    // The diffuse colour has three names: rho, kd, albedo.
    if (same < 0 && k == 0) same = 0;
    if (same < 0) continue;
    for (std::size_t c = 0; c < next.weights.size(); ++c) {
      next.weights[c][k] =
          std::clamp(term.weights[c][std::size_t(same)], to.weights[k].min, to.weights[k].max);
    }
  }
  next.tangent_phi = to.anisotropic() ? term.tangent_phi : Angle{};
  term = next;
}

void orbit(Camera& camera, float right, float up) {
  const glm::vec3 axis = glm::normalize(camera.up);
  glm::vec3 offset = camera.position - camera.target;
  offset = glm::mat3(glm::rotate(glm::mat4(1), -right, axis)) * offset;
  // Stop short of the poles, where up would lie along the view.
  const float polar = std::acos(glm::clamp(glm::dot(glm::normalize(offset), axis), -1.0f, 1.0f));
  const float turn = glm::clamp(up, polar - 3.1f, polar - 0.04f);
  const glm::vec3 side = glm::normalize(glm::cross(axis, offset));
  offset = glm::mat3(glm::rotate(glm::mat4(1), -turn, side)) * offset;
  camera.position = camera.target + offset;
}

void zoom(Camera& camera, float factor) {
  const glm::vec3 offset = (camera.position - camera.target) * factor;
  const float distance = glm::length(offset);
  if (distance > 1e-3f && distance < 1e5f) camera.position = camera.target + offset;
}

void pan(Camera& camera, glm::vec2 share) {
  const glm::vec3 offset = camera.position - camera.target;
  const glm::vec3 right = glm::normalize(glm::cross(camera.up, offset));
  const glm::vec3 up = glm::normalize(glm::cross(offset, right));
  const float height = 2 * std::tan(glm::radians(camera.vertical_fov) / 2) * glm::length(offset);
  const float width = height * float(camera.width) / float(camera.height);
  const glm::vec3 move = -right * share.x * width + up * share.y * height;
  camera.position += move;
  camera.target += move;
}

void fit(Camera& camera, const glm::vec4& bounds) {
  const glm::vec3 direction = glm::normalize(camera.position - camera.target);
  const float half = glm::radians(camera.vertical_fov) / 2;
  const float narrow = std::atan(std::tan(half) * std::min(1.0f, float(camera.width) / float(camera.height)));
  camera.target = glm::vec3(bounds);
  camera.position = camera.target + direction * (bounds.w * 1.05f / std::sin(narrow));
}

}  // namespace brdf::render
