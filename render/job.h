// What `brdf render` does: from files to a picture and its measures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/compare/state.h"
#include "render/picture/picture.h"
#include "render/reference/reference.h"

namespace brdf::render {

inline constexpr int kDefaultSamples = 64;

struct Job {
  std::vector<std::filesystem::path> materials;
  // Materials that are ready, with what stands below each, and the file they were made of.
  std::vector<std::pair<std::string, Material>> row;
  std::filesystem::path row_source;
  std::string shape;  // what materials are shown on, as a scene's "mesh"; empty: spheres
  std::filesystem::path scene, state, output;  // output: .exr or .png
  std::optional<int> width, height;
  std::optional<float> exposure;
  bool exposure_from_picture = false;  // instead
  std::optional<int> supersample;  // samples across a pixel; none: 4, and 1 for an EXR that holds more than A
  Rounding rounding = Rounding::dithered;
  std::optional<std::string> tone_map, shading;
  std::optional<std::string> environment;  // a picture's file or a Formula's name, instead of the scene's
  std::optional<float> rotation;           // of the environment, degrees
  int samples = kDefaultSamples;           // of its light, per pixel
  bool hard_light = false;                 // materials to look at do not stand in the studio
  bool per_vertex = false, as_coded = false;
  int gbuffer_bits = 16;
  std::uint64_t memory_limit = 0;  // bytes, 0: none
  bool forward = false;
  bool gbuffer = false;             // EXR: the seven targets as layers too
  std::string compare;              // B: "embree", or a material's file
  std::filesystem::path measured;   // B: a sample table, with the same lights
  std::optional<std::string> show;  // PNG: the name of a Display
  std::optional<float> split;  // share of the width that shows A; none: the split cuts through the highlight
  bool labels = true;          // PNG: names and numbers where it holds several pictures
  std::optional<glm::ivec2> probe;   // pixel whose values are wanted
  std::optional<double> plot_theta;  // lobe plot: angle of the light in degrees
  std::optional<std::string> solo;   // lobe plot: this curve alone
  bool validation = false;           // under the validation layers
  // Frames with the camera once round its target, the first being the picture itself: .webp, or PNG files
  // whose name has the frame's number where `output` has %d or %04d.
  std::optional<int> turntable;
  double frames_per_second = 25;
  int quality = 90;                        // of .webp: 100 is without loss
  std::function<void(int, int)> progress;  // frames done, of how many
};

struct JobReport {
  std::string device;
  int width = 0, height = 0;
  float exposure = 0;  // stops
  double clipped = 0;  // share of surface pixels that the display clips
  std::string other;   // name of B, where there is one
  std::optional<Difference> difference;
  std::vector<std::pair<std::string, double>>
      passes;         // milliseconds; with an environment of one run of kRun samples
  int samples = 0;    // of an environment's light, 0: there is none
  double noise = -1;  // see Pictures::noise
  std::optional<PixelProbe> probe;
  glm::vec4 probed_a{0}, probed_b{0};  // the pictures' values at the probed pixel
  unsigned validation_messages = 0;
  std::vector<std::string> notes;  // how channels became colours where their names do not say it
};

// The job with sample tables that stand among its materials (told by their content) as what they are compared
// with. Throws InputError where there are two. What such a job shows without a material is the samples alone.
Job with_samples_told(Job job);
// A material to begin with: the catalogue's first canonical form of facets.
std::pair<std::string, Material> any_material();

// What a job means, as the viewer's state: a saved one, a scene, or materials. Throws InputError.
ViewState state_of(const Job& job);
// Puts the job's environment and its rotation into a scene. Throws InputError where there is nothing to
// rotate.
void apply_environment(const Job& job, Scene& scene);
// How the channels of a state's materials became colours, a line for each material that does not say it.
std::vector<std::string> colour_notes(const ViewState& state);
// Renders and writes the output, if one is named. Throws
// InputError or EnvironmentError; nothing is written then.
JobReport run(const Job& job);
// Writes the lobe plot of the job's materials (A, and B where it is a material; measured points where it is a
// table) as PNG: in the plane of incidence, or as a body.
enum class LobeView { plane, body };
void write_lobes(const Job& job, LobeView view = LobeView::plane);

// Writes maps as PNG into a folder, which is made: "rusty_metal"
// (albedo, normal, roughness, metallic) or "tiles" (albedo).
void write_maps(const std::string& kind, int size, std::uint64_t seed, const std::filesystem::path& folder);
// Writes the lookup article's tables as PNG into a folder:
// every factor, and the product with the article's slip.
void write_lookup_pictures(const std::filesystem::path& folder);

}  // namespace brdf::render
