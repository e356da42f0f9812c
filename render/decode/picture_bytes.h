// Pictures decoded from what their file holds, read at once: what the machine fails to read is told apart
// from what is no picture, and no picture is made of half a file.
#pragma once

#include <memory>
#include <optional>

#include "io/files/content.h"

namespace brdf::render {

struct PictureSize {
  int width = 0, height = 0;  // pixels; the height of a BMP is negative where its first row is on top
};

// Of PNG, JPEG, BMP, TGA or Radiance, as its header says; nothing where it is none.
std::optional<PictureSize> picture_size(const io::Content& content);
bool is_radiance(const io::Content& content);

// Rows from the top, `channels` values a pixel.
template <class Value>
struct Pixels {
  PictureSize size;
  std::unique_ptr<Value, void (*)(void*)> values;
};
// Throw InputError "FILE: FAULT (the reason)" where the content cannot be decoded or ends too soon.
Pixels<unsigned char> decoded_bytes(const io::Content& content, int channels, const std::string& fault);
Pixels<float> decoded_radiance(const io::Content& content, int channels, const std::string& fault);

}  // namespace brdf::render
