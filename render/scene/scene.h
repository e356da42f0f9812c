// The content of a scene file, and its reader. The unit of length is arbitrary, angles are in degrees in
// the file, radiance and irradiance are in the same arbitrary unit.
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
  // Offset of the sample in its pixel, from the centre, in pixels to the right and down; not part of scene
  // files.
  glm::vec2 offset{0};
  friend bool operator==(const Camera&, const Camera&) = default;
};

struct Light {
  bool point = false;
  // Position of a point light, otherwise the direction in which the light travels.
  glm::vec3 vector{1, -1, -1};
  glm::vec3 color{1};
  // Directional: irradiance on a surface that faces the light; point: the same at distance 1.
  float intensity = 1;
  friend bool operator==(const Light&, const Light&) = default;
};
inline constexpr std::size_t kMostLights = 64;

// Distant light from all directions.
struct Environment {
  std::string picture;  // a file relative to the scene's folder, or the name of a Formula
  // Degrees about the vertical axis, counter-clockwise seen from above.
  float rotation = 0;
  float intensity = 1;  // factor on the radiance
  bool shown = true;    // behind the objects, in place of the scene's background
  // Height of a floor on which the objects stand. Directions below the horizon then see the floor, which is
  // darker next to the objects (taken as balls around their origins). Without it, distant light only.
  std::optional<float> floor = {};
  friend bool operator==(const Environment&, const Environment&) = default;
};

enum class TextureSlot { albedo, normal, roughness, metallic };

struct Object {
  std::string mesh = "sphere";
  Material material;
  // For labels: the name in the material's file, otherwise the stem of the file or the name of the form.
  std::string material_name;
  std::string label;                                             // drawn below the object in pictures
  std::array<std::optional<std::filesystem::path>, 4> textures;  // indexed by TextureSlot
  glm::vec3 position{0};
  glm::vec3 rotation{0};  // degrees about x, then y, then z
  glm::vec3 scale{1};
  friend bool operator==(const Object&, const Object&) = default;
};

enum class Shading { vertex_color, flat, gouraud, phong, phong_blinn, brdf, lookup };
// none: the unchanged value; srgb: clamped, then encoded; reinhard: c/(1+c), then encoded as sRGB; thesis:
// c/(1+c) to the power 1/2.2; neutral: keeps the hue, then encoded as sRGB.
enum class ToneMap { none, srgb, reinhard, thesis, neutral };

struct Scene {
  Camera camera;
  glm::vec3 ambient{0};
  glm::vec3 background{0};  // at the horizon if there is a sky
  // With a sky: `background` is the colour at the horizon, this is the colour at the zenith.
  std::optional<glm::vec3> sky_zenith;
  // Without a sky: `background` is the colour at the picture's lower edge, this is the colour at the upper
  // edge.
  std::optional<glm::vec3> backdrop_top;
  glm::vec3 back_color{0.5f};  // colour of surfaces seen from behind
  bool shadow = false;         // the first directional light casts a shadow
  std::vector<Light> lights;
  std::optional<Environment> environment;
  std::vector<Object> objects;
  std::filesystem::path folder;  // base of relative file names
  Shading shading = Shading::brdf;
  // Computes per vertex instead of per pixel: colours (phong, phong_blinn) or texture coordinates (lookup).
  bool per_vertex = false;
  bool as_coded = false;  // with the errors of the articles' code
  ToneMap tone_map = ToneMap::neutral;
  float exposure = 0;  // factor 2^exposure before the tone map
  friend bool operator==(const Scene&, const Scene&) = default;
};
// Reads a scene file. If a relative name does not exist, it is searched for in the installed data
// (io/files/installed.h). Throws InputError with file, JSON path, value and rule; scene_json.h has the rest
// of the format.
Scene load_scene(const std::filesystem::path& file);

// Returns the mapping of channels to colours; pictures are grey or RGB. Throws InputError naming `what` if
// no channel can be identified as red.
io::ChannelColours require_colours(const std::vector<std::string>& channels, const std::string& what);

// Returns a row of spheres, one per material, under one light and a little ambient light, as shown by `brdf
// render MATERIAL...`.
Scene material_scene(const std::vector<std::pair<std::string, Material>>& materials);

// Returns the same scene with a shape of make_mesh() in place of the spheres. The shape has the size of the
// spheres and is seen from slightly above. Parts that never have the material shown (a car's windows and
// tyres, the base of the shader ball) are further objects after the object with the material. Throws
// InputError if the shape cannot be read.
Scene shape_scene(const std::string& shape, const std::vector<std::pair<std::string, Material>>& materials);

// Returns the rotation and scale of an object.
glm::mat3 linear_part(const Object& object);

// Returns the rotation from directions of the world to directions of the environment's picture.
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
