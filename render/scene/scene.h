// What a scene file says, and its reader. Units: metres do not matter, angles in degrees in the file,
// radiance and irradiance in any one unit.
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "brdf/names.h"
#include "io/colour/channel_colours.h"

namespace brdf {
namespace render {

struct Camera {
  glm::vec3 position{0, 0, 4}, target{0, 0, 0}, up{0, 1, 0};
  float vertical_fov = 32;  // degrees
  int width = 512, height = 512;
  glm::vec2 offset{
      0};  // of the sample in its pixel, from the centre, in pixels to the right and down; in no file
  friend bool operator==(const Camera&, const Camera&) = default;
};

struct Light {
  bool point = false;
  glm::vec3 vector{1, -1, -1};  // a point light's position, else the direction in which the light travels
  glm::vec3 color{1};
  float intensity = 1;  // directional: irradiance on a surface facing it; point: the same at distance 1
  friend bool operator==(const Light&, const Light&) = default;
};
inline constexpr std::size_t kMostLights = 64;

// Light from all around, far away.
struct Environment {
  std::string picture;  // a file from the scene's folder, or a Formula's name
  float rotation = 0;   // degrees about the vertical axis, counter-clockwise from above
  float intensity = 1;  // factor on its radiance
  bool shown = true;    // behind the objects, instead of the scene's background
  friend bool operator==(const Environment&, const Environment&) = default;
};

enum class TextureSlot { albedo, normal, roughness, metallic };

struct Object {
  std::string mesh = "sphere";
  Material material;
  std::string material_name;  // for labels: what the file calls it, else its stem or the form
  std::string label;          // drawn below it in pictures
  std::array<std::optional<std::filesystem::path>, 4> textures;  // by TextureSlot
  glm::vec3 position{0};
  glm::vec3 rotation{0};  // degrees about x, then y, then z
  glm::vec3 scale{1};
  friend bool operator==(const Object&, const Object&) = default;
};

enum class Shading { vertex_color, flat, gouraud, phong, phong_blinn, brdf, lookup };
// none: the value as it stands; srgb: clamped, then encoded; reinhard: c/(1+c), then encoded as sRGB; thesis:
// c/(1+c) to the power 1/2.2; neutral: keeps the hue, then encoded as sRGB.
enum class ToneMap { none, srgb, reinhard, thesis, neutral };

struct Scene {
  Camera camera;
  glm::vec3 ambient{0};
  glm::vec3 background{0};                // at the horizon where there is a sky
  std::optional<glm::vec3> sky_zenith;    // a sky: background at the horizon, this above
  std::optional<glm::vec3> backdrop_top;  // no sky: background at the picture's lower edge, this at the upper
  glm::vec3 back_color{0.5f};             // of surfaces seen from behind
  bool shadow = false;                    // the first directional light casts one
  std::vector<Light> lights;
  std::optional<Environment> environment;
  std::vector<Object> objects;
  std::filesystem::path folder;  // that relative file names start from
  Shading shading = Shading::brdf;
  // phong, phong_blinn: colours, lookup: texture coordinates, per vertex instead of per pixel.
  bool per_vertex = false;
  bool as_coded = false;  // with the articles' slips
  ToneMap tone_map = ToneMap::neutral;
  float exposure = 0;  // factor 2^exposure before the tone map
  friend bool operator==(const Scene&, const Scene&) = default;
};
// A relative name that is not there is looked for in the installed data (io/files/installed.h). Throws
// InputError with file, JSON path, value and rule; scene_json.h has the rest of the format.
Scene load_scene(const std::filesystem::path& file);

// Pictures are grey or RGB. Throws InputError naming what has channels of which none can be told to be red.
io::ChannelColours require_colours(const std::vector<std::string>& channels, const std::string& what);

// A row of spheres, one per material, under one light and
// a little ambient: what `brdf render MATERIAL...` shows.
Scene material_scene(const std::vector<std::pair<std::string, Material>>& materials);

// The same with a shape of make_mesh() in place of the spheres, as large as they, seen from a little above.
// Parts that are never of the material shown (a car's windows and tyres, the stand of the shader ball) are
// further objects after the one that is. Throws InputError on a shape that cannot be read.
Scene shape_scene(const std::string& shape, const std::vector<std::pair<std::string, Material>>& materials);

// Rotation and scale of an object, and the same for normals.
glm::mat3 linear_part(const Object& object);

// Turns directions of the world into those of the environment's picture.
glm::mat3 to_picture(const Environment& environment);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 4> kNames<render::TextureSlot>{"albedo", "normal", "roughness",
                                                                             "metallic"};
template <>
inline constexpr std::array<std::string_view, 7> kNames<render::Shading>{
    "vertex_color", "flat", "gouraud", "phong", "phong_blinn", "brdf", "lookup"};
template <>
inline constexpr std::array<std::string_view, 5> kNames<render::ToneMap>{"none", "srgb", "reinhard", "thesis",
                                                                         "neutral"};

}  // namespace brdf
