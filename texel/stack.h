// A stack: photographs of one flat sample, each under one light and from one viewpoint, pixel upon pixel.
//
// As a folder: an OpenEXR or PNG image per light (every *.exr and *.png but mask.exr, in the order of their
// names) and lights.csv, which has the four angles of one image in each row (theta_i, phi_i, theta_o, phi_o
// in degrees, in the sample's plane: x to the right of the picture, y upwards, z out of it). A pixel is what
// the surface reflects towards the viewer over the irradiance on a plane that faces the light: f_r cos_i in
// 1/sr, cos_i taken at the surface as it lies there, however its normal is tilted. Comments of lights.csv may
// say `# dark_level: X`, which a pixel has without any light and which is subtracted, and `# saturation: X`,
// from which on (as the file has it) a pixel says nothing; of PNG images `# transfer: linear`, `srgb` or a
// power, and `# white: X`, which their largest number would be, were it not saturated. Lights and viewers are
// far, unless `# light_distance: X`, `# viewer_distance: X` and `# texel_size: X` say how far from the
// sample's middle they stand (texel/rig.h); the angles are those seen from there, and a pixel is over the
// irradiance there. mask.exr, one channel, is 0 where there is no sample.
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
  std::vector<std::string> channels;          // r, g, b; else as the images name them
  std::vector<std::string> layers;            // the same in the images
  std::vector<std::filesystem::path> images;  // [image]
  io::SampleTable lights;                     // [image] directions alone
  double dark_level = 0, saturation = std::numeric_limits<double>::infinity();
  Rig rig;
  std::optional<Transfer> transfer;  // of PNG images
  std::vector<float> mask;           // [texel]; empty: every texel is of the sample

  bool holds(std::size_t x, std::size_t y) const { return mask.empty() || mask[y * width + x] != 0; }
};

inline constexpr const char* kLightsFile = "lights.csv";
inline constexpr const char* kMaskFile = "mask.exr";

// Whether a file in such a folder is one of its images, by its name.
bool is_image(const std::filesystem::path& path);

// Whether a path is such a folder.
bool is_stack(const std::filesystem::path& path);

// Reads the table and one image's header. Throws InputError where images and rows differ in number, a light
// or a viewer is not above the plane, or the mask is of another size.
Stack open_stack(const std::filesystem::path& folder);

// Light and viewer of each image as seen from a texel, in the sample's plane.
DirectionArrays<double> directions_at(const Stack& stack, std::size_t x, std::size_t y);

// The pixels of a region, [texel][channel][image], less the dark level, over the irradiance in that texel;
// NaN where a pixel is saturated or no number. Throws InputError where an image is missing, damaged, or of
// another size or other channels than the first.
std::vector<float> read_region(const Stack& stack, const Region& region);
// The same of single texels of one row.
std::vector<float> read_texels(const Stack& stack, std::span<const std::size_t> columns, std::size_t row);
// Bytes that takes for each texel.
std::size_t bytes_per_texel(const Stack& stack);

}  // namespace brdf::texel
