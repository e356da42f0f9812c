// Planes of numbers over one grid of texels, as OpenEXR files store them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace brdf::texel {

// A rectangle of texels, the first row on top.
struct Region {
  std::size_t x = 0, y = 0, width = 0, height = 0;

  std::size_t size() const { return width * height; }
};

// Divides a grid into regions of at most width x height, row by row. Regions at the right and lower edges
// may be smaller.
std::vector<Region> divided(const Region& grid, std::size_t width, std::size_t height);

struct Planes {
  std::size_t width = 0, height = 0;
  std::vector<std::string> names;          // "alpha_x", "kd.r": OpenEXR's layers
  std::vector<std::vector<float>> values;  // [name][texel], row by row
  std::vector<std::pair<std::string, std::string>> attributes = {};
  bool in_half = false;  // the file stores 16-bit floats; values are rounded to the nearest

  // Returns the plane of this name, or null.
  const std::vector<float>* find(std::string_view name) const;
  // Returns the plane of a channel's parameter, or the plane that all channels share (tied channels), or
  // null.
  const std::vector<float>* find_parameter(const std::string& parameter, const std::string& channel) const;
};

// Returns the name of a parameter's plane: the parameter, followed by the channel as a layer if there is
// one.
std::string plane_name(const std::string& parameter, const std::string& channel);

// Writes a tiled image (64 x 64) of 32-bit floats, or of 16-bit floats if in_half is set, lossless, one
// channel per plane, with the attributes as strings. The file is written completely or not at all. The same
// planes give the same bytes.
void write_planes(const std::filesystem::path& path, const Planes& planes);
// Writes the same file from rows that `fill` computes, a few rows of all columns at a time and from above,
// so that the planes need not be in memory. `head` has no values. values[name][texel of the rows] has the
// size of the rows.
using FillRows = std::function<void(const Region& rows, std::vector<std::vector<float>>& values)>;
void write_planes(const std::filesystem::path& path, const Planes& head, const FillRows& fill);
// Reads every channel of an image as float. Throws InputError if the file is not an image.
Planes read_planes(const std::filesystem::path& path);

}  // namespace brdf::texel
