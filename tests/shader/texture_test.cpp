// Textures as data: texels, filters and wraps, compared with values that are computed by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/temporary.h"
#include "shader/half_precision.h"
#include "shader/undefined.h"
#include "tests/shader/texts.h"
#include "texel/planes.h"

namespace brdf::shader {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// 4 x 2 texels: the first row 0 1 2 3, the second row 10 11 12 13, in red; half of it in green; no blue.
class Textures : public testing::Test {
 protected:
  Textures() {
    texel::Planes planes{4, 2, {"G", "R"}, {}};
    planes.values = {{0, 0.5f, 1, 1.5f, 5, 5.5f, 6, 6.5f}, {0, 1, 2, 3, 10, 11, 12, 13}};
    texel::write_planes(file("a.exr"), planes);
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  ShaderChoice choice(const std::string& rules = "") const {
    return {.file = "", .textures = {parse_texture("map=" + file("a.exr") + rules)}};
  }
  // The value of an expression with `u` and `v`, in double.
  double value(const std::string& expression, double u, double v, const std::string& rules) const {
    const auto model =
        shader_of("uniform sampler2D map;\n//: param u -9 9 " + std::to_string(u) + "\n//: param v -9 9 " +
                      std::to_string(v) + "\nfloat brdf(vec3 L, vec3 V, vec3 N, float u, float v) { return " +
                      expression + "; }\n",
                  choice(rules));
    return value_at(model, 30, 0, 40, 0);
  }
  double red(double u, double v, const std::string& rules) const {
    return value("texture(map, vec2(u, v)).r", u, v, rules);
  }

  io::TemporaryFolder folder_;
};

// Texel k is centred at (k + 1/2) / 4; the first row of the file is at small v.
TEST_F(Textures, AreReadAtTheCentresOfTheirTexels) {
  for (const std::string filter : {":nearest", ":bilinear"})
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 4; ++x) EXPECT_EQ(red((x + 0.5) / 4, (y + 0.5) / 2, filter), x + 10 * y) << filter;
}

TEST_F(Textures, NearestTakesTheTexelThatHoldsThePoint) {
  EXPECT_EQ(red(0.24, 0.25, ":nearest"), 0);
  EXPECT_EQ(red(0.26, 0.25, ":nearest"), 1);
  EXPECT_EQ(red(0.26, 0.49, ":nearest"), 1);
  EXPECT_EQ(red(0.26, 0.51, ":nearest"), 11);
}

TEST_F(Textures, BilinearIsTheMeanOfFourTexels) {
  // Between columns 1 and 2 at a share of 1/4, between the rows at a share of 1/2.
  EXPECT_NEAR(red((1.5 + 0.25) / 4, 0.5, ""), 1.25 + 5, 1e-12);
  EXPECT_NEAR(red((2.5 + 0.75) / 4, 0.25, ":bilinear"), 2.75, 1e-12);
}

TEST_F(Textures, WrapAroundTheirEdges) {
  // A quarter of a texel left of the first centre, and right of the last one.
  const double left = (0.5 - 0.25) / 4, right = (3.5 + 0.25) / 4;
  EXPECT_NEAR(red(left, 0.25, ":repeat"), 0.25 * 3, 1e-12);
  EXPECT_NEAR(red(right, 0.25, ":repeat"), 0.75 * 3, 1e-12);
  EXPECT_NEAR(red(left, 0.25, ":clamp"), 0, 1e-12);
  EXPECT_NEAR(red(right, 0.25, ":clamp"), 3, 1e-12);
  EXPECT_NEAR(red(left, 0.25, ":mirror"), 0, 1e-12);
  EXPECT_NEAR(red(right, 0.25, ":mirror"), 3, 1e-12);
  // Beyond the edges: one and a half texels to the right of the last centre, and three to the left.
  EXPECT_NEAR(red(5.0 / 4, 0.25, ":repeat"), 0.5, 1e-12);
  EXPECT_NEAR(red(5.0 / 4, 0.25, ":clamp"), 3, 1e-12);
  EXPECT_NEAR(red(5.0 / 4, 0.25, ":mirror"), 2.5, 1e-12);
  EXPECT_NEAR(red(-2.5 / 4, 0.25, ":repeat"), 1, 1e-12);
  EXPECT_NEAR(red(-2.5 / 4, 0.25, ":clamp"), 0, 1e-12);
  EXPECT_NEAR(red(-2.5 / 4, 0.25, ":mirror"), 2, 1e-12);
  EXPECT_NEAR(red(9.5 / 4, 0.25, ":mirror"), 1, 1e-12);
  for (const auto& [rule, column] :
       {std::pair(":repeat", 1.0), std::pair(":clamp", 3.0), std::pair(":mirror", 2.0)})
    EXPECT_EQ(red(5.5 / 4, 0.25, std::string(":nearest") + rule), column) << rule;
  EXPECT_EQ(red(-0.5 / 4, 0.25, ":nearest:repeat"), 3);
  EXPECT_EQ(red(-0.5 / 4, 0.25, ":nearest:mirror"), 0);
  EXPECT_EQ(red(-1.5 / 4, 0.25, ":mirror:nearest"), 1);
}

TEST_F(Textures, GiveTheChannelsOfTheFile) {
  EXPECT_EQ(value("texture(map, vec2(u, v)).g", 0.375, 0.75, ""), 5.5);
  EXPECT_EQ(value("texture(map, vec2(u, v)).b", 0.375, 0.75, ""), 0);
  EXPECT_EQ(value("texture(map, vec2(u, v)).a", 0.375, 0.75, ""), 1);
  texel::write_planes(file("grey.exr"), {1, 1, {"Y"}, {{0.25f}}});
  const auto grey = shader_of(
      "uniform sampler2D map;\nvec3 brdf(vec3 L, vec3 V, vec3 N) { return texture(map, L.xy).rgb; }\n",
      {.file = "", .textures = {parse_texture("map=" + file("grey.exr"))}});
  for (std::size_t c = 0; c < grey->material(grey).channels.size(); ++c)
    EXPECT_EQ(value_at(grey, 30, 0, 40, 0, c), 0.25);
}

TEST_F(Textures, AreReadByEveryFunctionOfBothLanguages) {
  EXPECT_EQ(value("texelFetch(map, ivec2(3, 1), 0).r", 0, 0, ""), 13);
  EXPECT_NEAR(value("textureLod(map, vec2(u, v), 0.0).r", 0.25, 0.25, ""), 0.5, 1e-12);
  EXPECT_NEAR(value("textureLod(map, vec2(u, v), 3.0).r", 0.25, 0.25, ""), 0.5, 1e-12);
  EXPECT_NEAR(value("textureGrad(map, vec2(u, v), vec2(0.1), vec2(0.2)).r", 0.25, 0.25, ""), 0.5, 1e-12);
  EXPECT_EQ(value("float(textureSize(map, 0).x * 10 + textureSize(map, 0).y)", 0, 0, ""), 42);
  const auto hlsl = [&](const std::string& expression) {
    const auto model = shader_of(
        "Texture2D map; SamplerState linear_sampler;\n//: param u 0 1 0.25\n"
        "float look(Texture2D t, SamplerState s, float2 at) { return t.Sample(s, at).r; }\n"
        "float brdf(float3 L, float3 V, float3 N, float u) { return " +
            expression + "; }\n",
        choice(), "a.hlsl");
    return value_at(model, 30, 0, 40, 0);
  };
  EXPECT_NEAR(hlsl("map.Sample(linear_sampler, float2(u, 0.25)).r"), 0.5, 1e-12);
  EXPECT_NEAR(hlsl("map.SampleLevel(linear_sampler, float2(u, 0.25), 0).r"), 0.5, 1e-12);
  EXPECT_NEAR(hlsl("map.SampleGrad(linear_sampler, float2(u, 0.25), float2(0.1, 0.0), float2(0.0, 0.1)).r"),
              0.5, 1e-12);
  EXPECT_NEAR(hlsl("map.SampleBias(linear_sampler, float2(u, 0.25), -1.0).r"), 0.5, 1e-12);
  EXPECT_EQ(hlsl("map.Load(int3(2, 1, 0)).r"), 12);
  EXPECT_NEAR(hlsl("look(map, linear_sampler, float2(u, 0.25))"), 0.5, 1e-12);
  // As arguments of functions, the reflectance included.
  const auto passed = shader_of(
      "float look(sampler2D t, vec2 at) { return texture(t, at).r; }\n//: param u 0 1 0.25\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float u, sampler2D map) { return look(map, vec2(u, 0.25)); }\n",
      choice());
  EXPECT_NEAR(value_at(passed, 30, 0, 40, 0), 0.5, 1e-12);
}

// The coordinates of a relaxed sampler keep 32 bits; the texel is rounded.
TEST_F(Textures, AreRoundedInHalfPrecisionAfterTheFilter) {
  const auto model = shader_of(
      "uniform mediump sampler2D map;\n//: param u 0 1 0.25\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float u) { return texture(map, vec2(u, 0.25)).r; }\n",
      choice());
  ASSERT_TRUE(model->function().in_half);
  const std::vector<double> at{0.125 + 0.25 * 0.1};
  EXPECT_EQ(in_half(model->function(), at, {0, 0, 1}, {0, 0, 1}, 0), 0.0999755859375);
}

TEST_F(Textures, ThatCannotBeReadAreRefusedOnce) {
  const std::string text =
      "uniform sampler2D map;\nfloat brdf(vec3 L, vec3 V, vec3 N) {\n return texture(map, L.xy).r;\n}\n";
  EXPECT_THAT(refusal(text), HasSubstr("test.glsl:3: reads the texture map: give its texels with --texture "
                                       "map=FILE.exr"));
  EXPECT_EQ(refusal(text, choice()), "accepted");
  const auto refused = [&](const std::string& option) -> std::string {
    try {
      return refusal(text, {.file = "", .textures = {parse_texture(option)}});
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refused("other=" + file("a.exr")),
              HasSubstr("--texture other: test.glsl has no texture of this name (its textures: map)"));
  EXPECT_THAT(refused("map=" + file("b.exr")), AllOf(HasSubstr("--texture map: "), HasSubstr("b.exr")));
  EXPECT_THAT(refused("map=a.png"), HasSubstr("a texture must be an OpenEXR file (.exr)"));
  for (const std::string wrong :
       {"map", "=a.exr", "map=", "map=a.txt", "map=a.exr:cubic", "map=a.exr:nearest:bilinear"})
    EXPECT_THAT(refused(wrong), HasSubstr("must be NAME=FILE.exr")) << wrong;
  texel::write_planes(file("depth.exr"), {1, 1, {"Z"}, {{0.25f}}});
  EXPECT_THAT(refused("map=" + file("depth.exr")),
              HasSubstr("has no channel R, G, B, A or Y (its channels: Z)"));
  texel::write_planes(file("hole.exr"), {2, 1, {"R"}, {{0.25f, NAN}}});
  EXPECT_THAT(refused("map=" + file("hole.exr")), HasSubstr("channel R is not finite at column 1, row 0"));
  ShaderChoice twice = choice();
  twice.textures.push_back(twice.textures.front());
  EXPECT_THAT(refusal(text, twice), HasSubstr("another --texture gives map"));
  ShaderChoice shared = choice();
  shared.textures.push_back(parse_texture("other=" + file("a.exr")));
  shared.shares_textures = true;
  EXPECT_EQ(refusal(text, shared), "accepted");
}

TEST_F(Textures, OfOtherKindsAreRefusedByName) {
  const auto refused = [&](const std::string& declaration, const std::string& expression) {
    return refusal("uniform " + declaration + ";\nfloat brdf(vec3 L, vec3 V, vec3 N) {\n return " +
                   expression + ";\n}\n");
  };
  EXPECT_THAT(refused("samplerCube sky", "texture(sky, L).r"),
              HasSubstr("test.glsl:3: reads sky, which is no texture of two dimensions with numbers"));
  EXPECT_THAT(refused("sampler3D lut", "texture(lut, L).r"),
              HasSubstr("reads lut, which is no texture of two"));
  EXPECT_THAT(refused("usampler2D ids", "float(texture(ids, L.xy).r)"), HasSubstr("reads ids, which is no"));
  EXPECT_THAT(refused("sampler2D maps[2]", "texture(maps[1], L.xy).r"),
              HasSubstr("test.glsl:3: reads maps, which is no single texture"));
  const auto given = [&](const std::string& expression) {
    return refusal(
        "uniform sampler2D map;\nfloat brdf(vec3 L, vec3 V, vec3 N) { return " + expression + "; }\n",
        choice());
  };
  EXPECT_THAT(given("textureOffset(map, L.xy, ivec2(1, 0)).r"),
              HasSubstr("with an offset, which is not supported"));
  EXPECT_THAT(given("texelFetch(map, ivec2(0), 1).r"), HasSubstr("a level of detail other than 0"));
  EXPECT_THAT(given("textureGather(map, L.xy).r"), HasSubstr("in a way that is not supported"));
}

// Reading outside the texture with whole numbers is left open by the language.
TEST_F(Textures, AreUndefinedOutsideForWholeNumbers) {
  const auto model = shader_of(
      "uniform sampler2D map;\nfloat brdf(vec3 L, vec3 V, vec3 N) { return texelFetch(map, ivec2(8.0 * L.z, "
      "0), "
      "0).r; }\n",
      choice());
  const auto at = [&](double cosine) {
    return undefined_value<double>(model->function(), {}, {std::sqrt(1 - cosine * cosine), 0, cosine},
                                   {0, 0, 1});
  };
  EXPECT_FALSE(at(0.25));
  ASSERT_TRUE(at(0.75));
  EXPECT_EQ(at(0.75)->why, Undefined::index);
}

// Two channels of a texture differ, although their texels have the same place.
TEST_F(Textures, DistinguishTheirChannels) {
  const auto model = shader_of(
      "uniform sampler2D map;\nvec3 brdf(vec3 L, vec3 V, vec3 N) { return texture(map, vec2(0.375, "
      "0.75)).rgb; }\n",
      choice());
  EXPECT_EQ(model->material(model).channels.size(), 3u);
  EXPECT_EQ(value_at(model, 30, 0, 40, 0, 0), 11);
  EXPECT_EQ(value_at(model, 30, 0, 40, 0, 1), 5.5);
  EXPECT_FALSE(model->info().has_glsl);
}

TEST(TextureOption, IsWrittenAsItIsRead) {
  for (const std::string text :
       {"map=a.exr", "map=a.exr:nearest", "map=a.exr:clamp", "map=a.exr:nearest:mirror", "map=C:b.exr:clamp"})
    EXPECT_EQ(to_text(parse_texture(text)), text);
  EXPECT_EQ(to_text(parse_texture("map=a.exr:repeat:bilinear")), "map=a.exr");
  EXPECT_THAT(command_words({.file = "a.glsl", .textures = {parse_texture("map=b c.exr:clamp")}}),
              HasSubstr("--texture 'map=b c.exr:clamp'"));
}

}  // namespace
}  // namespace brdf::shader
