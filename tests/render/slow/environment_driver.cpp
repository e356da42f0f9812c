// Light from all around, deferred and reference, with as many samples as the bounds require. Takes minutes.
#include <iostream>

#include "render/gpu/renderer.h"
#include "tests/render/furnace.h"
#include "tests/render/lit_spheres.h"

namespace brdf::render {
namespace {

constexpr int kPictures = 64, kFurnaceSamples = 160;

template <class Furnace>
void expect_every_form_white(Furnace&& furnace_of) {
  WhiteFurnace furnace(0.005);
  for (const Reflectance& form : conserving_forms()) {
    const std::string name(form.info().name);
    const FurnaceFindings found = furnace_of(sphere_in(make_material(form), "uniform"));
    std::cout << name << ": " << in_words(found) << std::endl;
    furnace.add(name, found);
  }
}

TEST(EnvironmentSlow, WhiteFurnaceOfTheReference) {
  expect_every_form_white(
      [](const PreparedScene& scene) { return reference_furnace(scene, kPictures, kFurnaceSamples); });
}

TEST(EnvironmentSlow, WhiteFurnaceOfTheDeferredRenderer) {
  Device device;
  expect_every_form_white([&](const PreparedScene& scene) {
    return deferred_furnace(device, scene, kPictures, kFurnaceSamples);
  });
}

// Whole spheres, to the grazing rim: 256 samples against 16,384 samples of the reference. The printed times
// are of the last run of 16 samples.
void expect_pictures_equal(const std::string& picture) {
  constexpr int kSize = 16;
  Device device;
  for (const auto& [name, material] : compared_materials()) {
    const PreparedScene scene = sphere_in(material, picture, kSize, 30);
    Timestamps times(device, 64);
    Renderer renderer(device, scene, {.gbuffer_bits = 32});
    renderer.draw_samples(256, &times);
    const Picture drawn = picture_from(kSize, kSize, renderer.read_color());
    const Difference difference = compare(drawn, render_reference(scene, {.samples = 16384, .seed = 77}));
    EXPECT_EQ(difference.coverage_mismatch, 0);
    EXPECT_GT(difference.rel_mse, 0);
    EXPECT_LE(difference.rel_mse, 1e-3) << name;
    std::cout << name << ": relative MSE " << difference.rel_mse << times_in_words(times) << std::endl;
  }
}

TEST(EnvironmentSlow, DeferredPicturesInTheStudioEqualTheReferences) {
  expect_pictures_equal("studio");
}

TEST(EnvironmentSlow, DeferredPicturesUnderASunEqualTheReferences) {
  const io::TemporaryFolder folder;
  expect_pictures_equal(write_sky_with_sun(folder.path() / "sun.exr", 512));
}

}  // namespace
}  // namespace brdf::render
