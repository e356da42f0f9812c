// Pictures as the bytes of a PNG file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace brdf::io {

// Of 8 bits and row-major pixels, top row first: RGB, or RGBA where there are four bytes for each pixel.
std::string png_of_pixels(std::size_t width, std::size_t height, std::span<const unsigned char> pixels);

// Whether they begin as a PNG file does.
bool is_png(std::string_view bytes);
// Whether they are a PNG file's signature and chunks up to its end, none longer than what follows. Decoders
// take the memory that a chunk asks for before they see that the file is shorter.
bool is_whole_png(std::string_view bytes);

}  // namespace brdf::io
