// A virtual photographic stack of a surface whose parameters and normal vary from texel to texel.
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

// A parameter of the material that goes smoothly from low to high and back over the stack; in every channel
// by itself.
struct Variation {
  std::string name;
  double low, high;
};

struct TexelOptions {
  std::size_t width = 0, height = 0;
  int lights = 0, viewers = 1;  // every light with every viewer; one viewer looks along z
  std::vector<Variation> vary;
  double tilt = 0;          // the normal's largest angle with z, degrees
  double noise = 0;         // s of the factor exp(s z - s^2/2), z standard normal: mean 1
  double noise_floor = 0;   // standard deviation of the additive noise, 1/sr
  double saturation = 0;    // readings above are cut to this, 1/sr; 0: none
  double dark_level = 0;    // added to every reading, 1/sr
  double registration = 0;  // standard deviation of each image's shift along x and along y, texels
  texel::Rig rig;           // lights and viewers that are not far
  std::uint64_t seed = 1;
};

// "NAME=LOW:HIGH". Throws InputError.
Variation parse_variation(const std::string& text);

// "256x256". Throws InputError.
void parse_texels(const std::string& text, TexelOptions& options);

// What is where: of every texel its material and normal.
class Surface {
 public:
  // Throws InputError on parameters that the material has not, and values out of range.
  Surface(const Material& material, const TexelOptions& options);

  // At a texel's centre where both are whole.
  Material material(double x, double y) const;
  Vec3<double> normal(double x, double y) const;
  // Every parameter and the normal as planes.
  texel::Planes truth() const;

 private:
  double field(std::size_t which, double x, double y) const;

  Material material_;
  TexelOptions options_;
};

// Lights (and viewers) spread evenly over the hemisphere to 75 degrees. One row per image.
io::SampleTable stack_directions(const TexelOptions& options);

// Writes a stack into the folder (texel/stack.h), and what is true to truth.exr in its folder `truth`. The
// same arguments give the same files on every machine. Throws InputError on settings out of range.
void write_stack(const std::filesystem::path& folder, const Material& material, const TexelOptions& options,
                 const io::Progress& progress = {});

}  // namespace brdf::synth
