// The shaders and the library agree bit for bit on the software driver, and the negative controls do not.
#include <algorithm>

#include <gtest/gtest.h>

#include "brdf/forms.h"
#include "render/proof/shader_proof.h"
#include "tests/render/contracted.h"

namespace brdf::render {
namespace {

constexpr std::uint32_t kUnprecise[] =
#include "proof_unprecise.comp.inc"
    ;

std::vector<Reflectance> all_forms() {
  return {catalogue().begin(), catalogue().end()};
}

TEST(ShaderProof, EveryFormHasTheLibrarysBits) {
  Device device;
  ASSERT_TRUE(is_software(device)) << "set VK_DRIVER_FILES to the software driver";
  for (const ProofRow& row : shader_proof(device, all_forms(), {.random = 1 << 17})) {
    EXPECT_EQ(row.differing, 0u) << row.form << ", up to " << row.max_ulp << " ulp";
    EXPECT_GT(row.count, (1u << 17) + 1000) << row.form;
    EXPECT_TRUE(passes(row, true) && passes(row, false));
  }
}

TEST(ShaderProof, WithoutPreciseValuesDiffer) {
  Device device;
  const std::vector<Reflectance> forms{ward{}, phong{}, blinn_phong{}, cook_torrance_beckmann{}};
  for (const ProofRow& row : shader_proof(device, forms, {.random = 1 << 14, .shader = kUnprecise})) {
    EXPECT_GT(double(row.differing), 0.01 * 6 * double(row.count)) << row.form;
    EXPECT_FALSE(passes(row, true)) << row.form;
  }
}

TEST(ShaderProof, FurthestValueIsThatOfItsConfiguration) {
  Device device;
  const Reflectance form = cook_torrance_beckmann{};
  const ProofRow row = shader_proof(device, {&form, 1}, {.random = 1 << 14, .shader = kUnprecise}).front();
  const ProofWorst& w = row.worst;
  EXPECT_EQ(w.library, library_values(form, w.at)[w.value]);
  EXPECT_NE(w.device, w.library);
  EXPECT_EQ(w.tolerances > 1, row.beyond_tolerance > 0);
}

TEST(ShaderProof, ContractedLibraryDiffers) {
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor cannot contract";
  for (const Reflectance& form :
       {Reflectance(ward{}), Reflectance(cook_torrance{}), Reflectance(oren_nayar{})}) {
    std::size_t differing = 0;
    const auto configurations = random_configurations(form, 1 << 14, 1);
    for (const ProofConfiguration& c : configurations)
      differing += library_values(form, c) != contracted_values(form, c);
    EXPECT_GT(double(differing), 0.01 * double(configurations.size())) << info(form).name;
  }
}

TEST(ShaderProof, ExtremesContainWhatTheyClaim) {
  const auto extremes = extreme_configurations(cook_torrance_dielectric{});
  const auto any = [&](auto&& holds) { return std::any_of(extremes.begin(), extremes.end(), holds); };
  EXPECT_TRUE(any([](const ProofConfiguration& c) { return c.wi[2] == 0 && c.wo[2] == 0; }));
  EXPECT_TRUE(any([](const ProofConfiguration& c) { return std::fpclassify(c.wi[0]) == FP_SUBNORMAL; }));
  EXPECT_TRUE(any([](const ProofConfiguration& c) { return c.wi == c.wo && c.wi[2] > 0.5f; }));
  EXPECT_TRUE(any([](const ProofConfiguration& c) { return c.wi[2] > 0.5f && c.wo[2] == -c.wi[2]; }));
  EXPECT_TRUE(any([](const ProofConfiguration& c) { return c.wi[2] < 0; }));
}

TEST(ShaderProof, AFifthOfTheRandomConfigurationsIsGrazing) {
  std::size_t grazing = 0;
  const auto configurations = random_configurations(ward{}, 20000, 3);
  for (const ProofConfiguration& c : configurations)
    grazing += std::min(std::abs(c.wi[2]), std::abs(c.wo[2])) < 0.0101f;
  EXPECT_GT(grazing, 4000u);
  EXPECT_LT(grazing, 6000u);
}

}  // namespace
}  // namespace brdf::render
