#include "render/scene/scene_json.h"

#include <cmath>

#include "io/files/installed.h"
#include "io/material/below_zero.h"
#include "io/material/material_json.h"
#include "render/light/formula.h"

namespace brdf::render {
namespace {

using io::Json;
using io::JsonPlace;

glm::vec3 vector(const JsonPlace& place, double low = -1e6, double high = 1e6) {
  if (place.size() != 3) place.fail("must be an array of three numbers");
  glm::vec3 v;
  for (int k = 0; k < 3; ++k) v[k] = float(place.at(std::size_t(k)).number(low, high));
  return v;
}

// Reads the key into `out` if the key exists.
void read(const JsonPlace& place, std::string_view key, glm::vec3& out, double low = -1e6,
          double high = 1e6) {
  if (place.has(key)) out = vector(place.at(key), low, high);
}
void read(const JsonPlace& place, std::string_view key, float& out, double low, double high) {
  if (place.has(key)) out = float(place.at(key).number(low, high));
}
void read(const JsonPlace& place, std::string_view key, int& out, int low, int high) {
  if (!place.has(key)) return;
  const JsonPlace value = place.at(key);
  if (!value.value().is_number_integer()) value.fail("must be an integer");
  out = int(value.number(low, high));
}
void read(const JsonPlace& place, std::string_view key, bool& out) {
  if (place.has(key)) out = read_flag(place.at(key));
}
template <class Enum>
void read(const JsonPlace& place, std::string_view key, Enum& out) {
  if (place.has(key)) out = place.at(key).named<Enum>();
}

void require_direction(const JsonPlace& place, const glm::vec3& v) {
  if (!(glm::length(v) > 1e-6f)) place.fail("must not be zero");
}

Camera read_camera(const JsonPlace& place) {
  place.allow_keys({"position", "target", "up", "vertical_fov", "width", "height"});
  Camera camera;
  read(place, "position", camera.position);
  read(place, "target", camera.target);
  read(place, "up", camera.up);
  read(place, "vertical_fov", camera.vertical_fov, 1, 170);
  read(place, "width", camera.width, 1, 16384);
  read(place, "height", camera.height, 1, 16384);
  if (!(glm::length(glm::cross(camera.target - camera.position, camera.up)) > 1e-6f)) {
    place.fail(
        "needs a target different from its position and an up direction that is not parallel to the view");
  }
  return camera;
}

Light read_light(const JsonPlace& place) {
  place.allow_keys({"type", "direction", "position", "color", "intensity"});
  Light light;
  const std::string type = place.at("type").text();
  if (type != "directional" && type != "point") place.at("type").fail("must be one of directional, point");
  light.point = type == "point";
  const char* unused = light.point ? "direction" : "position";
  if (place.has(unused)) place.at(unused).fail("does not belong to a " + type + " light");
  const JsonPlace where = place.at(light.point ? "position" : "direction");
  light.vector = vector(where);
  if (!light.point) require_direction(where, light.vector);
  read(place, "color", light.color, 0, 1e6);
  read(place, "intensity", light.intensity, 0, 1e6);
  return light;
}

Environment read_environment(const JsonPlace& place) {
  place.allow_keys({"picture", "rotation", "intensity", "floor"});
  Environment environment;
  environment.picture = place.at("picture").text();
  if (environment.picture.empty())
    place.at("picture").fail("must be the name of a file or one of " + known_names<Formula>());
  read(place, "rotation", environment.rotation, -360, 360);
  read(place, "intensity", environment.intensity, 0, 1e6);
  if (place.has("floor")) read(place, "floor", environment.floor.emplace(0.0f), -1e6, 1e6);
  return environment;
}

void read_material_of(Object& object, const JsonPlace& place, const std::filesystem::path& folder) {
  if (place.value().is_string()) {
    const std::filesystem::path file = folder / place.text();
    io::MaterialFile read = io::read_material_file(file);
    io::require_not_below_zero(read.material, file.string());
    object.material = std::move(read.material);
    object.material_name = read.name.empty() ? file.stem().string() : read.name;
    return;
  }
  io::MaterialFile read = io::material_from_json(place);
  io::require_not_below_zero(read.material, place.path());
  object.material = std::move(read.material);
  object.material_name = !read.name.empty() ? read.name
                         : object.material.terms.size() == 1
                             ? std::string(info(object.material.terms[0].form).name)
                             : std::string("sum");
}

Object read_object(const JsonPlace& place, const std::filesystem::path& folder) {
  place.allow_keys({"mesh", "material", "label", "textures", "position", "rotation", "scale"});
  Object object;
  if (place.has("mesh")) object.mesh = place.at("mesh").text();
  if (place.has("label")) object.label = place.at("label").text();
  read_material_of(object, place.at("material"), folder);
  require_colours(object.material.channels, place.file() + ": " + place.path() + ".material");
  if (place.has("textures")) {
    const JsonPlace textures = place.at("textures");
    constexpr auto kSlots = kNames<TextureSlot>;
    textures.allow_keys({kSlots[0], kSlots[1], kSlots[2], kSlots[3]});
    for (std::size_t k = 0; k < kSlots.size(); ++k)
      if (textures.has(kSlots[k])) object.textures[k] = textures.at(kSlots[k]).text();
  }
  read(place, "position", object.position);
  read(place, "rotation", object.rotation);
  if (place.has("scale") && place.at("scale").value().is_number()) {
    object.scale = glm::vec3(float(place.at("scale").number(-1e6, 1e6)));
  } else {
    read(place, "scale", object.scale);
  }
  if (!(std::abs(object.scale.x * object.scale.y * object.scale.z) > 1e-12f)) {
    place.at("scale").fail("must not be 0 along any axis");
  }
  return object;
}

void read_background(Scene& scene, const JsonPlace& place) {
  if (place.value().is_array()) {
    scene.background = vector(place, 0, 1e6);
    return;
  }
  if (place.has("bottom") || place.has("top")) {
    place.allow_keys({"bottom", "top"});
    scene.background = vector(place.at("bottom"), 0, 1e6);
    scene.backdrop_top = vector(place.at("top"), 0, 1e6);
    return;
  }
  place.allow_keys({"horizon", "zenith"});
  scene.background = vector(place.at("horizon"), 0, 1e6);
  scene.sky_zenith = vector(place.at("zenith"), 0, 1e6);
}

Json json_of(const glm::vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

Json json_of(const Object& object) {
  Json json;
  json["mesh"] = object.mesh;
  if (!object.label.empty()) json["label"] = object.label;
  json["material"] = io::to_json(object.material);
  for (std::size_t k = 0; k < object.textures.size(); ++k)
    if (object.textures[k]) json["textures"][kNames<TextureSlot>[k]] = object.textures[k]->string();
  json["position"] = json_of(object.position);
  json["rotation"] = json_of(object.rotation);
  json["scale"] = json_of(object.scale);
  return json;
}

Json json_of(const Environment& environment) {
  Json json{{"picture", environment.picture},
            {"rotation", environment.rotation},
            {"intensity", environment.intensity}};
  if (environment.floor) json["floor"] = *environment.floor;
  return json;
}

Json json_of(const Light& light) {
  Json json;
  json["type"] = light.point ? "point" : "directional";
  json[light.point ? "position" : "direction"] = json_of(light.vector);
  json["color"] = json_of(light.color);
  json["intensity"] = light.intensity;
  return json;
}

}  // namespace

void require_format(const JsonPlace& place, std::string_view format) {
  const JsonPlace named = place.at("format"), version = place.at("version");
  if (named.text() != format) named.fail("must be \"" + std::string(format) + "\"");
  if (version.number() != 1) version.fail("must be 1");
}

bool read_flag(const JsonPlace& place) {
  if (!place.value().is_boolean()) place.fail("must be true or false");
  return place.value().get<bool>();
}

Scene scene_from_json(const JsonPlace& root, const std::filesystem::path& folder) {
  require_format(root, "brdf-scene");
  root.allow_keys({"format", "version", "camera", "ambient", "background", "back_color", "lights",
                   "environment", "objects", "shading", "per_vertex", "as_coded", "tone_map", "exposure",
                   "shadow"});
  Scene scene;
  scene.folder = folder;
  if (root.has("camera")) scene.camera = read_camera(root.at("camera"));
  read(root, "ambient", scene.ambient, 0, 1e6);
  if (root.has("background")) read_background(scene, root.at("background"));
  read(root, "back_color", scene.back_color, 0, 1e6);
  if (root.has("lights")) {
    const JsonPlace lights = root.at("lights");
    if (lights.size() > kMostLights)
      lights.fail("must have at most " + std::to_string(kMostLights) + " lights");
    for (std::size_t k = 0; k < lights.size(); ++k) scene.lights.push_back(read_light(lights.at(k)));
  }
  read(root, "shadow", scene.shadow);
  if (root.has("environment")) {
    scene.environment = read_environment(root.at("environment"));
    scene.environment->shown = !root.has("background");
  }
  const JsonPlace objects = root.at("objects");
  if (objects.size() == 0 || objects.size() > 200) objects.fail("must have 1 to 200 objects");
  for (std::size_t k = 0; k < objects.size(); ++k)
    scene.objects.push_back(read_object(objects.at(k), folder));
  read(root, "shading", scene.shading);
  read(root, "per_vertex", scene.per_vertex);
  read(root, "as_coded", scene.as_coded);
  // The articles' modes compute colours that are displayed unchanged.
  scene.tone_map = scene.shading == Shading::brdf ? ToneMap::neutral : ToneMap::none;
  read(root, "tone_map", scene.tone_map);
  read(root, "exposure", scene.exposure, -20, 20);
  return scene;
}

Scene load_scene(const std::filesystem::path& named) {
  const std::filesystem::path file = io::here_or_installed(named);
  const Json json = io::read_json(file);
  return scene_from_json({json, file.string()}, file.parent_path());
}

Json to_json(const Scene& scene) {
  Json json;
  json["format"] = "brdf-scene";
  json["version"] = 1;
  const Camera& camera = scene.camera;
  json["camera"] = {{"position", json_of(camera.position)},
                    {"target", json_of(camera.target)},
                    {"up", json_of(camera.up)},
                    {"vertical_fov", camera.vertical_fov},
                    {"width", camera.width},
                    {"height", camera.height}};
  json["ambient"] = json_of(scene.ambient);
  if (scene.environment) json["environment"] = json_of(*scene.environment);
  const bool background = !scene.environment || !scene.environment->shown;
  if (background && scene.sky_zenith) {
    json["background"] = {{"horizon", json_of(scene.background)}, {"zenith", json_of(*scene.sky_zenith)}};
  } else if (background && scene.backdrop_top) {
    json["background"] = {{"bottom", json_of(scene.background)}, {"top", json_of(*scene.backdrop_top)}};
  } else if (background) {
    json["background"] = json_of(scene.background);
  }
  json["back_color"] = json_of(scene.back_color);
  json["lights"] = Json::array();
  for (const Light& light : scene.lights) json["lights"].push_back(json_of(light));
  json["shadow"] = scene.shadow;
  json["objects"] = Json::array();
  for (const Object& object : scene.objects) json["objects"].push_back(json_of(object));
  json["shading"] = name_of(scene.shading);
  json["per_vertex"] = scene.per_vertex;
  json["as_coded"] = scene.as_coded;
  json["tone_map"] = name_of(scene.tone_map);
  json["exposure"] = scene.exposure;
  return json;
}

}  // namespace brdf::render
