// Tests stacks as folders: they are read back unchanged, and refused with the name of the file if they are
// damaged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "io/files/error.h"
#include "io/files/png.h"
#include "io/files/temporary.h"
#include "texel/stack.h"

namespace brdf::texel {
namespace {

using testing::HasSubstr;

class Stacks : public testing::Test {
 protected:
  Stacks() {
    write_lights("");
    for (int k = 0; k < 2; ++k) write_image(k, 3, 2);
  }
  void write_lights(const std::string& comments, int rows = 2) {
    std::ofstream out(path() / "lights.csv");
    out << comments << "theta_i,phi_i,theta_o,phi_o\n";
    for (int k = 0; k < rows; ++k) out << 10 + 20 * k << ",30,0,0\n";
  }
  void write_image(int k, std::size_t width, std::size_t height) {
    Planes image{width, height, {"R", "G", "B"}, {}};
    for (int c = 0; c < 3; ++c) {
      image.values.emplace_back();
      for (std::size_t t = 0; t < width * height; ++t)
        image.values.back().push_back(float(100 * k + 10 * c) + float(t));
    }
    write_planes(path() / ("image_" + std::to_string(k) + ".exr"), image);
  }
  std::string refusal() const {
    try {
      const Stack stack = open_stack(path());
      read_region(stack, {0, 0, stack.width, stack.height});
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  io::TemporaryFolder folder_;
};

TEST_F(Stacks, AreReadTexelByTexel) {
  const Stack stack = open_stack(path());
  EXPECT_EQ(stack.channels, (std::vector<std::string>{"r", "g", "b"}));
  EXPECT_EQ(stack.width, 3u);
  EXPECT_EQ(stack.height, 2u);
  EXPECT_EQ(bytes_per_texel(stack), 24u);
  // texel, then channel, then image
  EXPECT_EQ(read_region(stack, {1, 1, 2, 1}),
            (std::vector<float>{4, 104, 14, 114, 24, 124, 5, 105, 15, 115, 25, 125}));
}

TEST_F(Stacks, LoseTheDarkLevelAndWhatIsSaturated) {
  write_lights("# dark_level: 0.5\n# saturation: 104\n");
  const std::vector<float> pixels = read_region(open_stack(path()), {0, 1, 2, 1});
  EXPECT_EQ(pixels[0], 2.5f);
  EXPECT_EQ(pixels[1], 102.5f);
  EXPECT_EQ(pixels[6], 3.5f);
  EXPECT_TRUE(std::isnan(pixels[7]));
}

TEST_F(Stacks, MayBePngWhoseTransferIsStated) {
  for (int k = 0; k < 2; ++k) std::filesystem::remove(path() / ("image_" + std::to_string(k) + ".exr"));
  const std::vector<unsigned char> pixels{0, 51, 255, 102, 10, 200};
  for (const char* name : {"a.png", "b.png"})
    std::ofstream(path() / name, std::ios::binary) << io::png_of_pixels(2, 1, pixels);
  EXPECT_THAT(refusal(), HasSubstr("a.png: the transfer function of the image is not known"));
  write_lights("# transfer: bright\n");
  EXPECT_THAT(refusal(), HasSubstr("transfer 'bright': must be linear, srgb or a power"));
  const auto first_image = [&](const std::string& comments) {
    write_lights(comments);
    const std::vector<float> all = read_region(open_stack(path()), {0, 0, 2, 1});
    std::vector<float> out;
    for (std::size_t k = 0; k < all.size(); k += 2) out.push_back(all[k]);
    return out;
  };
  const std::vector<float> linear = first_image("# transfer: linear\n# white: 2\n");
  EXPECT_FLOAT_EQ(linear[1], 0.4f);
  EXPECT_TRUE(std::isnan(linear[2]));  // 255 is saturated
  EXPECT_FLOAT_EQ(linear[3], 0.8f);
  // IEC 61966-2-1: 51 of 255 is 0.2, and ((0.2 + 0.055) / 1.055)^2.4 = 0.0331048; 10 of 255 is on the
  // straight part of the curve.
  const std::vector<float> srgb = first_image("# transfer: srgb\n");
  EXPECT_NEAR(srgb[1], 0.0331048, 1e-7);
  EXPECT_NEAR(srgb[4], 10 / 255.0 / 12.92, 1e-8);
  EXPECT_NEAR(first_image("# transfer: 2.2\n")[1], 0.0289912, 1e-7);
  std::filesystem::resize_file(path() / "b.png", 60);
  EXPECT_THAT(refusal(), HasSubstr("b.png: is not a readable PNG image"));
}

TEST_F(Stacks, OfNearLightsKnowWhereATexelIs) {
  write_lights("# light_distance: 10\n");
  EXPECT_THAT(refusal(), HasSubstr("needs texel_size"));
  write_lights("# light_distance: 10\n# texel_size: 2\n");
  const Stack stack = open_stack(path());
  // The texel is on the right in the upper of two rows of three: 2 to the right of the middle and 1 above
  // it. The second light is 30 degrees from z, in the direction of 30 degrees from x.
  const Vec3<double> light{10 * 0.25 * std::sqrt(3.0), 10 * 0.25, 10 * 0.5 * std::sqrt(3.0)};
  const double x = light.x - 2, y = light.y - 1, square = x * x + y * y + light.z * light.z;
  const DirectionArrays<double> seen = directions_at(stack, 2, 0);
  EXPECT_NEAR(seen.view().wi(1).x, x / std::sqrt(square), 1e-12);
  EXPECT_NEAR(seen.view().wi(1).y, y / std::sqrt(square), 1e-12);
  EXPECT_EQ(seen.view().wo(1).z, 1);  // the viewer is distant
  EXPECT_NEAR(read_region(stack, {2, 0, 1, 1})[1], 102 * square / 100, 1e-4);
}

TEST_F(Stacks, AreRefusedWithTheFileThatIsWrong) {
  write_lights("", 3);
  EXPECT_THAT(refusal(), HasSubstr("lights.csv: 3 rows for 2 images"));
  write_lights("# saturation: much\n");
  EXPECT_THAT(refusal(), HasSubstr("saturation 'much': must be a finite number"));
  write_lights("# dark_level: nan\n");
  EXPECT_THAT(refusal(), HasSubstr("dark_level 'nan': must be a finite number"));
  write_lights("# transfer: srgb\n# white: 1e300\n");
  EXPECT_THAT(refusal(), HasSubstr("white: must be above 0, at most 1e+30"));
  write_lights("# light_distance: 1e-300\n# texel_size: 1\n");
  EXPECT_THAT(refusal(), HasSubstr("texel_size must be from 1e-09 to 1e+09"));
  write_lights("");
  write_image(1, 2, 2);
  EXPECT_THAT(refusal(), HasSubstr("image_1.exr: size or channels differ from image_0.exr"));
  std::filesystem::resize_file(path() / "image_1.exr", 200);
  EXPECT_THAT(refusal(), HasSubstr("image_1.exr: "));
  write_image(1, 3, 2);
  write_planes(path() / "mask.exr", {2, 2, {"Y"}, {{1, 1, 1, 1}}});
  EXPECT_THAT(refusal(), HasSubstr("mask.exr: must have one channel and 3 x 2 pixels"));
}

TEST_F(Stacks, HoldNoNumberBeyondFloat) {
  write_lights("# dark_level: -1e300\n");
  for (const float value : read_region(open_stack(path()), {0, 0, 3, 2})) EXPECT_TRUE(std::isnan(value));
}

TEST_F(Stacks, KeepWhatPlanesHold) {
  const Planes planes{2, 1, {"alpha", "kd.r"}, {{0.1f, NAN}, {1e-7f, 3e8f}}, {{"form", "a sum"}}};
  write_planes(path() / "maps.exr", planes);
  const Planes back = read_planes(path() / "maps.exr");
  EXPECT_EQ(back.names, planes.names);
  EXPECT_EQ(back.values[1], planes.values[1]);
  EXPECT_EQ(back.values[0][0], 0.1f);
  EXPECT_TRUE(std::isnan(back.values[0][1]));
  EXPECT_THAT(back.attributes, testing::Contains(testing::Pair("form", "a sum")));
  EXPECT_EQ(back.find("none"), nullptr);
}

// Rows that are computed one part after the other give the file of the whole planes.
TEST_F(Stacks, AreWrittenInParts) {
  for (const bool in_half : {false, true}) {
    constexpr std::size_t kWidth = 70, kHeight = 150;
    Planes head{kWidth, kHeight, {"alpha", "kd.r"}, {}, {{"form", "a sum"}}, in_half};
    const auto value = [](std::size_t plane, std::size_t texel) {
      return float(plane + 1) / float(texel + 3);
    };
    Planes whole = head;
    for (std::size_t k = 0; k < 2; ++k) {
      whole.values.emplace_back();
      for (std::size_t t = 0; t < kWidth * kHeight; ++t) whole.values.back().push_back(value(k, t));
    }
    write_planes(path() / "whole.exr", whole);
    std::vector<std::size_t> heights;
    write_planes(path() / "parts.exr", head, [&](const Region& rows, std::vector<std::vector<float>>& out) {
      heights.push_back(rows.height);
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t t = 0; t < rows.size(); ++t) out[k][t] = value(k, rows.y * kWidth + t);
    });
    EXPECT_EQ(heights, (std::vector<std::size_t>{64, 64, 22}));
    const auto bytes_of = [&](const char* name) {
      std::ifstream in(path() / name, std::ios::binary);
      return std::string(std::istreambuf_iterator<char>(in), {});
    };
    EXPECT_GT(bytes_of("whole.exr").size(), 1000u);
    EXPECT_EQ(bytes_of("parts.exr"), bytes_of("whole.exr"));
  }
}

}  // namespace
}  // namespace brdf::texel
