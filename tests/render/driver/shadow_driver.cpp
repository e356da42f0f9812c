// The shadow of the first directional light, traced by the reference and computed with a shadow map in the
// renderer.
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/reflectance.h"
#include "render/gpu/renderer.h"
#include "render/reference/reference.h"
#include "render/scene/camera_view.h"
#include "tests/render/drawn.h"
#include "tests/thorough.h"

namespace brdf::render {
namespace {

// A ball of radius 1/2 that floats above a ground at height 0, seen and lit from above.
Scene ball_over_ground(const glm::vec3& light) {
  Scene scene;
  const Material grey = make_material(*find_form("lambert"));
  for (const char* mesh : {"sphere", "plane"}) {
    Object object;
    object.mesh = mesh;
    object.material = grey;
    scene.objects.push_back(object);
  }
  scene.objects[0].position = {0, 1, 0};
  scene.objects[0].scale = glm::vec3(0.5f);
  scene.objects[1].scale = {4, 1, 4};
  scene.camera = {
      .position = {0, 6, 6}, .target = {0, 0.3f, 0}, .up = {0, 1, 0}, .width = 200, .height = 200};
  scene.lights.push_back({false, light, glm::vec3(1), float(kPi)});
  scene.shadow = true;
  return scene;
}

TEST(Shadow, LiesWhereTheBallHidesTheSun) {
  const Scene scene = ball_over_ground({0.5f, -1, 0.25f});
  const PreparedScene prepared = prepare(scene);
  const Picture reference = render_reference(prepared);
  const glm::vec3 to_light = -glm::normalize(scene.lights[0].vector);
  const View view = make_view(scene.camera);
  int inside = 0, outside = 0;
  // Returns the distance at which a line passes the ball's centre.
  const auto past_ball = [&](const glm::vec3& from, const glm::vec3& along) {
    const glm::vec3 offset = scene.objects[0].position - from, way = glm::normalize(along);
    return glm::length(offset - way * glm::dot(offset, way));
  };
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const glm::vec3 ray = view.ray(pixel_center(x, y, 200, 200));
      const glm::vec3 at = view.position - ray * (view.position.y / ray.y);  // on the ground
      if (std::max(std::abs(at.x), std::abs(at.z)) > 3.9f || past_ball(view.position, ray) < 0.51f) continue;
      const float distance = past_ball(at, to_light);
      if (std::abs(distance - 0.5f) < 0.01f) continue;
      const bool dark = reference.at(x, y).r == 0;
      EXPECT_EQ(dark, distance < 0.5f) << x << ", " << y;
      ++(dark ? inside : outside);
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 5000);
}

struct Apart {
  double edges = 0;    // share of the surface that differs by more than 1 %
  double rel_mse = 0;  // of the other pixels
};

Apart apart(const Picture& picture, const Picture& reference) {
  Apart out;
  int surface = 0, edges = 0;
  Picture a = picture;
  for (std::size_t k = 0; k < a.pixels.size(); ++k) {
    if (!is_surface(reference.pixels[k]) || !is_surface(a.pixels[k])) continue;
    ++surface;
    const glm::vec3 difference = glm::abs(glm::vec3(a.pixels[k]) - glm::vec3(reference.pixels[k]));
    if (std::max({difference.r, difference.g, difference.b}) <=
        0.01f * std::max(reference.pixels[k].g, 0.01f))
      continue;
    ++edges;
    a.pixels[k].a = 0;
  }
  out.edges = double(edges) / surface;
  out.rel_mse = compare(a, reference).rel_mse;
  return out;
}

// This test is separate from parity because only a shadow map has texels: the edges of shadows differ from
// traced edges.
TEST(Shadow, TheMapDiffersFromTheRayAtTheShadowsEdgesAlone) {
  Device device;
  const auto check = [&](const Scene& scene, const std::string& name, double most) {
    const PreparedScene prepared = prepare(scene);
    const Picture reference = render_reference(prepared);
    for (const RendererOptions& options :
         {RendererOptions{.gbuffer_bits = 32}, RendererOptions{.gbuffer_bits = 16}}) {
      const Apart found = apart(drawn(device, prepared, options), reference);
      EXPECT_GT(found.edges, 1e-4) << name;
      EXPECT_LT(found.edges, most) << name;
      EXPECT_LT(found.rel_mse, 1e-6) << name;
    }
  };
  check(ball_over_ground({0.5f, -1, 0.25f}), "ball", 0.001);
  for (const std::string name : {"vase", "car"}) {
    if (name == "car" && !thorough()) continue;
    Scene scene = load_scene(BRDF_SOURCE_DIR "/data/scenes/" + name + ".json");
    scene.environment.reset();  // the noise of an environment would hide the edges
    check(scene, name, 0.015);
  }
}

TEST(Shadow, WithoutItNothingChangesAndALampCastsNone) {
  Device device;
  Scene scene = ball_over_ground({0.5f, -1, 0.25f});
  scene.shadow = false;
  const PreparedScene plain = prepare(scene);
  const Picture lit = render_reference(plain);
  EXPECT_LT(compare(drawn(device, plain, {.gbuffer_bits = 32}), lit).rel_mse, 1e-11);
  scene.shadow = true;
  EXPECT_GT(compare(render_reference(prepare(scene)), lit).rel_mse, 1e-4);
  scene.lights = {{true, {0, 3, 0}, glm::vec3(1), 4}};  // a point light
  scene.shadow = false;
  const Picture lamp = render_reference(prepare(scene));
  scene.shadow = true;
  EXPECT_EQ(render_reference(prepare(scene)).pixels, lamp.pixels);
}

TEST(Shadow, IsSilentUnderTheValidationLayersForwardToo) {
  Device device({.validation = true});
  const PreparedScene scene = prepare(ball_over_ground({0.5f, -1, 0.25f}));
  const Picture deferred = drawn(device, scene, {.gbuffer_bits = 32}),
                forward = drawn(device, scene, {.path = Path::forward});
  EXPECT_LT(compare(deferred, forward).rel_mse, 1e-6);
  EXPECT_EQ(device.validation_messages(), 0u);
}

}  // namespace
}  // namespace brdf::render
