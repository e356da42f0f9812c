// The work of `brdf render`: from files to a picture and its measures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/samples/samples.h"
#include "render/compare/state.h"
#include "render/picture/picture.h"
#include "render/reference/reference.h"

namespace brdf::render {

inline constexpr int kDefaultSamples = 64;
// Materials to look at are drawn until the noise is at most this, or until a pixel has this many samples.
inline constexpr double kDefaultNoise = 0.02;
inline constexpr int kMostDefaultSamples = 256, kMostNoiseSamples = 4096;

struct Job {
  std::vector<std::filesystem::path> materials;
  // Prepared materials, each with the label below it, and the file from which they were made.
  std::vector<std::pair<std::string, Material>> row;
  std::filesystem::path row_source;
  // The shape that shows the materials, as in a scene's "mesh"; empty: spheres.
  std::string shape;
  std::filesystem::path scene, state, output;  // output: .exr or .png
  std::optional<int> width, height;
  std::optional<float> exposure;
  bool exposure_from_picture = false;  // computed from the picture
  // Samples across a pixel; std::nullopt: 4, but 1 for an EXR that contains more than A.
  std::optional<int> supersample;
  Rounding rounding = Rounding::dithered;
  std::optional<std::string> tone_map, shading;
  // The file of a picture or the name of a Formula, in place of the scene's environment.
  std::optional<std::string> environment;
  std::optional<float> rotation;  // of the environment, degrees
  int samples = kDefaultSamples;  // of the environment's light, per pixel
  // The noise (Pictures::noise) at or below which no further samples are drawn; std::nullopt: draws
  // `samples`.
  std::optional<double> noise;
  int most_samples = kMostNoiseSamples;  // the limit if the noise does not fall to `noise`
  bool hard_light = false;               // materials are not lit by the studio
  bool in_window = false;                // the state is for a window, which has no output
  bool per_vertex = false, as_coded = false;
  int gbuffer_bits = 16;
  std::uint64_t memory_limit = 0;  // bytes, 0: no limit
  bool forward = false;
  bool gbuffer = false;             // EXR: add the seven targets as layers
  std::string compare;              // B: "embree", or the file of a material
  std::filesystem::path measured;   // B: a sample table, with the same lights
  std::optional<std::string> show;  // PNG: the name of a Display
  // Share of the width that shows A; std::nullopt: the split passes through the highlight.
  std::optional<float> split;
  bool labels = true;                // PNG: names and numbers if it contains several pictures
  std::optional<glm::ivec2> probe;   // pixel to report the values of
  std::optional<double> plot_theta;  // lobe plot: angle of the light in degrees
  std::optional<std::string> solo;   // lobe plot: show only this curve
  bool validation = false;           // run under the validation layers
  // Number of frames of a turn of the camera round its target; the first frame is the picture itself. The
  // output is a .webp, or PNG files if the name of `output` contains %d or %04d, which is replaced by the
  // number of the frame.
  std::optional<int> turntable;
  double frames_per_second = 25;
  int quality = 90;  // of .webp: 100 is lossless
  // Returns the median relative error of a material at the measurements themselves; NaN if it cannot be
  // compared. Passed by the caller because rendering does not depend on fits.
  std::function<double(const Material&, const io::SampleTable&)> deviation;
  // Called with the finished parts and their total number: the frames of a turn, or the sample places of the
  // picture that is written.
  std::function<void(int, int)> progress;
};

struct JobReport {
  std::string device;
  int width = 0, height = 0;
  float exposure = 0;     // stops
  double clipped = 0;     // share of surface pixels that the display clips
  double not_finite = 0;  // share of surface pixels with a value that is not a finite number
  std::string other;      // name of B; empty without B
  std::optional<Difference> difference;
  // B shows smoothed measurements: their scatter, which B does not show, and Job::deviation.
  std::optional<double> scatter, deviation;
  // Milliseconds; with an environment, of one run of kRun samples.
  std::vector<std::pair<std::string, double>> passes;
  int samples = 0;    // samples of an environment's light; 0: no environment
  double noise = -1;  // see Pictures::noise
  std::optional<PixelProbe> probe;
  glm::vec4 probed_a{0}, probed_b{0};  // the pictures' values at the probed pixel
  unsigned validation_messages = 0;
  // Mapping of channels to colours, if the names of the channels do not determine it.
  std::vector<std::string> notes;
};

// Moves sample tables among the job's materials (detected from their content) to `measured`, which the
// materials are compared with. Throws InputError if there is more than one table. A job without materials
// then shows the samples alone.
Job with_samples_told(Job job);
// Returns a material to start with: the first canonical microfacet form of the catalogue.
std::pair<std::string, Material> any_material();

// Returns the viewer state that a job describes: a saved state, a scene, or materials. Throws InputError.
ViewState state_of(const Job& job);
// Returns whether the job shows materials without a scene, in an environment and next to nothing else.
bool shows_materials_in_light(const Job& job);
// Applies the job's environment and its rotation to a scene. Throws InputError if a rotation is given but
// there is no environment to rotate.
void apply_environment(const Job& job, Scene& scene);
// Returns how the channels of a state's materials were mapped to colours: a line for each material whose
// channel names do not determine the mapping.
std::vector<std::string> colour_notes(const ViewState& state);
// Renders and writes the output, if one is given. Throws InputError or EnvironmentError; nothing is written
// then.
JobReport run(const Job& job);
// Writes the lobe plot of the job's materials as PNG, in the plane of incidence or as a body. The plot
// shows A, B if B is a material, and the measured points if B is a sample table.
enum class LobeView { plane, body };
void write_lobes(const Job& job, LobeView view = LobeView::plane);

// Writes maps as PNG into a folder and creates the folder: "rusty_metal" (albedo, normal, roughness,
// metallic) or "tiles" (albedo). `progress` is called with the number of written pictures and their total.
void write_maps(const std::string& kind, int size, std::uint64_t seed, const std::filesystem::path& folder,
                const std::function<void(int, int)>& progress = {});
// Writes the lookup article's tables as PNG into a folder: each factor, and the product with the article's
// error. `progress`: as in write_maps().
void write_lookup_pictures(const std::filesystem::path& folder,
                           const std::function<void(int, int)>& progress = {});

}  // namespace brdf::render
