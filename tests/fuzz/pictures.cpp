#include <stb_image.h>

#include <cstdlib>
#include <cstring>

#include "io/files/png.h"
#include "io/page/html_report.h"
#include "render/picture/picture.h"
#include "render/scene/texture.h"
#include "tests/fuzz/fuzz.h"

namespace brdf::fuzz {
namespace {

const Registered textures("texture", [](std::string_view input) {
  // Large pictures take longer but follow the same path through the code. Only small pictures, and pictures
  // that are refused for their size, are tested.
  constexpr std::int64_t kLarge = 1000;  // texels
  int width = 0, height = 0, channels = 0;
  const bool known = stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(input.data()), int(input.size()),
                                           &width, &height, &channels);
  const std::int64_t texels = std::int64_t(width) * std::abs(std::int64_t(height));
  if (known && texels > kLarge && texels <= render::kMostTexels) return;
  const render::Texture map = render::load_texture(as_file(input));
  require(map.width > 0 && map.height > 0 &&
              map.texels.size() == std::size_t(map.width) * std::size_t(map.height),
          "a map has the texels of its size");
  const glm::vec4 value = map.sample({0.99f, -7.3f});
  for (int c = 0; c < 4; ++c) require(value[c] >= 0 && value[c] <= 1, "texels lie in [0, 1]");
  std::vector<unsigned char> rgb;
  for (const auto& texel : map.texels) rgb.insert(rgb.end(), texel.begin(), texel.begin() + 3);
  const std::string png = io::png_of_pixels(std::size_t(map.width), std::size_t(map.height), rgb);
  const render::Texture again = render::load_texture(as_file(png));
  require(again.width == map.width && again.texels.size() == map.texels.size(), "a PNG keeps the size");
  for (std::size_t k = 0; k < map.texels.size(); ++k)
    require(std::memcmp(&again.texels[k], &map.texels[k], 3) == 0, "a PNG keeps the bytes");
});

const Registered exrs("exr", [](std::string_view input) {
  const render::Picture picture = render::read_exr(as_file(input), "");
  require(picture.width > 0 && picture.height > 0 &&
              picture.pixels.size() == std::size_t(picture.width) * std::size_t(picture.height),
          "a picture has the pixels of its size");
  render::write_exr(output(), {{"", &picture, true}});
  const render::Picture again = render::read_exr(output(), "");
  require(again.width == picture.width && again.height == picture.height &&
              std::memcmp(again.pixels.data(), picture.pixels.data(),
                          picture.pixels.size() * sizeof(glm::vec4)) == 0,
          "a picture reads back as it was written");
});

}  // namespace
}  // namespace brdf::fuzz
