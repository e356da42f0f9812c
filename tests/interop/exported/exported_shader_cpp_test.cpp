// Tests compiled C++ of shaders from `brdf export --shader --to cpp`: it has the interpreter's values.
#include <gtest/gtest.h>

#include "brdf/random.h"
#include "kinds.h"
#include "operations.h"
#include "tests/shader/one_operation.h"

namespace brdf::shader {
namespace {

TEST(ExportedShaderCpp, HasEveryOperation) {
  for (const ExportedOperation& o : kExportedOperations) {
    float values[3];
    o.value(values);
    for (std::size_t c = 0; c < 3; ++c) {
      const float expected = std::bit_cast<float>(o.expected[c]);
      EXPECT_TRUE(is_same_value(expected, values[c]))
          << o.name << ' ' << c << ": " << expected << ' ' << values[c];
    }
  }
  EXPECT_EQ(std::size(kExportedOperations), kOperandSets.size() * (std::size_t(Op::count) - 1));
}

TEST(ExportedShaderCpp, HasTheValuesOfAWholeShader) {
  const auto shader = load_shader({BRDF_SOURCE_DIR "/tests/interop/languages/kinds.glsl"});
  Material m = shader->material(shader);
  std::vector<double>& shape = m.terms.front().shape.front();
  const auto of = [&](const char* name) -> double& {
    return shape[std::size_t(shader->info().shape_index(name))];
  };
  Random random(3);
  for (int k = 0; k < 2000; ++k) {
    const float rough = float(random.uniform(0.1, 1)), turn = float(random.uniform(0, 1));
    of("rough") = rough, of("float3") = turn, of("steps") = 1 + k % 5, of("shiny") = k % 2;
    const Vec3<double> wi = direction(degrees(random.uniform(0, 89)), degrees(random.uniform(0, 360))),
                       wo = direction(degrees(random.uniform(0, 89)), degrees(random.uniform(0, 360)));
    const Vec3<float> i{float(wi.x), float(wi.y), float(wi.z)}, o{float(wo.x), float(wo.y), float(wo.z)};
    const std::array<float, 3> ours = values_in_float(m, i, o);
    const auto exported = ::kinds::brdf_eval_kinds({i.x, i.y, i.z}, {o.x, o.y, o.z}, rough, float(1 + k % 5),
                                                   turn, float(k % 2), {0.8f, 0.2f, 0.1f});
    EXPECT_NEAR(exported.r, ours[0], 2e-5f * (1 + std::fabs(ours[0]))) << k;
    EXPECT_NEAR(exported.g, ours[1], 2e-5f * (1 + std::fabs(ours[1]))) << k;
    EXPECT_NEAR(exported.b, ours[2], 2e-5f * (1 + std::fabs(ours[2]))) << k;
  }
}

}  // namespace
}  // namespace brdf::shader
