// Reflectances that are not in the catalogue. Their shaders are compiled when they are drawn.
#include <gtest/gtest.h>

#include "io/files/error.h"
#include "render/gpu/renderer.h"
#include "render/proof/parity.h"
#include "render/proof/shader_proof.h"
#include "render/reference/reference.h"
#include "tests/render/strangers.h"

namespace brdf::render {
namespace {

std::string refusal(const Reflectance& reflectance) {
  Scene scene = material_scene({{"m", make_material(reflectance)}});
  scene.camera.width = scene.camera.height = 16;
  try {
    Device device;
    Renderer renderer(device, prepare(scene), {});
    renderer.draw();
  } catch (const InputError& error) {
    return error.what();
  }
  return "drawn";
}

TEST(Strangers, AreDrawnBesideTheCatalogue) {
  Scene scene = material_scene({{"a", make_material(gleam())},
                                {"b", make_material(*find_form("ward"))},
                                {"c", make_material(glint())},
                                {"d", make_material(gleam())}});
  scene.camera.width = 512;
  scene.camera.height = 128;
  scene.objects[3].material.terms.push_back(make_term(glint(), 3));
  Device device;
  const auto against_reference = [&](const RendererOptions& options) {
    const PreparedScene prepared = prepare(scene);
    Renderer renderer(device, prepared, options);
    renderer.draw();
    const Picture picture = picture_from(512, 128, renderer.read_color());
    const Picture reference = render_reference(prepared);
    EXPECT_GT(reference.at(64, 64).r, 0.03f);
    return compare(picture, reference).rel_mse;
  };
  EXPECT_LT(against_reference({.gbuffer_bits = 32}), 1e-11);
  EXPECT_LT(against_reference({.gbuffer_bits = 16}), 1e-6);
  scene.objects.pop_back();  // the forward path does not draw sums of terms
  EXPECT_LT(against_reference({.path = Path::forward}), 1e-11);
}

TEST(Strangers, AreDrawnByARendererThatBeganWithoutThem) {
  Scene scene = material_scene({{"a", make_material(*find_form("ward"))}});
  scene.camera.width = scene.camera.height = 64;
  PreparedScene prepared = prepare(scene);
  Device device;
  Renderer renderer(device, prepared, {.gbuffer_bits = 32});
  for (const Reflectance& form : {gleam(), glint(), gleam()}) {
    prepared.scene.objects[0].material = make_material(form);
    update_items(prepared);
    renderer.update(prepared);
    renderer.draw();
    EXPECT_LT(compare(picture_from(64, 64, renderer.read_color()), render_reference(prepared)).rel_mse,
              1e-11);
  }
}

TEST(Strangers, PassParityAndProof) {
  Device device;
  const std::vector<Reflectance> forms{gleam(), glint()};
  const std::vector<ParityRow> rows = parity(device, forms, 128);
  EXPECT_EQ(rows.size(), 8u);  // an exponent makes a lobe narrow
  for (const ParityRow& row : rows)
    EXPECT_TRUE(passes(row)) << row.parameters << " " << row.difference.rel_mse;
  for (const ProofRow& row : shader_proof(device, forms, {.random = 1 << 14})) {
    EXPECT_EQ(row.differing, 0u) << row.max_ulp;
    EXPECT_GT(row.count, 1u << 14);
  }
}

TEST(Strangers, OnesWithoutAShaderAreRefusedInOneSentence) {
  EXPECT_EQ(refusal(Reflectance(std::make_shared<Plain>(1))),
            "plain has no GLSL: the Vulkan renderer cannot draw it");
  EXPECT_EQ(
      refusal(Reflectance(std::make_shared<Plain>(4, "some"))),
      "plain has more than 3 weights per channel or 3 shape parameters: the Vulkan renderer cannot draw it");
  const std::string broken = refusal(Reflectance(std::make_shared<Plain>(1, "vec3 brdf_eval_plain(")));
  EXPECT_EQ(broken.find("plain: its GLSL does not compile: "), 0u) << broken;
  EXPECT_EQ(broken.find('\n'), std::string::npos) << broken;
  Device device;
  EXPECT_THROW(shader_proof(device, std::vector{Reflectance(std::make_shared<Plain>(1))}), InputError);
}

}  // namespace
}  // namespace brdf::render
