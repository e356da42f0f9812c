#include "render/compare/state.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/formats/read.h"
#include "io/material/material_json.h"
#include "io/samples/samples.h"
#include "render/compare/lobe_points.h"
#include "render/light/formula.h"
#include "render/mesh/mesh.h"
#include "render/scene/camera_view.h"
#include "render/scene/scene_json.h"

namespace brdf::render {
namespace {

using io::Json;
using io::JsonPlace;

// Makes all file names absolute. Relative names start from the scene's folder, which is not known to a
// state that is saved in another folder.
Scene with_absolute_names(Scene scene) {
  if (scene.environment && !find_named<Formula>(scene.environment->picture))
    scene.environment->picture =
        std::filesystem::absolute(scene.folder / scene.environment->picture).string();
  for (Object& object : scene.objects) {
    const std::filesystem::path file = scene.folder / object.mesh;
    if (std::filesystem::is_regular_file(file)) object.mesh = std::filesystem::absolute(file).string();
    for (auto& texture : object.textures)
      if (texture) texture = std::filesystem::absolute(scene.folder / *texture);
  }
  return scene;
}

std::string lower_case_suffix(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return suffix;
}

// Returns the JSON content of a file, or std::nullopt if the file is not JSON. A file with the suffix .json
// must be valid JSON.
std::optional<Json> json_of(const std::filesystem::path& file, const io::Content& content) {
  if (lower_case_suffix(file) != ".json" && !io::is_json(content)) return std::nullopt;
  Json json = io::read_json(content);
  if (!json.is_object() || !json.contains("format") || !json["format"].is_string())
    throw InputError(file.string() + ": has no \"format\" (brdf-scene, brdf-material, brdf-view)");
  return json;
}

ViewState state_from_json(const JsonPlace& root) {
  require_format(root, "brdf-view");
  root.allow_keys({"format", "version", "scene", "selected", "compare_with", "material", "material_name",
                   "everywhere", "samples", "display", "split", "turntable", "plot", "kept",
                   "light_follows"});
  ViewState state;
  state.scene = scene_from_json(root.at("scene"), "");
  state.selected = std::size_t(root.at("selected").number(0, double(state.scene.objects.size() - 1)));
  state.other = root.at("compare_with").named<Other>();
  if (root.has("material")) {
    state.material = io::material_from_json(root.at("material")).material;
    state.material_name = root.at("material_name").text();
    if (root.has("everywhere")) state.everywhere = read_flag(root.at("everywhere"));
  }
  if (root.has("samples")) state.samples = root.at("samples").text();
  state.display = root.at("display").named<Display>();
  state.split = float(root.at("split").number(0, 1));
  state.turntable = read_flag(root.at("turntable"));
  const JsonPlace plot = root.at("plot");
  plot.allow_keys({"shown", "theta", "solo"});
  state.show_plot = read_flag(plot.at("shown"));
  state.plot_theta = float(plot.at("theta").number(0, 90));
  state.plot_solo = int(plot.at("solo").number(-1, kMostCurves));
  for (std::size_t k = 0; root.has("kept") && k < root.at("kept").size(); ++k) {
    const JsonPlace one = root.at("kept").at(k);
    one.allow_keys({"name", "material"});
    state.kept.emplace_back(one.at("name").text(), io::material_from_json(one.at("material")).material);
  }
  if (root.has("light_follows")) state.light_follows = read_flag(root.at("light_follows"));
  return state;
}

bool is_model(const std::filesystem::path& file) {
  const std::string suffix = lower_case_suffix(file);
  const std::array known{".obj", ".x", ".ply", ".stl", ".fbx", ".dae", ".gltf", ".glb", ".3ds"};
  return std::ranges::find(known, suffix) != known.end();
}

}  // namespace

std::string state_text(const ViewState& state) {
  Json json;
  json["format"] = "brdf-view";
  json["version"] = 1;
  json["scene"] = to_json(with_absolute_names(state.scene));
  json["selected"] = state.selected;
  json["compare_with"] = name_of(state.other);
  if (state.material) {
    json["material"] = io::to_json(*state.material);
    json["material_name"] = state.material_name;
    json["everywhere"] = state.everywhere;
  }
  if (!state.samples.empty()) json["samples"] = std::filesystem::absolute(state.samples).string();
  json["display"] = name_of(state.display);
  json["split"] = state.split;
  json["turntable"] = state.turntable;
  json["plot"] = {{"shown", state.show_plot}, {"theta", state.plot_theta}, {"solo", state.plot_solo}};
  for (const auto& [name, material] : state.kept)
    json["kept"].push_back({{"name", name}, {"material", io::to_json(material)}});
  if (state.light_follows) json["light_follows"] = true;
  return io::to_text(json);
}

ViewState load_state(const std::filesystem::path& file) {
  const Json json = io::read_json(file);
  return state_from_json({json, file.string()});
}

namespace {

// Returns `state` with the content of the document, according to the document's format.
ViewState with_document(ViewState state, const Json& json, const std::filesystem::path& file) {
  const JsonPlace place(json, file.string());
  const std::string format = place.at("format").text();
  if (format == "brdf-view") return state_from_json(place);
  if (format == "brdf-scene") {
    state.scene = scene_from_json(place, file.parent_path());
    state.selected = 0;
  } else if (format == "brdf-material") {
    Object& object = state.scene.objects.at(state.selected);
    object.material = io::material_from_json(place).material;
    object.material_name = file.stem().string();
  } else {
    throw InputError(file.string() + ": the format \"" + format + "\" is not supported");
  }
  return state;
}

}  // namespace

float measured_theta(const io::SampleTable& table, float theta) {
  const double nearest = nearest_light(table, double(theta));
  return std::isfinite(nearest) ? float(nearest) : theta;
}

void open_file(ViewState& state, const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw InputError(file.string() + ": no such file");
  // The state stores only the names of samples and models, which are read again when they are drawn.
  if (!std::filesystem::is_regular_file(file))
    throw InputError(file.string() + ": is not a file that can be read again");
  io::Content content = io::read_content(file);
  if (const std::optional<Json> json = json_of(file, content)) {
    state = with_document(state, *json, file);
  } else if (is_model(file)) {
    load_model(file);  // reports errors here instead of in the next frame
    state.scene.objects.at(state.selected).mesh = std::filesystem::absolute(file).string();
  } else {
    const io::SampleTable table = io::read_samples(std::move(content));
    require_colours(table.channels, file.string());
    state.plot_theta = measured_theta(table, state.plot_theta);
    state.samples = file;
    state.other = Other::samples;
    state.display = Display::split;
    state.split = split_at_highlight(state.scene, state.selected);
  }
}

float split_at_highlight(const Scene& scene, std::size_t object) {
  if (scene.lights.empty() || object >= scene.objects.size()) return 0.5f;
  const Camera& camera = scene.camera;
  const Object& o = scene.objects[object];
  const float radius = std::max({o.scale.x, o.scale.y, o.scale.z});
  const Light& light = scene.lights[0];
  glm::vec3 at = o.position;
  for (int k = 0; k < 8; ++k) {
    const glm::vec3 to_viewer = glm::normalize(camera.position - at);
    const glm::vec3 to_light = glm::normalize(light.point ? light.vector - at : -light.vector);
    const glm::vec3 sum = to_viewer + to_light;
    if (!(glm::length(sum) > 1e-3f)) return 0.5f;
    at = o.position + radius * glm::normalize(sum);
  }
  const glm::vec3 ahead = glm::normalize(camera.target - camera.position);
  const glm::vec3 right = glm::normalize(glm::cross(ahead, camera.up));
  const glm::vec3 offset = at - camera.position;
  const float half =
      std::tan(glm::radians(camera.vertical_fov) / 2) * float(camera.width) / float(camera.height);
  const float along = glm::dot(offset, right) / (half * std::max(glm::dot(offset, ahead), 1e-3f));
  return glm::clamp(0.5f + along / 2, 0.15f, 0.85f);
}

std::string left_out_note(const ViewState& state) {
  const bool compared = state.display != Display::picture && state.display != Display::gbuffer;
  if (!compared || state.other != Other::samples) return "";
  const bool ambient = state.scene.ambient != glm::vec3(0);
  if (!ambient && !state.scene.environment) return "";
  const std::string what = !state.scene.environment ? "ambient light is"
                           : ambient                ? "ambient light and the environment are"
                                                    : "the environment is";
  return what + " omitted on both sides, because samples have no values for it";
}

namespace {

// Returns the index in the other table of the parameter with the same name, otherwise with the same role.
int counterpart(const ParameterInfo& p, int by_name, int by_role) {
  return by_name < 0 && p.role != Role::other ? by_role : by_name;
}

}  // namespace

void switch_form(Term& term, const Reflectance& form) {
  const ReflectanceInfo &from = info(term.form), &to = info(form);
  Term next = make_term(form, term.weights.size());
  for (std::size_t k = 0; k < to.shape.size(); ++k) {
    const ParameterInfo& p = to.shape[k];
    const int same = counterpart(p, from.shape_index(p.name), from.shape_index(p.role));
    if (same >= 0) next.shape[0][k] = std::clamp(term.shape[0][std::size_t(same)], p.min, p.max);
  }
  for (std::size_t k = 0; k < to.weights.size(); ++k) {
    const ParameterInfo& p = to.weights[k];
    const int same = counterpart(p, from.weight_index(p.name), from.weight_index(p.role));
    for (std::size_t c = 0; same >= 0 && c < next.weights.size(); ++c)
      next.weights[c][k] = std::clamp(term.weights[c][std::size_t(same)], p.min, p.max);
  }
  next.tangent_phi = to.anisotropic() ? term.tangent_phi : Angle{};
  term = next;
}

void orbit(Camera& camera, float right, float up) {
  const glm::vec3 axis = glm::normalize(camera.up);
  glm::vec3 offset = camera.position - camera.target;
  offset = glm::mat3(glm::rotate(glm::mat4(1), -right, axis)) * offset;
  // Stops short of the poles, where the up vector would lie along the viewing direction.
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

namespace {

glm::vec4 sphere_round(const PointBox& box) {
  return glm::vec4((box.low + box.high) / 2.0f, std::max(glm::length(box.size()) / 2, 1e-4f));
}

}  // namespace

glm::vec4 bounds_of(const PreparedScene& scene, std::optional<std::size_t> object) {
  PointBox solid;
  for (const Item& item : scene.layers[0]) {
    if (object && item.object != *object) continue;
    PointBox own;
    for (const Vertex& vertex : scene.meshes[item.object]->vertices)
      own.add(item.origin + item.linear * vertex.position);
    if (!object && own.is_flat()) continue;
    solid.add(own.low);
    solid.add(own.high);
  }
  return solid.low.x <= solid.high.x ? sphere_round(solid) : scene.bounds;
}

void turn_light(Scene& scene, float right, float up) {
  const Camera& camera = scene.camera;
  const glm::vec3 axis = glm::normalize(camera.up);
  const glm::vec3 side = glm::normalize(glm::cross(axis, camera.position - camera.target));
  const glm::mat3 turn =
      glm::mat3(glm::rotate(glm::mat4(1), right, axis)) * glm::mat3(glm::rotate(glm::mat4(1), up, side));
  for (Light& light : scene.lights)
    if (!light.point) light.vector = turn * light.vector;
  if (scene.environment)
    scene.environment->rotation = std::remainder(scene.environment->rotation + glm::degrees(right), 360.0f);
}

void follow_camera(Scene& scene, const Camera& before) {
  const Camera& camera = scene.camera;
  // A change of only the picture's size is not a movement; rounding errors would otherwise turn the light.
  if (camera.position == before.position && camera.target == before.target && camera.up == before.up) return;
  const View now = make_view(camera), then = make_view(before);
  const auto frame = [](const View& v) {
    return glm::mat3(glm::normalize(v.right), glm::normalize(v.up), glm::normalize(v.forward));
  };
  const glm::mat3 turn = frame(now) * glm::transpose(frame(then));
  for (Light& light : scene.lights)
    if (!light.point) light.vector = turn * light.vector;
  if (!scene.environment) return;
  const float round = std::atan2(now.forward.x, now.forward.z) - std::atan2(then.forward.x, then.forward.z);
  scene.environment->rotation = std::remainder(scene.environment->rotation + glm::degrees(round), 360.0f);
}

}  // namespace brdf::render
