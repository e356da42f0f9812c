// Decodes pictures from the content of a file, which is read at once. A read error of the machine is
// therefore distinguished from an invalid picture, and no picture is made of an incomplete file.
#pragma once

#include <memory>
#include <optional>

#include "io/files/content.h"

namespace brdf::render {

struct PictureSize {
  // Pixels. The height of a BMP is negative if its first row is at the top.
  int width = 0, height = 0;
};

// Returns the size of a PNG, JPEG, BMP, TGA or Radiance picture according to its header; std::nullopt for
// other content.
std::optional<PictureSize> picture_size(const io::Content& content);
bool is_radiance(const io::Content& content);

// Rows from the top, `channels` values per pixel.
template <class Value>
struct Pixels {
  PictureSize size;
  std::unique_ptr<Value, void (*)(void*)> values;
};
// Throw InputError "FILE: FAULT (the reason)" if the content cannot be decoded or ends too soon.
Pixels<unsigned char> decoded_bytes(const io::Content& content, int channels, const std::string& fault);
Pixels<float> decoded_radiance(const io::Content& content, int channels, const std::string& fault);

}  // namespace brdf::render
