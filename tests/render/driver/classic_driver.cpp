// The shading modes of the articles: their printed colours, their slips, and the convergence rate of
// per-vertex shading.
#include <gtest/gtest.h>

#include <cmath>

#include "render/gpu/lookup.h"
#include "render/gpu/renderer.h"
#include "render/scene/camera_view.h"
#include "tests/render/drawn.h"

namespace brdf::render {
namespace {

Material article_material(glm::vec3 color) {
  Material material = make_material(*find_form("lambert"));
  for (std::size_t c = 0; c < 3; ++c) material.terms[0].weights[c][0] = color[int(c)];
  return material;
}

Scene article_scene(const std::string& mesh, Shading shading) {
  Scene scene;
  scene.camera.width = scene.camera.height = 400;
  scene.ambient = glm::vec3(0.25f);
  scene.lights = {{false, {1, -1, -1}, glm::vec3(1), 0.75f}};
  Object object;
  object.mesh = mesh;
  object.material = article_material({0, 0.5f, 1});
  scene.objects.push_back(object);
  scene.shading = shading;
  scene.tone_map = ToneMap::none;
  return scene;
}

// The normal and the view direction on the exact sphere at a pixel.
struct OnSphere {
  bool hit = false;
  glm::dvec3 n, v;
};
OnSphere on_sphere(const Camera& camera, int x, int y) {
  const View view = make_view(camera);
  const glm::dvec3 d = glm::normalize(glm::dvec3(view.ray(pixel_center(x, y, camera.width, camera.height))));
  const glm::dvec3 o(camera.position);
  const double b = glm::dot(o, d), disc = b * b - glm::dot(o, o) + 1;
  if (disc < 0) return {};
  return {true, o + d * (-b - std::sqrt(disc)), -d};
}

double root_mean_square_error(const Picture& picture, const Scene& scene, bool highlight) {
  const glm::dvec3 l = glm::normalize(-glm::dvec3(scene.lights[0].vector));
  double sum = 0;
  int count = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const OnSphere at = on_sphere(scene.camera, x, y);
      // Only pixels at the front count. Near the limb, vertices behind it carry the colour of the back.
      if (!at.hit || picture.at(x, y).a < 0.5f || glm::dot(at.n, at.v) < 0.2) continue;
      const double exact = highlight
                               ? 0.75 * std::pow(std::max(0.0, glm::dot(at.n, glm::normalize(at.v + l))), 20)
                               : 0.25 + 0.75 * std::max(0.0, glm::dot(at.n, l));
      sum += std::pow(double(picture.at(x, y).b) - exact, 2);
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

double slope(const std::vector<double>& errors) {  // per factor of four in triangles
  return std::log(errors.back() / errors.front()) / std::log(4.0) / double(errors.size() - 1);
}

TEST(Classic, PrintedColoursHoldToEightBits) {
  Device device;
  Scene scene = article_scene("plane", Shading::gouraud);
  scene.camera.position = {0, 4, 0};
  scene.camera.up = {0, 0, -1};
  scene.lights[0].vector = {1, -1, 0};  // 45 degrees to the plane
  const glm::vec4 lit = drawn(device, scene).at(200, 200);
  EXPECT_EQ(lit.r, 0);
  EXPECT_NEAR(lit.g, 0.125 + 0.26, 0.006);  // printed to two digits
  EXPECT_NEAR(lit.b, 0.25 + 0.53, 0.003);
  EXPECT_NEAR(lit.b, 0.25 + 0.75 * std::sqrt(0.5), 1e-6);
  scene.lights[0].vector = {0, 1, 0};  // from below: ambient light alone
  const glm::vec4 dark = drawn(device, scene).at(200, 200);
  EXPECT_NEAR(dark.g, 0.125, 0.5 / 255);
  EXPECT_NEAR(dark.b, 0.25, 0.5 / 255);
  scene.camera.position = {0, -4, 0};  // from behind
  EXPECT_EQ(drawn(device, scene).at(200, 200), glm::vec4(0.5f, 0.5f, 0.5f, 1));
}

TEST(Classic, GouraudErrorFallsAsTheTriangleCountGrows) {
  Device device;
  std::vector<double> diffuse, highlight;
  for (const int level : {3, 4, 5, 6}) {  // 1,280 to 81,920 triangles
    const std::string mesh = "icosphere:" + std::to_string(level);
    const Scene scene = article_scene(mesh, Shading::gouraud);
    diffuse.push_back(root_mean_square_error(drawn(device, scene), scene, false));
    Scene shiny = article_scene(mesh, Shading::phong_blinn);
    shiny.per_vertex = true;
    shiny.ambient = glm::vec3(0);
    shiny.objects[0].material = article_material(glm::vec3(0));
    highlight.push_back(root_mean_square_error(drawn(device, shiny), shiny, true));
  }
  RecordProperty("diffuse_slope", std::to_string(slope(diffuse)));
  RecordProperty("highlight_slope", std::to_string(slope(highlight)));
  EXPECT_GE(slope(highlight), -1.15);
  EXPECT_LE(slope(highlight), -0.85);
  EXPECT_GE(slope(diffuse), -1.0);
  EXPECT_LE(slope(diffuse), -0.6);
  EXPECT_LT(diffuse[1], 3e-3);  // measured on 5,120 triangles: 1.2e-3
  EXPECT_GT(diffuse[1], 0.5e-3);
}

TEST(Classic, UnnormalisedPhongEqualsGouraudExceptAtTheClamp) {
  Device device;
  Scene scene = article_scene("icosphere:3", Shading::gouraud);
  scene.as_coded = true;
  const Picture gouraud = drawn(device, scene);
  scene.shading = Shading::phong;
  const Picture slip = drawn(device, scene);
  scene.as_coded = false;
  const Picture phong = drawn(device, scene);
  const glm::dvec3 l = glm::normalize(-glm::dvec3(scene.lights[0].vector));
  double away = 0, at_clamp = 0, renormalised = 0;
  for (int y = 0; y < scene.camera.height; ++y) {
    for (int x = 0; x < scene.camera.width; ++x) {
      const OnSphere at = on_sphere(scene.camera, x, y);
      if (!at.hit || glm::dot(at.n, at.v) < 0.25) continue;
      const double d = std::abs(gouraud.at(x, y).b - slip.at(x, y).b);
      (std::abs(glm::dot(at.n, l)) > 0.2 ? away : at_clamp) =
          std::max(std::abs(glm::dot(at.n, l)) > 0.2 ? away : at_clamp, d);
      renormalised = std::max(renormalised, double(std::abs(phong.at(x, y).b - slip.at(x, y).b)));
    }
  }
  EXPECT_LT(away, 2e-6);
  EXPECT_GT(at_clamp, 1e-3);
  EXPECT_GT(renormalised, 1e-3);
}

TEST(Classic, HalfVectorSlipIsEightDegreesOff) {
  // A unit view vector is added to a light vector of length sqrt(3). The article's code implies this angle.
  const glm::dvec3 v(0, 0, 1), l(-1, 1, 1);
  const double angle = std::acos(glm::dot(glm::normalize(v + l), glm::normalize(v + glm::normalize(l))));
  EXPECT_NEAR(angle * 180 / std::acos(-1.0), 7.9, 0.05);
  Device device;
  Scene scene = article_scene("icosphere:6", Shading::phong_blinn);
  const Picture right = drawn(device, scene);
  scene.as_coded = true;
  const Picture slip = drawn(device, scene);
  const auto brightest = [&](const Picture& p) {
    glm::dvec3 best(0);
    float most = 0;
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < p.width; ++x) {
        if (p.at(x, y).r <= most) continue;  // red contains only the highlight
        most = p.at(x, y).r;
        best = on_sphere(scene.camera, x, y).n;
      }
    }
    return best;
  };
  const double moved = std::acos(glm::dot(brightest(right), brightest(slip))) * 180 / std::acos(-1.0);
  EXPECT_GT(moved, 5);
  EXPECT_LT(moved, 14);  // the constant view vector increases the angle
}

TEST(Classic, TextSphereShowsItsFiveModes) {
  Device device;
  std::vector<Picture> pictures;
  for (const Shading shading :
       {Shading::vertex_color, Shading::flat, Shading::gouraud, Shading::phong, Shading::phong_blinn}) {
    pictures.push_back(drawn(device, article_scene("text:TEXT", shading)));
    std::size_t covered = 0;
    for (const glm::vec4& p : pictures.back().pixels) covered += p.a > 0.5f;
    EXPECT_GT(covered, 5000u) << kNames<Shading>[std::size_t(shading)];
  }
  for (std::size_t a = 0; a < pictures.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_EQ(compare(pictures[a], pictures[b]).coverage_mismatch, 0);
      EXPECT_GT(compare(pictures[a], pictures[b]).rel_mse, 1e-9) << a << " " << b;
    }
  }
}

