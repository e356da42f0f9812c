// The reference renderer against the closed form of a Lambertian sphere and against the material's own
// evaluation.
#include "render/reference/reference.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include "render/reference/surface_hit.h"
#include "tests/render/strangers.h"

namespace brdf::render {
namespace {

Scene small_scene(const Material& material) {
  Scene scene = material_scene({{"m", material}});
  scene.camera.width = scene.camera.height = 48;
  return scene;
}

TEST(Reference, LambertianSphereHasItsClosedForm) {
  Material material = make_material(*find_form("lambert"));
  Scene scene = small_scene(material);
  scene.ambient = glm::vec3(0.1f);
  const PreparedScene prepared = prepare(scene);
  const Picture picture = render_reference(prepared);
  const glm::vec3 to_light = glm::normalize(glm::vec3(-1, 1, 1));
  for (const auto& [x, y] : {std::pair{24, 24}, {12, 20}, {20, 8}}) {
    const float cosine = glm::dot(pixel_probe(prepared, x, y).normal, to_light);
    EXPECT_NEAR(picture.at(x, y).r, 0.5f * (0.1f + cosine), 1e-6f);
  }
  EXPECT_EQ(picture.at(0, 0).a, 0);
  EXPECT_EQ(picture.at(24, 24).a, 1);
}

TEST(Reference, EveryFormEqualsTheMaterialsOwnEvaluation) {
  for (const Reflectance& form : catalogue()) {
    Material material = make_material(form);
    material.terms[0].tangent_phi = radians(0.7);
    if (form.info().anisotropic()) {
      material.terms[0].shape[0][std::size_t(form.info().axes().along)] = 0.15;
    }
    const PreparedScene scene = prepare(small_scene(material));
    for (const auto& [x, y] : {std::pair{20, 17}, {24, 30}, {10, 14}}) {
      const PixelProbe at = pixel_probe(scene, x, y);
      ASSERT_TRUE(at.hit);
      // The directions of the probe are in the turned frame, in which an unturned material has the same
      // values.
      Material unturned = material;
      unturned.terms[0].tangent_phi = {};
      std::vector<double> f(3);
      eval(unturned, {at.wi.x, at.wi.y, at.wi.z}, {at.wo.x, at.wo.y, at.wo.z}, f);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(at.value[c], f[std::size_t(c)], 1e-4 * std::abs(f[std::size_t(c)]) + 1e-7)
            << form.info().name;
      }
    }
  }
}

// Measurements know the frame of the surface, not that of a material's tangent.
TEST(Reference, MeasurementsOfATurnedMaterialGiveThePictureOfTheMaterial) {
  const auto form = find_form("ward");
  Material material = make_material(*form);
  material.terms[0].shape[0][std::size_t(form->info().axes().along)] = 0.5;
  material.terms[0].tangent_phi = degrees(30);
  Scene scene = small_scene(material);
  scene.ambient = glm::vec3(0);
  const PreparedScene prepared = prepare(scene);
  const Measured measured = [&](const glm::vec3& wi, const glm::vec3& wo) {
    std::vector<double> f(3);
    eval_cos(material, {wi.x, wi.y, wi.z}, {wo.x, wo.y, wo.z}, f);
    return MeasuredValue(glm::vec3(f[0], f[1], f[2]));
  };
  const Picture expected = render_reference(prepared);
  EXPECT_LT(compare(render_reference(prepared, {.measured = &measured}), expected).rel_mse, 1e-8);
  // The turn is visible: without it, the picture of the material differs.
  scene.objects[0].material.terms[0].tangent_phi = {};
  EXPECT_GT(compare(render_reference(prepare(scene)), expected).rel_mse, 1e-3);
}

TEST(Reference, DrawsWhatIsNotInTheCatalogue) {
  // Seven weights of 0.1 and no GLSL: f_r is 0.7 everywhere, and ambient light has no effect because no
  // weight is diffuse.
  const PreparedScene plain = prepare(small_scene(make_material(Reflectance(std::make_shared<Plain>(7)))));
  const Picture picture = render_reference(plain);
  const float cosine = glm::dot(pixel_probe(plain, 24, 24).normal, glm::normalize(glm::vec3(-1, 1, 1)));
  EXPECT_NEAR(picture.at(24, 24).g, 0.7f * cosine * float(kPi), 1e-5f);
  // A grey material uses its only channel for all colours.
  const PreparedScene grey = prepare(small_scene(make_material(gleam(), {"fr"})));
  const PixelProbe at = pixel_probe(grey, 20, 20);
  std::vector<double> f(1);
  eval(grey.scene.objects[0].material, {at.wi.x, at.wi.y, at.wi.z}, {at.wo.x, at.wo.y, at.wo.z}, f);
  EXPECT_NEAR(at.value.b, f[0], 1e-5 * f[0]);
}

TEST(Reference, MapsDriveByRole) {
  // The rule depends on roles, not on names: the weight of a lobe without f0, a diffuse weight with a
  // specular one, and an exponent.
  const Reflectance form = gleam();
  const ReflectanceInfo& about = form.info();
  EXPECT_EQ(rule_of(about.weights[0], about), Rule::specular);
  EXPECT_EQ(rule_of(about.weights[1], about), Rule::diffuse);
  EXPECT_EQ(rule_of(about.shape[0], about), Rule::exponent);
  const ReflectanceInfo& lambert = find_form("lambert")->info();
  EXPECT_EQ(rule_of(lambert.weights[0], lambert), Rule::albedo);
}

TEST(Reference, NothingIsClippedForTheDefaultDisplay) {
  const Scene scene = small_scene(make_material(*find_form("cook_torrance")));
  const Picture picture = render_reference(prepare(scene));
  EXPECT_LT(clipped_share(picture, scene.tone_map, scene.exposure), 0.01);
}

}  // namespace
}  // namespace brdf::render
