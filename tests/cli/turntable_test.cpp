// Tests `brdf render --turntable`: its output is read back.
#ifdef BRDF_HAS_RENDER
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <webp/demux.h>

#include <algorithm>

#include "render/scene/texture.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;

struct Frames {
  int width = 0, height = 0;
  std::vector<std::vector<std::uint8_t>> rgba;
  std::vector<int> end;  // milliseconds
};

Frames read_webp(const std::filesystem::path& path) {
  const std::string bytes = file_text(path);
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
  Frames frames;
  WebPAnimDecoder* decoder = WebPAnimDecoderNew(&data, nullptr);
  if (!decoder) return frames;
  WebPAnimInfo info;
  WebPAnimDecoderGetInfo(decoder, &info);
  frames.width = int(info.canvas_width);
  frames.height = int(info.canvas_height);
  while (WebPAnimDecoderHasMoreFrames(decoder)) {
    std::uint8_t* pixels = nullptr;
    int end = 0;
    if (!WebPAnimDecoderGetNext(decoder, &pixels, &end)) break;
    frames.rgba.emplace_back(pixels, pixels + 4 * info.canvas_width * info.canvas_height);
    frames.end.push_back(end);
  }
  WebPAnimDecoderDelete(decoder);
  return frames;
}

class Turntable : public testing::Test {
 protected:
  static constexpr const char* kGold =
      "'" BRDF_SOURCE_DIR "/data/materials/gold.json' --width 96 --height 64 ";
  void SetUp() override {
    if (run(std::string(kGold) + "-o still.png").exit_code == 3) GTEST_SKIP() << "no Vulkan driver";
    still_ = render::load_texture(folder_.path() / "still.png");
  }
  Outcome run(const std::string& arguments) { return run_brdf("render " + arguments, folder_.path()); }
  // Returns the largest difference from the still picture, in steps of a byte.
  int largest_difference(const std::vector<std::uint8_t>& rgba) const {
    int largest = 0;
    for (std::size_t k = 0; k < still_.texels.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(int(rgba[4 * k + c]) - int(still_.texels[k][c])));
    return largest;
  }
  io::TemporaryFolder folder_;
  render::Texture still_;
};

TEST_F(Turntable, ItsFirstFrameIsThePictureAndEveryFrameIsThere) {
  ASSERT_EQ(run(std::string(kGold) + "--turntable 6 --fps 10 --quality 100 -o turn.webp").exit_code, 0);
  const Frames frames = read_webp(folder_.path() / "turn.webp");
  EXPECT_EQ(frames.width, 96);
  EXPECT_EQ(frames.height, 64);
  ASSERT_EQ(frames.rgba.size(), 6u);
  EXPECT_EQ(largest_difference(frames.rgba[0]), 0);
  EXPECT_GT(largest_difference(frames.rgba[2]), 40);  // viewed from another direction
  EXPECT_THAT(frames.end, testing::ElementsAre(100, 200, 300, 400, 500, 600));
}

TEST_F(Turntable, WithLossItIsSmallerAndNearlyTheSame) {
  ASSERT_EQ(run(std::string(kGold) + "--turntable 3 -o lossy.webp").exit_code, 0);
  ASSERT_EQ(run(std::string(kGold) + "--turntable 3 --quality 100 -o exact.webp").exit_code, 0);
  EXPECT_LT(file_text(folder_.path() / "lossy.webp").size(), file_text(folder_.path() / "exact.webp").size());
  const Frames frames = read_webp(folder_.path() / "lossy.webp");
  ASSERT_EQ(frames.rgba.size(), 3u);
  EXPECT_GT(largest_difference(frames.rgba[0]), 0);
  EXPECT_LT(largest_difference(frames.rgba[0]), 60);
}

TEST_F(Turntable, APngSequenceIsNumberedFromZero) {
  ASSERT_EQ(run(std::string(kGold) + "--turntable 3 -o 'frames/f%03d.png'").exit_code, 0);
  EXPECT_EQ(file_text(folder_.path() / "frames/f000.png"), file_text(folder_.path() / "still.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "frames/f002.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "frames/f003.png"));
}

TEST_F(Turntable, RefusesOtherNamesBeforeItDraws) {
  for (const char* name : {"turn.exr", "turn.png", "turn%s.png", "turn%d%d.png", "%99d/turn.png"}) {
    const Outcome outcome = run(std::string(kGold) + "--turntable 3 -o '" + name + "'");
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_THAT(outcome.err, HasSubstr("with %d or %04d for the number of the frame")) << name;
  }
  EXPECT_EQ(run(std::string(kGold) + "--turntable 3 --show gbuffer -o turn.webp").exit_code, 2);
  EXPECT_EQ(run(std::string(kGold) + "--turntable 3 -o absent/turn.webp").exit_code, 2);
}

TEST_F(Turntable, InterruptedItLeavesTheOldFileAndNothingElse) {
  std::ofstream(folder_.path() / "turn.webp") << "old";
  const std::string command = "cd '" + folder_.path().string() +
                              "' && timeout -s INT 1 '" BRDF_EXECUTABLE "' render " + kGold +
                              "--turntable 9999 -o turn.webp >/dev/null 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_EQ(file_text(folder_.path() / "turn.webp"), "old");
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(Turntable, ARowOverAParameterHasItsEndsAtItsEnds) {
  const std::string gold = "'" BRDF_SOURCE_DIR "/data/materials/gold.json' --hard-light ";
  ASSERT_EQ(run(gold + "--over alpha=0.05:0.8 --balls 4 --width 512 --height 128 -o row.png").exit_code, 0);
  ASSERT_EQ(run(gold + "--over alpha=0.05:0.8 --balls 4 --width 512 --height 128 --no-labels -o bare.png")
                .exit_code,
            0);
  const render::Texture row = render::load_texture(folder_.path() / "row.png"),
                        bare = render::load_texture(folder_.path() / "bare.png");
  ASSERT_EQ(row.width, 512);
  // The labels are in the lower part, below all four balls.
  for (int ball = 0; ball < 4; ++ball) {
    std::size_t above = 0, below = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 128 * ball; x < 128 * (ball + 1); ++x) {
        const auto k = std::size_t(y * 512 + x);
        (y < 90 ? above : below) += row.texels[k] != bare.texels[k];
      }
    EXPECT_EQ(above, 0u) << ball;
    EXPECT_GT(below, 100u) << ball;
  }
  EXPECT_EQ(run(gold + gold + "--over alpha=0.05:0.8 -o row2.png").exit_code, 2);
}

TEST_F(Turntable, AShapeTakesTheSpheresPlace) {
  const std::string gold =
      "'" BRDF_SOURCE_DIR "/data/materials/gold.json' --width 96 --height 96 --hard-light --supersample 1 ";
  ASSERT_EQ(run(gold + "-o sphere.png").exit_code, 0);
  std::vector<std::string> seen{file_text(folder_.path() / "sphere.png")};
  for (const char* shape : {"shader_ball", "vase", "cloth", "sedan"}) {
    ASSERT_EQ(run(gold + "--shape " + shape + " -o shape.png").exit_code, 0) << shape;
    seen.push_back(file_text(folder_.path() / "shape.png"));
  }
  std::sort(seen.begin(), seen.end());
  EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
  EXPECT_EQ(run(gold + "--shape dodecahedron -o shape.png").exit_code, 2);
  EXPECT_EQ(run("--scene '" BRDF_SOURCE_DIR "/data/scenes/sphere.json' --shape vase -o shape.png").exit_code,
            2);
}

}  // namespace
}  // namespace brdf
#endif
