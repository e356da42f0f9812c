#include "io/png.h"

#include <stb/stb_image_write.h>

namespace brdf::io {

std::string png_of_pixels(std::size_t width, std::size_t height, std::span<const unsigned char> pixels) {
  const int channels = pixels.size() == 4 * width * height ? 4 : 3;
  std::string png;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), std::size_t(size));
  };
  stbi_write_png_to_func(append, &png, int(width), int(height), channels, pixels.data(),
                         channels * int(width));
  return png;
}

}  // namespace brdf::io
