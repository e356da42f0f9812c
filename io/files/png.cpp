#include "io/files/png.h"

#include <stb/stb_image_write.h>

namespace brdf::io {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kWord = 4;  // bytes of a chunk's length, of its name and of its checksum

std::size_t length_of(std::string_view chunk) {
  std::size_t length = 0;
  for (std::size_t k = 0; k < kWord; ++k) length = length << 8 | static_cast<unsigned char>(chunk[k]);
  return length;
}

}  // namespace

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

bool is_png(std::string_view bytes) {
  return bytes.starts_with(kSignature);
}

bool is_whole_png(std::string_view bytes) {
  if (!is_png(bytes)) return false;
  bytes.remove_prefix(kSignature.size());
  while (bytes.size() >= 3 * kWord) {
    const std::size_t length = length_of(bytes);
    if (length > bytes.size() - 3 * kWord) return false;
    if (bytes.substr(kWord, kWord) == "IEND") return true;
    bytes.remove_prefix(length + 3 * kWord);
  }
  return false;
}

}  // namespace brdf::io
