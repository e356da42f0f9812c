// A virtual photographic stack of a surface with parameters and normals that vary from texel to texel.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/files/parallel.h"
#include "io/samples/samples.h"
#include "texel/planes.h"
#include "texel/rig.h"

namespace brdf::synth {

// A parameter of the material that varies smoothly between low and high over the stack, independently in
// every channel if the parameter is a weight.
struct Variation {
  std::string name;
  double low, high;
};

struct TexelOptions {
  std::size_t width = 0, height = 0;
  int lights = 0, viewers = 1;  // every light with every viewer; a single viewer looks along z
  std::vector<Variation> vary;
  double tilt = 0;          // largest angle between the normal and z, degrees
  double noise = 0;         // s of the factor exp(s z - s^2/2), z standard normal: mean 1
  double noise_floor = 0;   // standard deviation of the additive noise, 1/sr
  double saturation = 0;    // larger readings are clamped to this, 1/sr; 0: no saturation
  double dark_level = 0;    // added to every reading, 1/sr
  double registration = 0;  // standard deviation of each image's shift along x and y, texels
  texel::Rig rig;           // distances of lights and viewers that are near
  std::uint64_t seed = 1;
};

// Parses "NAME=LOW:HIGH". Throws InputError.
Variation parse_variation(const std::string& text);

// Parses "256x256". Throws InputError.
void parse_texels(const std::string& text, TexelOptions& options);

// The ground truth: the material and the normal of every texel.
class Surface {
 public:
  // Throws InputError for parameters that the material does not have, and for values out of range.
  Surface(const Material& material, const TexelOptions& options);

  // Return the material and the normal at a point. Integer coordinates are the centre of a texel.
  Material material(double x, double y) const;
  Vec3<double> normal(double x, double y) const;
  // Return every parameter and the normal as planes: the names of all planes, and the values of some rows.
  texel::Planes head_of_truth() const;
  void fill_truth(const texel::Region& rows, std::vector<std::vector<float>>& values) const;

 private:
  double field(std::size_t which, double x, double y) const;

  Material material_;
  TexelOptions options_;
};

// Returns the directions of the stack, one row per image. Lights (and several viewers) are spread evenly
// over the hemisphere, up to 75 degrees.
io::SampleTable stack_directions(const TexelOptions& options);

// Writes a stack into `folder` (texel/stack.h), and the ground truth to truth/truth.exr in this folder. The
// same arguments give the same files on every machine. Memory: per thread a compressed image and about 300
// bytes for each texel of 64 rows; for a stack of up to a million texels, 300 bytes for each texel. Throws
// InputError for settings out of range.
void write_stack(const std::filesystem::path& folder, const Material& material, const TexelOptions& options,
                 const io::Progress& progress = {});

}  // namespace brdf::synth
