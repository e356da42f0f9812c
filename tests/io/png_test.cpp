// Tests which byte strings are recognised as complete PNG files.
#include "io/files/png.h"

#include <gtest/gtest.h>

#include <array>

namespace brdf::io {
namespace {

std::string picture() {
  constexpr std::array<unsigned char, 6> pixels{0, 51, 255, 102, 10, 200};
  return png_of_pixels(2, 1, pixels);
}

TEST(PngBytes, AreWholeWithTheirEndAndNoByteLess) {
  const std::string png = picture();
  EXPECT_TRUE(is_whole_png(png));
  EXPECT_TRUE(is_whole_png(png + "what follows is not read"));
  for (std::size_t size = 0; size < png.size(); ++size)
    EXPECT_FALSE(is_whole_png(png.substr(0, size))) << size;
  EXPECT_TRUE(is_png(png.substr(0, 8)));
  EXPECT_FALSE(is_png(png.substr(0, 7)));
}

TEST(PngBytes, HoldNoChunkThatIsLongerThanTheFile) {
  std::string png = picture();
  const std::size_t length = png.find("IDAT") - 4;
  for (const unsigned char more : {0x01, 0x7f, 0x80, 0xff}) {
    png[length] = static_cast<char>(more);
    EXPECT_FALSE(is_whole_png(png)) << int(more);
  }
}

}  // namespace
}  // namespace brdf::io