TEST(Classic, LookupPictureShowsTheTable) {
  Device device;
  Scene scene = article_scene("icosphere:6", Shading::lookup);
  scene.objects[0].material = make_material(*find_form("cook_torrance"));
  scene.ambient = glm::vec3(0.1f);
  const Picture picture = drawn(device, scene);
  const std::vector<float> table = lookup_table(LookupFactor::product, false);
  const glm::dvec3 l = glm::normalize(-glm::dvec3(scene.lights[0].vector));
  double worst = 0;
  for (const auto& [x, y] : {std::pair{200, 200}, {150, 150}, {130, 170}, {220, 120}}) {
    const OnSphere at = on_sphere(scene.camera, x, y);
    const double nl = glm::dot(at.n, l), nh = glm::dot(at.n, glm::normalize(l + at.v));
    const float texel = table[std::size_t(int(nl * kLookupSize) * kLookupSize + int(nh * kLookupSize))];
    const double expected = 0.5 * (0.1 + 0.75 * nl) + 0.5 * 0.75 * double(texel);
    worst = std::max(worst, std::abs(expected - double(picture.at(x, y).r)));
  }
  EXPECT_LT(worst, 0.012);
  Scene coarse = scene;
  coarse.objects[0].mesh = "icosphere:2";
  const Picture per_pixel = drawn(device, coarse);
  coarse.per_vertex = true;
  EXPECT_GT(compare(drawn(device, coarse), per_pixel).rel_mse, 1e-6);
}

TEST(Classic, EveryModeIsSilentUnderTheValidationLayers) {
  Device device({.validation = true});
  for (std::size_t mode = 0; mode < kNames<Shading>.size(); ++mode) {
    for (const bool flag : {false, true}) {
      Scene scene = article_scene("icosphere:1", Shading(mode));
      scene.as_coded = scene.per_vertex = flag;
      scene.sky_zenith = glm::vec3(0.1f, 0.2f, 0.5f);
      drawn(device, scene);
    }
  }
  EXPECT_EQ(device.validation_messages(), 0u);
}

}  // namespace
}  // namespace brdf::render
