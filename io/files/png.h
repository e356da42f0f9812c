// Encodes pictures as PNG and checks PNG files.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace brdf::io {

// Returns the bytes of a PNG file. `pixels`: 8 bits per channel, row-major, top row first; RGB, or RGBA if
// there are four bytes per pixel.
std::string png_of_pixels(std::size_t width, std::size_t height, std::span<const unsigned char> pixels);

// Returns whether the bytes begin with the signature of PNG.
bool is_png(std::string_view bytes);
// Returns whether the bytes are the signature and the chunks of a PNG file up to its end, with no chunk
// longer than the bytes that follow. Decoders allocate the memory that a chunk asks for before they notice
// that the file is shorter.
bool is_whole_png(std::string_view bytes);

}  // namespace brdf::io
