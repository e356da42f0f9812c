#include "trade/questions/frames.h"

#include <cmath>

#include "trade/questions/ball.h"
#include "trade/questions/materials.h"
#include "trade/questions/names.h"

namespace brdf::trade {
namespace {

using render::Scene;
using render::Shading;

// The light and colours of the pixel-shader article, on a sphere.
Scene article(const std::string& mesh, Shading shading, bool as_coded, int size) {
  Scene scene = material_ball(size);
  scene.ambient = glm::vec3(0.25f);
  scene.lights[0].intensity = 0.75f;
  scene.objects[0].mesh = mesh;
  Term& term = scene.objects[0].material.terms[0];
  const auto diffuse = std::size_t(info(term.form).weight_index(Role::diffuse));
  for (std::size_t c = 0; c < 3; ++c) term.weights[c][diffuse] = 0.5 * double(c);
  scene.shading = shading;
  scene.as_coded = as_coded;
  return scene;
}

int triangles_of(int level) {
  return 20 << (2 * level);
}

// Excludes the limb: at the limb, vertices of the far side contribute, and the limb of a mesh differs from
// that of a sphere.
Pixels front_pixels(int size) {
  return
      [size](int x, int y) { return std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0) < 0.42 * size; };
}

// Moves the light almost behind the sphere, which makes all lit directions grazing.
void light_from_behind(Scene& scene) {
  for (render::Light& light : scene.lights) light.vector = {0.25f, -0.3f, 1};
}

// Shading per vertex and per pixel, judged by the finest mesh shaded per pixel.
FrameQuestion shading_question(bool highlight, FrameDetail detail) {
  const int size = detail == FrameDetail::quick ? 200 : 400;
  const std::vector<int> levels =
      detail == FrameDetail::quick ? std::vector<int>{2, 3, 4} : std::vector<int>{2, 3, 4, 5, 6};
  FrameQuestion q{highlight ? names::kHighlightShading : names::kDiffuseShading,
                  "the article's sphere, " + std::to_string(size) + " pixels wide, front pixels",
                  {}};
  const auto add = [&](const char* name, int level, Shading shading, bool as_coded, bool per_vertex) {
    Way way{names::triangles(triangles_of(level), name),
            article("icosphere:" + std::to_string(level), shading, as_coded, size),
            {}};
    way.scene.per_vertex = per_vertex;
    q.ways.push_back(std::move(way));
  };
  add("per pixel", detail == FrameDetail::quick ? 6 : 7, highlight ? Shading::phong_blinn : Shading::phong,
      false, false);
  for (int level : levels) {
    if (!highlight) {
      add("vertex colours", level, Shading::vertex_color, false, false);
      add("flat", level, Shading::flat, false, false);
      add(names::kGouraud, level, Shading::gouraud, false, false);
      add(names::kPhongAsCoded, level, Shading::phong, true, false);
      add(names::kPhong, level, Shading::phong, false, false);
    } else {
      add(names::kHighlightAsCoded, level, Shading::phong_blinn, true, false);
      add("highlight per vertex", level, Shading::phong_blinn, false, true);
      add("highlight per pixel", level, Shading::phong_blinn, false, false);
    }
  }
  q.of = front_pixels(size);
  q.extremes = {{"the limb too"}, {"light from behind, the limb too", light_from_behind}};
  return q;
}

// The reference form on the ball, in a frame of 16 : 9.
Scene frame_scene(int lights, FrameDetail detail) {
  Scene scene = material_ball(360);
  const bool quick = detail == FrameDetail::quick;
  scene.camera.width = quick ? 320 : 640;
  scene.camera.height = quick ? 180 : 360;
  scene.objects[0].material = make_material(reference_form());
  scene.lights.clear();
  for (int k = 0; k < lights; ++k) {
    const float turn = 2.3999632f * float(k);  // the golden angle
    scene.lights.push_back({false,
                            {std::cos(turn), -0.5f - 0.5f * float(k % 3), std::sin(turn) - 1.2f},
                            glm::vec3(1),
                            float(kPi) / float(lights)});
  }
  return scene;
}

std::string frame_domain(const Scene& scene) {
  return std::to_string(scene.camera.width) + " x " + std::to_string(scene.camera.height) + ", " +
         std::to_string(scene.lights.size()) + (scene.lights.size() == 1 ? " light" : " lights") +
         ", 50,176 triangles, " + std::string(names::kReferenceForm);
}

void narrow(Scene& scene) {
  set_parameter(scene.objects[0].material, Role::width, 0.01);
}
const std::vector<FrameExtreme> kFrameExtremes{{"alpha 0.01", narrow},
                                               {"light from behind", light_from_behind}};

FrameQuestion bits_question(double alpha, FrameDetail detail) {
  Scene scene = frame_scene(1, detail);
  set_parameter(scene.objects[0].material, Role::width, alpha);
  FrameQuestion q{names::bits(alpha), frame_domain(scene), {}};
  for (int bits : {32, 16, 8})
    q.ways.push_back({bits == 8 ? names::kEightBits : std::to_string(bits) + " bits",
                      scene,
                      {bits, render::Path::deferred, {}}});
  q.extremes = kFrameExtremes;
  return q;
}

FrameQuestion lights_question(int lights, FrameDetail detail) {
  const Scene scene = frame_scene(lights, detail);
  FrameQuestion q{names::lights(lights),
                  frame_domain(scene),
                  {{"forward", scene, {32, render::Path::forward, {}}},
                   {"deferred, 32 bits", scene, {32, render::Path::deferred, {}}},
                   {names::kDeferred16, scene, {16, render::Path::deferred, {}}}}};
  q.extremes = kFrameExtremes;
  return q;
}

// The article's material, evaluated or looked up, with coordinates per pixel or per vertex.
FrameQuestion lookup_question(FrameDetail detail) {
  const int size = detail == FrameDetail::quick ? 256 : 512;
  constexpr int kLevel = 4;
  FrameQuestion q{"lookup texture in a frame",
                  "the article's material on a sphere of 5120 triangles, " + std::to_string(size) +
                      " pixels wide, front pixels",
                  {}};
  q.of = front_pixels(size);
  const auto add = [&](std::string name, int level, const render::LookupTexture& texture, bool per_vertex) {
    Way way{std::move(name), material_ball(size), {32, render::Path::deferred, texture}};
    render::Object& object = way.scene.objects[0];
    object.mesh = "icosphere:" + std::to_string(level);
    object.material = make_material(named_form(names::kArticleForm));
    set_parameter(object.material, Role::width, 0.3);
    set_parameter(object.material, Role::index, 1.5);
    way.scene.shading = Shading::lookup;
    way.scene.per_vertex = per_vertex;
    q.ways.push_back(std::move(way));
    return &q.ways.back().scene;
  };
  Scene* const evaluated = add("evaluated", kLevel, {}, false);
  evaluated->shading = Shading::brdf;
  // The article's light of 1 corresponds to pi here, since Cm n.l Cd lacks the factor 1/pi.
  evaluated->lights[0].intensity = float(kPi);
  const bool quick = detail == FrameDetail::quick;
  for (int texels : quick ? std::vector{32, 128, 512} : std::vector{32, 64, 128, 256, 512, 1024})
    for (int bits : {8, 16, 32})
      for (bool bilinear : {false, true})
        for (bool per_vertex : {false, true})
          add(names::texels(texels, bits, bilinear ? "bilinear" : "nearest") +
                  (per_vertex ? ", per vertex" : ", per pixel"),
              kLevel, {texels, bits, bilinear}, per_vertex);
  for (int level : {2, 6})
    add("512^2, 8 bit, bilinear, per vertex, " + std::to_string(triangles_of(level)) + " triangles", level,
        {}, true);
  add("512^2, 8 bit, bilinear, per pixel, the slip", kLevel, {}, false)->as_coded = true;
  q.extremes = {{"the limb too"}, {"light from behind, the limb too", light_from_behind}};
  return q;
}

}  // namespace

std::vector<FrameQuestion> frame_questions(FrameDetail detail) {
  std::vector<FrameQuestion> questions{shading_question(false, detail), shading_question(true, detail)};
  for (double alpha : {0.3, 0.05}) questions.push_back(bits_question(alpha, detail));
  for (int lights : {1, 4, 16, 64}) questions.push_back(lights_question(lights, detail));
  questions.push_back(lookup_question(detail));
  return questions;
}

}  // namespace brdf::trade
