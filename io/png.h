// Pictures as the bytes of a PNG file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace brdf::io {

// Of 8 bits and row-major pixels, top row first: RGB, or RGBA where there are four bytes for each pixel.
std::string png_of_pixels(std::size_t width, std::size_t height, std::span<const unsigned char> pixels);

}  // namespace brdf::io
