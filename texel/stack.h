// A stack: photographs of one flat sample, each with one light and one viewpoint, aligned pixel by pixel.
//
// A stack is a folder with one OpenEXR or PNG image per light and a table lights.csv. The images are all
// *.exr and *.png files except mask.exr, in the order of their names. Each row of lights.csv has the four
// angles of one image: theta_i, phi_i, theta_o, phi_o in degrees, in the plane of the sample (x to the
// right of the picture, y upwards, z out of the picture).
//
// A pixel is the radiance towards the viewer over the irradiance on a plane that faces the light: f_r cos_i
// in 1/sr. cos_i refers to the actual surface, including the tilt of its normal.
//
// Comments of lights.csv may give more facts. `# dark_level: X` is the pixel value without any light, which
// is subtracted. `# saturation: X` is the pixel value, as in the file, from which on pixels carry no
// information. For PNG images, `# transfer: linear`, `srgb` or a power defines the meaning of the numbers,
// and `# white: X` the value of the largest number if it were not saturated.
//
// Lights and viewers are far away unless `# light_distance: X`, `# viewer_distance: X` and `# texel_size:
// X` give their distances from the centre of the sample (texel/rig.h). The angles are then measured at the
// centre, and a pixel is relative to the irradiance there.
//
// mask.exr has one channel, which is 0 for pixels outside the sample.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/samples/samples.h"
#include "texel/planes.h"
#include "texel/rig.h"
#include "texel/transfer.h"

namespace brdf::texel {

struct Stack {
  std::filesystem::path folder;
  std::size_t width = 0, height = 0;
  std::vector<std::string> channels;          // r, g, b; otherwise the names in the images
  std::vector<std::string> layers;            // the channels' names in the images
  std::vector<std::filesystem::path> images;  // [image]
  io::SampleTable lights;                     // [image], directions only
  double dark_level = 0, saturation = std::numeric_limits<double>::infinity();
  Rig rig;
  std::optional<Transfer> transfer;  // of PNG images
  std::vector<float> mask;           // [texel]; empty: every texel belongs to the sample

  bool holds(std::size_t x, std::size_t y) const { return mask.empty() || mask[y * width + x] != 0; }
};

inline constexpr const char* kLightsFile = "lights.csv";
inline constexpr const char* kMaskFile = "mask.exr";

// Returns whether a file in such a folder is one of its images, judged by its name.
bool is_image(const std::filesystem::path& path);

// Returns whether a path is such a folder.
bool is_stack(const std::filesystem::path& path);

// Reads the table and the header of one image. Throws InputError if the numbers of images and rows differ,
// if a light or a viewer is not above the plane, or if the mask has another size.
Stack open_stack(const std::filesystem::path& folder);

// Returns the directions of light and viewer for each image, as seen from a texel, in the plane of the
// sample.
DirectionArrays<double> directions_at(const Stack& stack, std::size_t x, std::size_t y);

// Returns the pixels of a region as [texel][channel][image], minus the dark level, over the irradiance at
// the texel. Pixels that are saturated or not numbers are NaN. Throws InputError if an image is missing or
// damaged, or if its size or channels differ from the first image.
std::vector<float> read_region(const Stack& stack, const Region& region);
// Returns the pixels of single texels of one row in the same way.
std::vector<float> read_texels(const Stack& stack, std::span<const std::size_t> columns, std::size_t row);
// Returns the bytes that these functions return per texel.
std::size_t bytes_per_texel(const Stack& stack);

}  // namespace brdf::texel
