// Planes of numbers over one grid of texels, as OpenEXR files hold them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace brdf::texel {

// A rectangle of texels, the first row on top.
struct Region {
  std::size_t x = 0, y = 0, width = 0, height = 0;

  std::size_t size() const { return width * height; }
};

// What covers a grid, row by row; at its right and lower end they may be smaller.
std::vector<Region> divided(const Region& grid, std::size_t width, std::size_t height);

struct Planes {
  std::size_t width = 0, height = 0;
  std::vector<std::string> names;          // "alpha_x", "kd.r": OpenEXR's layers
  std::vector<std::vector<float>> values;  // [name][texel], row by row
  std::vector<std::pair<std::string, std::string>> attributes = {};

  // The plane of that name; null where there is none.
  const std::vector<float>* find(std::string_view name) const;
};

// What a parameter's plane is called: its name, or with a channel the layer of that name.
std::string plane_name(const std::string& parameter, const std::string& channel);

// A tiled image (64 x 64) of 32-bit floats, lossless, one channel per plane, written as a whole or not at
// all; the attributes as strings. The same planes give the same bytes.
void write_planes(const std::filesystem::path& path, const Planes& planes);
// Every channel of an image, as float. Throws InputError where it is none.
Planes read_planes(const std::filesystem::path& path);

}  // namespace brdf::texel
