#include "render/reference/reference.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include "render/reference/surface_hit.h"

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
    const float cosine = glm::dot(probe(prepared, x, y).normal, to_light);
    EXPECT_NEAR(picture.at(x, y).r, 0.5f * (0.1f + cosine), 1e-6f);
  }
  EXPECT_EQ(picture.at(0, 0).a, 0);
  EXPECT_EQ(picture.at(24, 24).a, 1);
}

TEST(Reference, EveryFormEqualsTheMaterialsOwnEvaluation) {
  for_each_form([&](auto form) {
    Material material = make_material(form);
    material.terms[0].tangent_phi = radians(0.7);
    if (info(form).anisotropic()) {
      material.terms[0].shape[0][std::size_t(info(form).axes().along)] = 0.15;
    }
    const PreparedScene scene = prepare(small_scene(material));
    for (const auto& [x, y] : {std::pair{20, 17}, {24, 30}, {10, 14}}) {
      const Probe at = probe(scene, x, y);
      ASSERT_TRUE(at.hit);
      // The probe's directions are in the turned frame: an unturned material has the same values there.
      Material unturned = material;
      unturned.terms[0].tangent_phi = {};
      std::vector<double> f(3);
      eval(unturned, {at.wi.x, at.wi.y, at.wi.z}, {at.wo.x, at.wo.y, at.wo.z}, f);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(at.value[c], f[std::size_t(c)], 1e-4 * std::abs(f[std::size_t(c)]) + 1e-7)
            << info(form).name;
      }
    }
  });
}

TEST(Reference, NothingIsClippedForTheDefaultDisplay) {
  const Scene scene = small_scene(make_material(*find_form("cook_torrance")));
  const Picture picture = render_reference(prepare(scene));
  EXPECT_LT(clipped_share(picture, scene.tone_map, scene.exposure), 0.01);
}

}  // namespace
}  // namespace brdf::render
