// The deferred renderer against the reference for every form, textures, sums of terms and several lights;
// its targets and its memory limit.
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/reflectance.h"
#include "io/files/error.h"
#include "render/gpu/held.h"
#include "render/gpu/renderer.h"
#include "render/proof/parity.h"
#include "render/reference/reference.h"
#include "tests/render/drawn.h"
#include "tests/thorough.h"

namespace brdf::render {
namespace {

Scene sphere_scene(const Material& material, int size = 256) {
  Scene scene = material_scene({{"m", material}});
  scene.camera.width = scene.camera.height = size;
  return scene;
}

TEST(Deferred, EveryFormEqualsTheReference) {
  Device device;
  const std::vector<Reflectance> forms(catalogue().begin(), catalogue().end());
  for (const ParityRow& row : parity(device, forms, thorough() ? 256 : 96)) {
    EXPECT_TRUE(passes(row)) << row.form << " " << row.parameters << " " << row.gbuffer_bits << " "
                             << row.difference.rel_mse;
  }
}

TEST(Deferred, TexturesDriveTheParametersAsInTheReference) {
  Device device;
  const PreparedScene scene = prepare(load_scene(BRDF_SOURCE_DIR "/data/scenes/rusty_metal_families.json"));
  const Difference difference = compare(drawn(device, scene, {.gbuffer_bits = 32}), render_reference(scene));
  EXPECT_LT(difference.rel_mse, 1e-5);
  EXPECT_LT(difference.coverage_mismatch, 1e-4);
}

TEST(Deferred, SumsAndPerChannelShapesAreAddedUp) {
  Material material = make_material(*find_form("cook_torrance"));
  material.terms.push_back(make_term(*find_form("ward"), 3));
  material.terms.push_back(make_term(*find_form("oren_nayar"), 3));
  const auto shape = material.terms[0].shape[0];
  material.terms[0].shape = {shape, shape, shape};
  material.terms[0].shape[1][0] = 0.1;
  material.terms[1].tangent_phi = radians(0.5);
  const PreparedScene scene = prepare(sphere_scene(material));
  Device device;
  EXPECT_LT(compare(drawn(device, scene, {.gbuffer_bits = 32}), render_reference(scene)).rel_mse, 1e-11);
}

// In pictures of 28 and of 12 spheres of any forms, a few silhouettes lie so close to a pixel's centre that
// rasteriser and ray tracer choose different surfaces.
constexpr std::size_t kInOnePicture = 25;

TEST(Deferred, SeveralFormsAndPointLightsShareOnePicture) {
  Device device;
  for (std::size_t first = 0; first < catalogue().size(); first += kInOnePicture) {
    std::vector<std::pair<std::string, Material>> row;
    for (std::size_t k = first; k < first + kInOnePicture; ++k) {
      // The last picture is filled up with the first forms, so that the spheres of all pictures lie alike.
      const Reflectance& form = catalogue()[k % catalogue().size()];
      row.emplace_back(info(form).name, with_room(make_material(form)));
    }
    Scene scene = material_scene(row);
    scene.camera.width = 512;
    scene.camera.height = 128;
    scene.sky_zenith = glm::vec3(0.2f, 0.4f, 0.8f);
    for (int k = 0; k < 7; ++k) scene.lights.push_back({true, {float(k) - 3, 2, 3}, {0.2f, 0.5f, 0.3f}, 4});
    const PreparedScene prepared = prepare(scene);
    const Picture picture = drawn(device, prepared, {.gbuffer_bits = 32});
    const Picture reference = render_reference(prepared);
    EXPECT_LT(compare(picture, reference).rel_mse, 3e-11);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(0, 0)[c], reference.at(0, 0)[c], 1e-5);  // the sky
    EXPECT_LT(compare(drawn(device, prepared, {.path = Path::forward}), reference).rel_mse, 3e-11);
  }
}

TEST(Deferred, ASampleElsewhereInThePixelIsTheReferences) {
  Device device;
  Scene scene = sphere_scene(make_material(*find_form("cook_torrance")));
  scene.camera.offset = {0.375f, -0.25f};
  const PreparedScene there = prepare(scene);
  scene.camera.offset = {};
  const Picture centres = render_reference(prepare(scene));
  const Picture picture = drawn(device, there, {.gbuffer_bits = 32}), reference = render_reference(there);
  const Difference difference = compare(picture, reference);
  EXPECT_LT(difference.rel_mse, 1e-11);
  EXPECT_LT(difference.coverage_mismatch, 1e-4);
  EXPECT_NEAR(picture.at(0, 0).r, reference.at(0, 0).r, 1e-6);  // the backdrop
  EXPECT_GT(compare(picture, centres).rel_mse, 1e-5);
}

TEST(Deferred, EightBitTargetsAreCoarseButRight) {
  const PreparedScene scene = prepare(sphere_scene(make_material(*find_form("cook_torrance"))));
  Device device;
  const Difference byte = compare(drawn(device, scene, {.gbuffer_bits = 8}), render_reference(scene));
  EXPECT_LT(byte.rel_mse, 1e-3);
  EXPECT_GT(byte.rel_mse, 1e-6);
}

TEST(Deferred, ValidationAndSynchronisationLayersAreSilent) {
  Device device({.validation = true});
  Material material = make_material(*find_form("cook_torrance"));
  material.terms.push_back(make_term(*find_form("ward"), 3));
  const PreparedScene scene = prepare(sphere_scene(material, 64));
  for (const int bits : {8, 16, 32}) {
    Renderer renderer(device, scene, {.gbuffer_bits = bits});
    renderer.draw();
    renderer.draw();
    for (int k = 0; k < kTargetCount; ++k) renderer.read_target(Target(k));
    renderer.read_color();
  }
  const PreparedScene plain = prepare(sphere_scene(make_material(*find_form("phong")), 64));
  drawn(device, plain, {.path = Path::forward});
  EXPECT_EQ(device.validation_messages(), 0u);
}

TEST(Deferred, TooLargeForTheMemoryLimitIsRefusedBeforeAnythingIsAllocated) {
  Device device({.memory_limit = 1u << 30});
  const PreparedScene scene = prepare(sphere_scene(make_material(*find_form("lambert")), 16384));
  try {
    Renderer renderer(device, scene, {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("16384 x 16384 needs"), std::string::npos);
  }
  EXPECT_EQ(device.memory_used(), 0u);
}

}  // namespace
}  // namespace brdf::render
