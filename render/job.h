// What `brdf render` does: from files to a picture and its measures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/picture.h"
#include "render/renderer.h"

namespace brdf::render {

struct Job {
  std::vector<std::filesystem::path> materials;
  std::filesystem::path scene, output;  // output: .exr or .png
  std::optional<int> width, height;
  std::optional<float> exposure;
  std::optional<std::string> tone_map, shading;
  bool per_vertex = false, as_coded = false;
  int gbuffer_bits = 16;
  std::uint64_t memory_limit = 0;  // bytes, 0: none
  bool forward = false;
  bool gbuffer = false;  // PNG: the seven targets side by side instead of the lighting; EXR: as layers
  bool compare = false;  // with the Embree reference
  std::filesystem::path measured;  // sample table: rendered beside the material, same lighting
  bool split = false;              // PNG: left half the material, right half the reference or the samples
  bool validation = false;         // under the validation layers
};

struct JobReport {
  std::string device;
  int width = 0, height = 0;
  double clipped = 0;                    // share of surface pixels that the display clips
  std::optional<Difference> difference;  // against the reference, where asked for
  unsigned validation_messages = 0;
};

// The scene that a job means. Throws InputError.
Scene scene_of(const Job& job);
// Renders and writes the output. Throws InputError or EnvironmentError; nothing is written then.
JobReport run(const Job& job);

// Writes maps as PNG into a folder, which is made: "rusty_metal" (albedo, normal, roughness, metallic) or
// "tiles" (albedo).
void write_maps(const std::string& kind, int size, std::uint64_t seed, const std::filesystem::path& folder);
// Writes the lookup article's tables as PNG into a folder: every factor, and the product with the article's
// slip.
void write_lookup_pictures(const std::filesystem::path& folder);

// The seven targets as they are shown: vectors as v/2 + 1/2, position relative to its object's extent.
std::vector<BytePicture> target_pictures(Renderer& renderer);

}  // namespace brdf::render
