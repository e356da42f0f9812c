// Maps as textures of other programs: the numbers that textures hold, the losses, and refused files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "interop/loss.h"
#include "interop/pairs.h"
#include "io/files/content.h"
#include "io/files/json.h"
#include "io/files/temporary.h"
#include "maps/textures/carried.h"
#include "maps/textures/written.h"

namespace brdf {
namespace {

using ::testing::HasSubstr;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// Planes of cook_torrance with four texels in a row. The last texel has no fit.
texel::Planes small_maps() {
  texel::Planes out{4, 1, {}, {}, {{"form", "cook_torrance"}}};
  const auto add = [&](const std::string& name, std::vector<float> values) {
    out.names.push_back(name);
    out.values.push_back(std::move(values));
  };
  for (const char* channel : {"b", "g", "r"}) {
    const float part = channel[0] == 'r' ? 1.0F : 0.5F;
    add(std::string("kd.") + channel, {0.6F * part, 0.3F * part, 0.1F * part, kNaN});
    add(std::string("ks.") + channel, {0.8F, 0.8F, 0.8F, kNaN});
    add(std::string("f0.") + channel, {0.04F, 0.05F, 0.06F, kNaN});
  }
  add("alpha_x", {0.1F, 0.2F, 0.4F, kNaN});
  add("alpha_y", {0.1F, 0.2F, 0.4F, kNaN});
  for (const auto& [axis, value] : {std::pair{"normal.x", 0.0F}, {"normal.y", 0.0F}, {"normal.z", 1.0F}})
    add(axis, {value, value, value, kNaN});
  return out;
}

std::vector<float>& plane(texel::Planes& planes, std::string_view name) {
  return const_cast<std::vector<float>&>(*planes.find(name));
}

struct Written {
  io::TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "maps.exr";
  explicit Written(const texel::Planes& planes) { texel::write_planes(path, planes); }
  maps::TexelMaterials read() const { return maps::TexelMaterials(path); }
};

maps::Carried carried_to(const maps::TexelMaterials& maps, const char* program = "gltf") {
  return maps::carry(maps, *interop::find_program(program));
}

std::string message_of(const texel::Planes& planes) {
  try {
    Written(planes).read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Textures, AByteHoldsALinearShareOrItsSrgbCurve) {
  EXPECT_DOUBLE_EQ(maps::rounded(maps::Storage::linear_byte, 0.5), 128 / 255.0);
  // IEC 61966-2-1: 188 of 255 is (0.737255 + 0.055)/1.055 to the power 2.4.
  EXPECT_EQ(maps::byte_of(maps::Storage::srgb_byte, 0.5), 188);
  EXPECT_NEAR(maps::rounded(maps::Storage::srgb_byte, 0.5), 0.5028864580, 1e-9);
  EXPECT_DOUBLE_EQ(maps::rounded(maps::Storage::srgb_byte, 1), 1);
  EXPECT_DOUBLE_EQ(maps::rounded(maps::Storage::real, 0.1), double(0.1F));
}

TEST(Textures, AllTexelsShareOneIndexAndKeepTheirReflectance) {
  const Written file(small_maps());
  const maps::TexelMaterials maps = file.read();
  const maps::Carried carried = carried_to(maps);
  EXPECT_EQ(carried.without_fit, 1u);
  EXPECT_EQ(carried.held, (std::vector<bool>{true, true, true, false}));
  EXPECT_NEAR(std::pow((*carried.index - 1) / (*carried.index + 1), 2), 0.06, 1e-7);
  for (std::size_t texel = 0; texel < 3; ++texel) {
    const Term term = maps::carried_material(carried, maps, texel).terms[0];
    const ReflectanceInfo& form = info(term.form);
    const double tint = term.shape[0][std::size_t(form.shape_index(Role::tint))];
    // A step of the sRGB curve near the white end is below 0.9 %.
    EXPECT_NEAR(0.06 * tint, maps.at(texel).terms[0].weights[0][2], 0.005 * 0.06) << texel;
    const double alpha = term.shape[0][std::size_t(form.shape_index(Role::width))];
    const double root = std::sqrt(maps.at(texel).terms[0].shape[0][0]), step = std::sqrt(0.4) / 255;
    EXPECT_LE(std::abs(std::sqrt(alpha) - root), 0.5 * step * 1.000001) << texel;
  }
}

TEST(Textures, ATexelWithoutReflectanceAlongTheNormalKeepsIt) {
  texel::Planes planes = small_maps();
  for (const char* name : {"f0.r", "f0.g", "f0.b"}) plane(planes, name)[0] = 0;
  const Written file(planes);
  const maps::TexelMaterials maps = file.read();
  const maps::Carried carried = carried_to(maps);
  const Term term = maps::carried_material(carried, maps, 0).terms[0];
  EXPECT_EQ(term.shape[0][std::size_t(info(term.form).shape_index(Role::tint))], 0);
  EXPECT_GT(*carried.index, 1.5);
  EXPECT_LT(carried.losses.of_formula[0], 0.01);
}

TEST(Textures, TheLossOfATexelIsThatOfTheRoundedParameters) {
  const Written file(small_maps());
  const maps::TexelMaterials maps = file.read();
  const maps::Carried carried = carried_to(maps);
  for (std::size_t texel = 0; texel < 3; ++texel) {
    const Material own = maps.at(texel), shown = maps::carried_material(carried, maps, texel);
    const DirectionArrays<double> pairs =
        io::unit_directions(interop::pairs_about(own, interop::Pairs::judged));
    double sum = 0, most = 0, count = 0;
    std::vector<double> f(3), g(3);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Vec3<double> wi = pairs.view().wi(k), wo = pairs.view().wo(k);
      eval(own, wi, wo, f);
      eval(shown, wi, wo, g);
      for (std::size_t c = 0; c < 3; ++c, ++count) {
        sum += std::pow(std::log((1 + g[c] * wi.z) / (1 + f[c] * wi.z)), 2);
        most = std::max(most, std::abs(g[c] - f[c]) / (f[c] + 1e-3));
      }
    }
    EXPECT_NEAR(double(carried.losses.rms[texel]), std::sqrt(sum / count), 1e-9);
    EXPECT_NEAR(double(carried.losses.largest[texel]), most, 1e-6);
    EXPECT_NE(carried.losses.rms[texel], carried.losses.of_formula[texel]);
  }
  EXPECT_TRUE(std::isnan(carried.losses.rms[3]));
  const maps::TexelLoss loss = maps::summary_of(carried.losses.rms);
  EXPECT_EQ(loss.largest,
            double(*std::max_element(carried.losses.rms.begin(), carried.losses.rms.begin() + 3)));
  EXPECT_EQ(double(carried.losses.rms[loss.where]), loss.largest);
}

TEST(Textures, EqualTexelsNeedNoTextureAndAreNotRounded) {
  texel::Planes planes = small_maps();
  for (std::vector<float>& values : planes.values) values = std::vector<float>(4, values[0]);
  const Written file(planes);
  const maps::TexelMaterials maps = file.read();
  const maps::Carried carried = carried_to(maps);
  for (const maps::InputMap& map : carried.inputs) EXPECT_TRUE(map.constant) << map.input.name;
  for (std::size_t texel = 0; texel < 4; ++texel)
    EXPECT_EQ(carried.losses.rms[texel], carried.losses.of_formula[texel]);
  const std::string glb = maps::glb_of(carried, maps, {"equal", {}});
  EXPECT_EQ(glb.find("baseColorTexture"), std::string::npos);
  EXPECT_EQ(glb.find("MASK"), std::string::npos);
}

TEST(Textures, ATexelWithoutAFitIsAHole) {
  const Written file(small_maps());
  const maps::TexelMaterials maps = file.read();
  const std::string glb = maps::glb_of(carried_to(maps), maps, {"holes", {}});
  EXPECT_THAT(glb, HasSubstr("\"alphaMode\": \"MASK\""));
  EXPECT_THAT(maps::sentences(carried_to(maps), maps),
              ::testing::Contains(HasSubstr("1 texel without a fit: holes")));
}

// Returns the text of a program's file, and the written files.
struct InFolder {
  std::string text;
  std::vector<std::filesystem::path> files;
};
InFolder written_for(const char* program, const Written& file, const std::string& output) {
  const maps::TexelMaterials maps = file.read();
  const auto files =
      maps::write_textures(carried_to(maps, program), maps, file.folder.path() / output, "holes");
  return {io::read_content(files.back()).bytes, files};
}

TEST(Textures, ProgramsThatReadImagesHaveAnImageForEachInputThatVaries) {
  const Written file(small_maps());
  const InFolder mtlx = written_for("materialx", file, "a&b.mtlx");
  EXPECT_THAT(mtlx.text, HasSubstr("value=\"a&amp;b_kd.exr\""));
  EXPECT_THAT(mtlx.text, HasSubstr("name=\"opacity\" type=\"float\" nodename=\"holes_held\""));
  EXPECT_THAT(mtlx.text,
              HasSubstr("name=\"weight\" type=\"float\" value=\"0.800000012\""));  // ks is constant
  const InFolder script = written_for("blender", file, "paint.py");
  EXPECT_THAT(script.text, HasSubstr("os.path.join(folder, \"paint_roughness.exr\")"));
  EXPECT_THAT(script.text, HasSubstr("hole = tree.nodes.new(\"ShaderNodeBsdfTransparent\")"));
  for (const auto& [program, files] : {std::pair{"materialx", mtlx.files}, {"blender", script.files}})
    for (const std::filesystem::path& path : files) {
      EXPECT_TRUE(std::filesystem::is_regular_file(path)) << path;
      EXPECT_THAT(maps::possible_files(*interop::find_program(program), files.back()),
                  ::testing::Contains(path));
    }
  const texel::Planes kd = texel::read_planes(file.folder.path() / "paint_kd.exr");
  EXPECT_EQ((*kd.find("R"))[1], 0.3F);
  EXPECT_EQ((*kd.find("G"))[1], 0.15F);
  const texel::Planes held = texel::read_planes(file.folder.path() / "paint_held.exr");
  EXPECT_EQ(*held.find("R"), (std::vector<float>{1, 1, 1, 0}));
}

// Blender 3.4 has two targets: the principled node, and a glossy node with a diffuse one.
TEST(Textures, AnOlderBlenderHasTheNodesOfItsNearestTargetAndNormals) {
  texel::Planes planes = small_maps();
  for (std::vector<float>& values : planes.values) values[3] = values[2];
  plane(planes, "normal.x")[0] = 0.3F;
  plane(planes, "normal.z")[0] = std::sqrt(1 - 0.09F);
  for (const char* name : {"ks.r", "ks.g", "ks.b"}) plane(planes, name) = {1, 1, 1, 1};
  const InFolder dielectric = written_for("blender-3.4", Written(planes), "paint.py");
  EXPECT_THAT(dielectric.text, HasSubstr("principled = tree.nodes.new(\"ShaderNodeBsdfPrincipled\")"));
  EXPECT_THAT(dielectric.text, HasSubstr("principled.inputs[\"Clearcoat\"].default_value = 0"));
  EXPECT_THAT(dielectric.text, HasSubstr("normal = tree.nodes.new(\"ShaderNodeNormalMap\")"));
  EXPECT_THAT(dielectric.text, ::testing::Not(HasSubstr("ShaderNodeBsdfTransparent")));  // no texel is a hole
  for (const char* name : {"f0.r", "f0.g", "f0.b"}) plane(planes, name) = {1, 1, 1, 1};
  const InFolder mirror = written_for("blender-3.4", Written(planes), "mirror.py");
  EXPECT_THAT(mirror.text, HasSubstr("glossy = tree.nodes.new(\"ShaderNodeBsdfGlossy\")"));
  EXPECT_THAT(mirror.text, HasSubstr("diffuse = tree.nodes.new(\"ShaderNodeBsdfDiffuse\")"));
}

TEST(Textures, AWeightThatVariesIsATextureOfGltf) {
  texel::Planes planes = small_maps();
  const auto glb = [&] {
    const Written file(planes);
    const maps::TexelMaterials maps = file.read();
    return maps::glb_of(carried_to(maps), maps, {"weights", {}});
  };
  EXPECT_EQ(glb().find("specularTexture"), std::string::npos);
  for (const char* name : {"ks.r", "ks.g", "ks.b"}) plane(planes, name) = {0.2F, 0.4F, 0.8F, kNaN};
  EXPECT_THAT(glb(), HasSubstr("\"specularTexture\""));
}

// `--tie kd` gives kd one plane for all channels; the other weights name the channels.
TEST(Textures, TiedChannelsShareAPlane) {
  texel::Planes planes = small_maps();
  const auto remove = [&](const std::string& name) {
    const auto at = std::ranges::find(planes.names, name) - planes.names.begin();
    planes.names.erase(planes.names.begin() + at);
    planes.values.erase(planes.values.begin() + at);
  };
  remove("kd.g");
  remove("kd.b");
  *std::ranges::find(planes.names, "kd.r") = "kd";
  const Written file(planes);
  const maps::TexelMaterials maps = file.read();
  EXPECT_EQ(maps.channels(), (std::vector<std::string>{"r", "g", "b"}));
  const Material second = maps.at(1);
  for (const std::vector<double>& weights : second.terms[0].weights)
    EXPECT_EQ(weights, (std::vector<double>{double(0.3F), double(0.8F), double(0.05F)}));
  remove("f0.g");
  EXPECT_THAT(message_of(planes), HasSubstr("has no channel f0.g"));
}

TEST(Textures, TheRoundingOfNormalsIsPartOfTheLoss) {
  texel::Planes planes = small_maps();
  plane(planes, "normal.x")[0] = 0.3F;
  plane(planes, "normal.z")[0] = std::sqrt(1 - 0.09F);
  const Written file(planes);
  const maps::TexelMaterials maps = file.read();
  const maps::Carried carried = carried_to(maps), flat = carried_to(Written(small_maps()).read());
  EXPECT_TRUE(carried.has_normals);
  // Bytes 128 and 255 for a flat normal: (1/255, 1/255, 1).
  EXPECT_NEAR(double(carried.losses.turned[1]), std::atan(std::sqrt(2.0) / 255) * 180 / kPi, 1e-5);
  EXPECT_GT(carried.losses.rms[1], flat.losses.rms[1]);
  EXPECT_EQ(carried.losses.of_formula[1], flat.losses.of_formula[1]);
}

TEST(Textures, NormalsThatVaryAreAnImageInMaterialX) {
  texel::Planes planes = small_maps();
  plane(planes, "normal.y")[2] = 0.6F;
  plane(planes, "normal.z")[2] = 0.8F;
  const Written file(planes);
  const InFolder mtlx = written_for("materialx", file, "bent.mtlx");
  EXPECT_THAT(mtlx.text, HasSubstr("value=\"bent_normal.exr\""));
  EXPECT_THAT(mtlx.text, HasSubstr("<normalmap name=\"holes_normal\" type=\"vector3\">"));
  const texel::Planes normals = texel::read_planes(file.folder.path() / "bent_normal.exr");
  EXPECT_FLOAT_EQ((*normals.find("R"))[2], 0.5F);
  EXPECT_FLOAT_EQ((*normals.find("G"))[2], 0.8F);
  EXPECT_FLOAT_EQ((*normals.find("B"))[2], 0.9F);
}

TEST(Textures, AFileThatIsNoMapIsRefusedWithTheReason) {
  texel::Planes planes = small_maps();
  planes.attributes.clear();
  EXPECT_THAT(message_of(planes), HasSubstr("no attribute 'form'"));
  planes.attributes = {{"form", "lambert+ward"}};
  EXPECT_THAT(message_of(planes), HasSubstr("the sum lambert+ward"));
  planes.attributes = {{"form", "nothing"}};
  EXPECT_THAT(message_of(planes), HasSubstr("'nothing' is no form"));
  planes = small_maps();
  planes.names[9] = "alpha_x.r";
  EXPECT_THAT(message_of(planes), HasSubstr("alpha_x.r, a shape for each channel"));
  planes.names[9] = "other";
  EXPECT_THAT(message_of(planes), HasSubstr("no channel alpha_x"));
}

TEST(Textures, ATexelThatNoTextureHoldsIsNamed) {
  texel::Planes planes = small_maps();
  plane(planes, "alpha_y")[1] = 0.3F;
  EXPECT_THAT(message_of(planes), HasSubstr("texel 1,0: alpha_x and alpha_y differ"));
  planes = small_maps();
  plane(planes, "f0.g")[2] = -1;
  EXPECT_THAT(message_of(planes), HasSubstr("texel 2,0: f0 is -1, but must be 0 to 1"));
  planes = small_maps();
  plane(planes, "normal.z")[0] = -1;
  EXPECT_THAT(message_of(planes), HasSubstr("texel 0,0: the normal must have a z above 0"));
  planes = small_maps();
  for (std::vector<float>& values : planes.values) values.assign(4, kNaN);
  EXPECT_THAT(message_of(planes), HasSubstr("no texel has a fit"));
}

TEST(Textures, ATexelWithOneUnknownParameterHasNoFit) {
  texel::Planes planes = small_maps();
  plane(planes, "kd.b")[0] = kNaN;
  const Written file(planes);
  EXPECT_EQ(carried_to(file.read()).without_fit, 2u);
}

TEST(Textures, ATexelAboveTheLimitsOfTheProgramIsLeftOutWithItsReason) {
  texel::Planes planes = small_maps();
  plane(planes, "ks.r")[1] = 1.5F;
  const Written file(planes);
  const maps::Carried carried = carried_to(file.read());
  EXPECT_EQ(carried.refused, 1u);
  EXPECT_FALSE(carried.held[1]);
  EXPECT_THAT(carried.reason, HasSubstr("texel 1,0: --to gltf: ks 1.5 is above 1"));
  plane(planes, "ks.r") = {1.5F, 1.5F, 1.5F, kNaN};
  EXPECT_THROW(carried_to(Written(planes).read()), interop::Refused);
}

TEST(Textures, AProgramWithoutTexturesIsRefused) {
  const Written file(small_maps());
  EXPECT_THROW(carried_to(file.read(), "mitsuba"), interop::Refused);
}

}  // namespace
}  // namespace brdf
