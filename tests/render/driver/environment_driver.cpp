// Environment light in the deferred renderer against directional albedos, a directional light, and the
// reference.
#include <gtest/gtest.h>

#include "io/files/error.h"
#include "render/gpu/renderer.h"
#include "tests/render/lit_spheres.h"
#include "tests/render/strangers.h"

namespace brdf::render {
namespace {

Picture lit(Device& device, const PreparedScene& scene, int samples, std::uint32_t seed = 1) {
  Renderer renderer(device, scene, {.gbuffer_bits = 32, .seed = seed});
  renderer.draw_samples(samples);
  EXPECT_EQ(renderer.samples(), (samples + kRun - 1) / kRun * kRun);
  return picture_from(scene.scene.camera.width, scene.scene.camera.height, renderer.read_color());
}

Material narrow_material(double along, double across) {
  const auto form = find_form_if([](const ReflectanceInfo& info) {
    return info.canonical && info.facets != nullptr && info.follows_lobe;
  });
  Material material = make_material(*form);
  set_width(material.terms[0], along, across);
  return material;
}

// Returns the relative mean square error of two pictures that cover the same pixels.
double relative_mse(const Picture& picture, const Picture& reference) {
  const Difference difference = compare(picture, reference);
  EXPECT_EQ(difference.coverage_mismatch, 0);
  EXPECT_GT(difference.rel_mse, 0);
  return difference.rel_mse;
}

// Tests one form of each sampler family. The slow test covers all forms.
TEST(Environment, UniformLightShowsTheAlbedoInTheDeferredRenderer) {
  Device device;
  WhiteFurnace furnace(0.05);
  for (const std::vector<Reflectance>& family : families(conserving_forms()))
    furnace.add(std::string(family[0].info().name),
                deferred_furnace(device, sphere_in(make_material(family[0]), "uniform"), 32, 16));
}

TEST(Environment, ASunOfOnePixelIsADirectionalLight) {
  const io::TemporaryFolder folder;
  const OnePixelSun sun = write_one_pixel_sun(folder.path() / "sun.exr", 4096);
  Device device;
  for (const auto& [along, across] : {std::pair{0.1, 0.1}, {0.15, 0.5}}) {
    const Material material = narrow_material(along, across);
    const PreparedScene lit_by_sun = sphere_in(material, sun.file, 64);
    Scene direct = lit_by_sun.scene;
    direct.environment.reset();
    direct.background = glm::vec3(0);
    direct.lights.push_back({false, -sun.toward, glm::vec3(1), float(sun.irradiance)});
    const Picture truth = render_reference(prepare(direct));
    EXPECT_LE(worst_block(lit(device, lit_by_sun, 16), truth), 0.01) << along;
    EXPECT_LE(worst_block(render_reference(lit_by_sun, {.samples = 16}), truth), 0.01) << along;
  }
}

TEST(Environment, TheDeferredPictureConvergesToTheReferences) {
  Device device;
  Scene scene = sphere_in(narrow_material(0.1, 0.3), "studio", 24).scene;
  scene.environment->rotation = 70;
  scene.environment->intensity = 0.5f;
  scene.objects[0].material.terms.push_back(make_term(scene.objects[0].material.terms[0].form, 3));
  const PreparedScene sum = prepare(scene);  // a sum of two terms uses two layers
  const Picture reference = render_reference(sum, {.samples = 4096, .seed = 9});
  EXPECT_LE(relative_mse(lit(device, sum, 256), reference), 1e-3);
  // The estimate of the remaining error: the sum of its squares lies between 1/2 and 30 times the sum of
  // the actual squared errors.
  Renderer renderer(device, sum, {.gbuffer_bits = 32});
  renderer.draw_samples(128);
  const Picture drawn = picture_from(24, 24, renderer.read_color()),
                error = picture_from(24, 24, renderer.read_standard_error());
  double told = 0, found = 0;
  for (std::size_t k = 0; k < drawn.pixels.size(); ++k) {
    told += double(error.pixels[k].g * error.pixels[k].g);
    found += std::pow(double(drawn.pixels[k].g - reference.pixels[k].g), 2);
  }
  EXPECT_GT(told, found / 2);
  EXPECT_LT(told, found * 30);
}

TEST(Environment, IsForgottenWhenTheSceneChanges) {
  Device device;
  PreparedScene scene = sphere_in(narrow_material(0.3, 0.3), "studio", 16);
  Renderer renderer(device, scene, {.gbuffer_bits = 32});
  renderer.draw_samples(64);
  const std::vector<float> before = renderer.read_color();
  scene.scene.environment->intensity = 2;
  renderer.update(scene);
  EXPECT_EQ(renderer.samples(), 0);
  renderer.draw_samples(64);
  const std::vector<float> after = renderer.read_color();
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NEAR(after[k], (k % 4 == 3 ? 1.0f : 2.0f) * before[k], 1e-4f + 1e-3f * before[k]);
}

TEST(Environment, ThePictureStandsBehindTheObjects) {
  Device device;
  Scene scene = sphere_in(narrow_material(0.3, 0.3), "studio", 48).scene;
  scene.camera.vertical_fov = 80;
  const PreparedScene wide = prepare(scene);
  const Picture drawn = lit(device, wide, 16), reference = render_reference(wide, {.samples = 16});
  for (std::size_t k = 0; k < drawn.pixels.size(); ++k) {
    if (is_surface(reference.pixels[k])) continue;
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(drawn.pixels[k][c], reference.pixels[k][c], 0.002f + 0.01f * reference.pixels[k][c]);
  }
  scene.environment->shown = false;
  scene.background = glm::vec3(0.25f);
  scene.backdrop_top.reset();
  EXPECT_EQ(lit(device, prepare(scene), 16).at(0, 0), glm::vec4(0.25f, 0.25f, 0.25f, 0));
}

// The floor darkens next to two balls of different size, in the background and in what the balls reflect.
TEST(Environment, TheFloorIsTheReferences) {
  Device device;
  Scene scene = sphere_in(narrow_material(0.2, 0.2), "studio", 32).scene;
  scene.camera.vertical_fov = 60;
  scene.camera.position = {0, 2, 4};
  scene.objects.push_back(scene.objects[0]);
  scene.objects[1].position = {1.6f, -0.4f, 0};
  scene.objects[1].scale = glm::vec3(0.6f);
  const PreparedScene open = prepare(scene);
  scene.environment->floor = -1.0f;
  const PreparedScene standing = prepare(scene);
  const Picture drawn = lit(device, standing, 256), without = lit(device, open, 256),
                reference = render_reference(standing, {.samples = 2048, .seed = 5});
  EXPECT_LE(relative_mse(drawn, reference), 2e-3);
  EXPECT_GT(relative_mse(without, reference), 5e-3);
  double darkest = 1;
  for (std::size_t k = 0; k < drawn.pixels.size(); ++k) {
    if (is_surface(reference.pixels[k])) continue;
    EXPECT_NEAR(drawn.pixels[k].g, reference.pixels[k].g, 0.002f + 0.01f * reference.pixels[k].g);
    darkest = std::min(darkest, double(drawn.pixels[k].g / without.pixels[k].g));
  }
  EXPECT_LT(darkest, 0.5);  // the contact shadow
}

// One form has GLSL but no sampler, so only light directions and cosine-distributed directions are sampled.
TEST(Environment, LightsWhatIsNotInTheCatalogue) {
  const std::string glsl =
      "vec3 brdf_eval_plain(vec3 wi, vec3 wo, vec3 part) { return wi.z > 0.0 && wo.z > 0.0 ? part : "
      "vec3(0.0); }\n"
      "vec3 brdf_eval_cos_plain(vec3 wi, vec3 wo, vec3 part) { return brdf_eval_plain(wi, wo, part) * wi.z; "
      "}\n";
  Device device;
  for (const Reflectance& form : {Reflectance(std::make_shared<Plain>(1, glsl)), gleam()}) {
    const PreparedScene scene = sphere_in(make_material(form), "studio", 24);
    EXPECT_LE(relative_mse(lit(device, scene, 512), render_reference(scene, {.samples = 2048, .seed = 5})),
              1e-3)
        << form.info().name;
  }
}

TEST(Environment, NeedsTheDeferredPath) {
  Device device;
  const PreparedScene scene = sphere_in(narrow_material(0.3, 0.3), "studio");
  EXPECT_THROW(Renderer(device, scene, {.path = Path::forward}), InputError);
}

}  // namespace
}  // namespace brdf::render
