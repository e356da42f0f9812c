// Lit silhouettes: no pixel of an object at the background is black if light falls on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

#include "brdf/reflectance.h"
#include "io/material/material_file.h"
#include "render/gpu/held.h"
#include "render/gpu/renderer.h"
#include "render/light/formula.h"
#include "render/reference/reference.h"
#include "tests/thorough.h"

namespace brdf::render {
namespace {

constexpr float kLit = 0.1f;  // a pixel counts as lit from this cosine on

// The geometry of the picture, independent of its shading, from targets of 32 bits.
struct Geometry {
  Picture normal, position;
  explicit Geometry(Device& device, PreparedScene scene) {
    scene.scene.shading = Shading::brdf;
    Renderer renderer(device, scene, {.gbuffer_bits = 32});
    renderer.draw();
    const Camera& camera = scene.scene.camera;
    normal = picture_from(camera.width, camera.height, renderer.read_target(Target::normal));
    position = picture_from(camera.width, camera.height, renderer.read_target(Target::position));
    for (glm::vec4& p : position.pixels)
      if (p.a > 0) p += glm::vec4(scene.layers[0][std::size_t(p.a + 0.5f) - 1].origin, 0);
  }
  int object(int x, int y) const { return int(position.at(x, y).a + 0.5f) - 1; }
};

float largest_cosine(const Scene& scene, const glm::vec3& position, const glm::vec3& normal) {
  float most = scene.environment ? 1 : -1;  // light from all around: some of it arrives along the normal
  for (const Light& light : scene.lights)
    most = std::max(most,
                    glm::dot(normal, glm::normalize(light.point ? light.vector - position : -light.vector)));
  return most;
}

float luminance(const glm::vec4& c) {
  return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b;
}

struct Silhouette {
  int pixels = 0;
  float darkest = 1e9f;  // luminance over the median of the pixel's neighbours on the same object
  std::vector<std::pair<int, int>> below;  // pixels with less than a tenth of this median
};

// Returns the largest weight of this role in any channel of any term.
double largest_weight(const Material& material, Role role) {
  double largest = 0;
  for (const Term& term : material.terms) {
    const int k = info(term.form).weight_index(role);
    for (std::size_t c = 0; k >= 0 && c < term.weights.size(); ++c)
      largest = std::max(largest, term.weights[c][std::size_t(k)]);
  }
  return largest;
}

// Lit by lights alone, metal is black around its highlight, at a silhouette as elsewhere. A map of metal
// and rust puts such black pixels next to pixels that are not metal.
bool may_be_black(const Scene& scene, int object) {
  if (scene.environment) return false;
  const Object& o = scene.objects[std::size_t(object)];
  return o.textures[std::size_t(TextureSlot::metallic)] ||
         largest_weight(o.material, Role::diffuse) < 0.1 * largest_weight(o.material, Role::specular);
}

constexpr std::array<std::pair<int, int>, 8> kAround{
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
bool is_beside_background(const Geometry& at, int x, int y) {
  return std::any_of(kAround.begin(), kAround.end(),
                     [&](const auto& d) { return at.object(x + d.first, y + d.second) < 0; });
}

// Selects among the pixels that have a neighbour which shows the background.
enum class Of { all, what_is_never_black };
Silhouette lit_silhouette(const Scene& scene, const Geometry& at, const Picture& picture,
                          Of which = Of::what_is_never_black) {
  Silhouette out;
  for (int y = 1; y + 1 < picture.height; ++y) {
    for (int x = 1; x + 1 < picture.width; ++x) {
      const int object = at.object(x, y);
      if (object < 0 || !is_surface(picture.at(x, y))) continue;
      if (which == Of::what_is_never_black && may_be_black(scene, object)) continue;
      if (!is_beside_background(at, x, y)) continue;
      std::vector<float> beside;
      for (const auto& [dx, dy] : kAround)
        if (at.object(x + dx, y + dy) == object) beside.push_back(luminance(picture.at(x + dx, y + dy)));
      const glm::vec3 position(at.position.at(x, y)), normal(at.normal.at(x, y));
      if (beside.empty() || !(largest_cosine(scene, position, normal) > kLit)) continue;
      std::nth_element(beside.begin(), beside.begin() + std::ptrdiff_t(beside.size() / 2), beside.end());
      const float median = beside[beside.size() / 2];
      constexpr float kVisible = 1.0f / 255;  // below it all neighbours look black; such pixels pass
      const float ratio = median > kVisible ? luminance(picture.at(x, y)) / median : 1;
      ++out.pixels;
      out.darkest = std::min(out.darkest, ratio);
      if (ratio < 0.1f) out.below.emplace_back(x, y);
    }
  }
  return out;
}

enum class By { renderer, both };
void expect_lit(Device& device, const Scene& scene, const std::string& what, By by = By::both) {
  Scene unshadowed = scene;
  unshadowed.shadow = false;  // light falls on every surface that faces the light
  const PreparedScene prepared = prepare(unshadowed);
  const Geometry geometry(device, prepared);
  const auto check = [&](const Picture& picture, const char* maker) {
    const Silhouette found = lit_silhouette(prepared.scene, geometry, picture);
    EXPECT_EQ(found.below.size(), 0u) << what << ", " << maker << ": " << found.pixels
                                      << " pixels, the darkest " << found.darkest << " of its neighbours";
  };
  constexpr int kSamples = kRun;  // of an environment
  Renderer renderer(device, prepared);
  renderer.draw_samples(kSamples);
  check(picture_from(scene.camera.width, scene.camera.height, renderer.read_color()), "deferred");
  if (by == By::both) check(render_reference(prepared, {.samples = kSamples}), "reference");
}

// Loads a shipped scene with its picture reduced by `factor`, or by `thorough_factor` in ./test --full.
Scene small_scene(const std::filesystem::path& file, int factor, int thorough_factor) {
  Scene scene = load_scene(file);
  const int by = thorough() ? thorough_factor : factor;
  scene.camera.width /= by;
  scene.camera.height /= by;
  return scene;
}

TEST(Silhouette, NoPixelOfASceneInAnEnvironmentIsBlackWhereLightFallsOnIt) {
  Device device;
  for (const auto& file : std::filesystem::directory_iterator(BRDF_SOURCE_DIR "/data/scenes")) {
    if (file.path().extension() != ".json") continue;
    const Scene scene = small_scene(file.path(), 12, 4);  // sampling takes long
    if (!scene.environment) continue;
    expect_lit(device, scene, file.path().stem().string(), By::renderer);
  }
}

// Lit by lights alone, metal is black around its highlight. The same pixels are black in the reference's
// picture, and no other material is black.
TEST(Silhouette, InLightsAloneMetalIsBlackWhereTheReferenceIsTooAndNothingElse) {
  Device device;
  std::size_t black = 0, pixels = 0;
  for (const auto& file : std::filesystem::directory_iterator(BRDF_SOURCE_DIR "/data/scenes")) {
    if (file.path().extension() != ".json") continue;
    Scene scene = small_scene(file.path(), 2, 1);
    if (scene.environment) continue;
    scene.shadow = false;
    const PreparedScene prepared = prepare(scene);
    const Geometry geometry(device, prepared);
    Renderer renderer(device, prepared);
    renderer.draw();
    const Picture ours = picture_from(scene.camera.width, scene.camera.height, renderer.read_color()),
                  reference = render_reference(prepared);
    const Silhouette a = lit_silhouette(prepared.scene, geometry, ours, Of::all),
                     b = lit_silhouette(prepared.scene, geometry, reference, Of::all),
                     c = lit_silhouette(prepared.scene, geometry, ours);
    EXPECT_EQ(a.below, b.below) << file.path().stem();
    EXPECT_EQ(c.below.size(), 0u) << file.path().stem();
    black += a.below.size();
    pixels += std::size_t(a.pixels);
  }
  std::cout << black << " of " << pixels << " pixels are below a tenth of their neighbours\n";
  EXPECT_GT(black, 0u);
}

// Whatever the maps do to the normals, white paint is black at no pixel.
TEST(Silhouette, NoPixelOfAPaintedSceneIsBlackWhereLightFallsOnIt) {
  Device device;
  for (const char* name : {"rusty_metal", "rusty_metal_families", "car", "vase"}) {
    Scene scene = small_scene(std::string(BRDF_SOURCE_DIR "/data/scenes/") + name + ".json", 2, 1);
    scene.environment.reset();
    for (Object& object : scene.objects) {
      object.material = make_material(*find_form("lambert"));
      object.textures[std::size_t(TextureSlot::albedo)].reset();
      object.textures[std::size_t(TextureSlot::metallic)].reset();
    }
    expect_lit(device, scene, name);
  }
}

TEST(Silhouette, NoPixelOfAMaterialIsBlackWhereLightFallsOnIt) {
  Device device;
  const auto scene_of = [](const std::string& name, const Material& material, glm::ivec2 size) {
    Scene scene = material_scene({{name, material}});
    scene.camera.width = size.x;
    scene.camera.height = size.y;
    return scene;
  };
  for (const char* name : {"rolled_brass", "ivory_plastic", "glossy_grey_paper"}) {
    const Material material =
        io::read_material(std::string(BRDF_SOURCE_DIR "/data/materials/") + name + ".json");
    expect_lit(device, scene_of(name, material, {640, 360}), name);
    Scene studio = scene_of(name, material, thorough() ? glm::ivec2(240, 180) : glm::ivec2(80, 60));
    studio.lights.clear();
    studio.environment = Environment{std::string(name_of(Formula::studio))};
    expect_lit(device, studio, name + std::string(" in the studio"));
  }
  for (std::size_t k = 0; k < catalogue().size(); k += thorough() ? 1 : 5) {
    const Reflectance& form = catalogue()[k];
    expect_lit(device, scene_of(std::string(info(form).name), with_room(make_material(form)), {200, 200}),
               std::string(info(form).name));
  }
}

}  // namespace
}  // namespace brdf::render
