// Draws a prepared scene without a window; the viewer records the same passes into its own frames.
#pragma once

#include <optional>
#include <vector>

#include "render/gpu/classic_pass.h"
#include "render/gpu/environment_pass.h"
#include "render/gpu/passes.h"
#include "render/gpu/shadow_pass.h"
#include "render/light/points.h"
#include "render/vulkan/timestamps.h"

namespace brdf::render {

enum class Path { deferred, forward };

struct RendererOptions {
  int gbuffer_bits = 16;  // 8, 16 or 32
  Path path = Path::deferred;
  LookupTexture lookup = {};  // for the shading mode "lookup"
  std::uint32_t seed = 1;     // for the environment's random directions
  // For pictures that are shown for a moment: large meshes have fewer triangles, and draw_smooth() uses fewer
  // directions.
  bool coarse = false;
  // place_sums() is used: its memory is checked with the memory of the picture.
  bool has_places = false;
};

// The samples of an environment's light in one picture: at most kRun, every `stride`-th one of the sequence
// from `first` on. `sign`: of the difference of the run's halves in PlaceSums.
struct PlaceRun {
  int samples, first, stride;
  float sign;
};

class Renderer {
 public:
  // Throws InputError if the picture is too large for the device or for its memory limit.
  Renderer(Device& device, const PreparedScene& scene, const RendererOptions& options = {});
  // Call when camera, lights, items or the environment have changed; the picture's size, meshes and
  // textures must be the same. A change of the shading mode allocates the images that the mode needs.
  void update(const PreparedScene& scene);
  // Draws and waits. Marks the passes "background", "shadow", "geometry", "lighting", "environment" or
  // "forward" in `times`, which may be null.
  void draw(Timestamps* times = nullptr);

  // Samples per pixel of an environment's light so far. Each draw adds a run of samples until update()
  // discards them.
  int samples() const { return environment_ ? environment_->samples() : 0; }
  // Continues with other random numbers and discards the sum.
  void reseed(std::uint32_t seed);
  // A picture can be drawn in parts: pieces of the meshes, then tiles of the picture, for each layer. All
  // parts in their order, in any number of calls, give the picture of draw(). Call begin_run() or
  // begin_smooth() before the first part.
  int parts() const;
  void draw_parts(int first, int count, Timestamps* times = nullptr);
  // The next picture has this run of an environment's light; earlier samples are discarded.
  void begin_run(const PlaceRun& run);
  // The next picture is the one of draw_smooth().
  void begin_smooth();
  // Draws until there are `samples` samples, from sample `first` of the sequence, in runs of at most `run`
  // samples; `run` is at most kRun. Draws once if there is no environment.
  void draw_samples(int samples, Timestamps* times = nullptr, int first = 0, int run = kRun);
  // For pictures through several places of a pixel: each draw_place() draws the scene with one run of samples
  // of an environment, and adds the picture to the sums with the run's number of samples as its weight. The
  // sums are of use until update() changes the environment.
  PlaceSums place_sums() { return {*device_, color_, environment_ ? &environment_->run() : nullptr}; }
  void draw_place(PlaceSums& sums, const PlaceRun& run);
  // Draws the scene without noise, but not exactly: the light of the environment is averaged over wide solid
  // angles (light/blurred_light.h). The exact picture if there is no environment.
  void draw_smooth(Timestamps* times = nullptr);
  // Returns the standard error of each pixel's channels, RGBA as in read_color(); zeros without an
  // environment.
  std::vector<float> read_standard_error();

  Image& color() { return color_; }
  const Image& color() const { return color_; }
  // Reads the lighting back: RGB, and A = 1 for pixels that show a surface.
  std::vector<float> read_color();
  // Reads a target of the first layer back, after draw(). Throws InputError if the scene is drawn without
  // targets.
  std::vector<float> read_target(Target target);
  Image& target(Target target) { return gbuffer_->targets[std::size_t(target)]; }
  const PreparedScene& scene() const { return scene_; }
  int gbuffer_bits() const { return options_.gbuffer_bits; }

 private:
  bool has_run() const { return environment_ && !environment_->is_smooth(); }
  void make_passes();
  void make_environment();
  void record_start(VkCommandBuffer commands, Timestamps* times);
  void record_parts(VkCommandBuffer commands, int first, int count, Timestamps* times);
  void record_tiles(VkCommandBuffer commands, std::size_t layer, int first, int count, Timestamps* times);

  Device* device_;
  PreparedScene scene_;
  RendererOptions options_;
  GpuScene gpu_;
  std::vector<MeshPart> mesh_parts_;
  Image color_;
  std::optional<GBuffer> gbuffer_;
  Image depth_;  // of the forward path
  SkyPass sky_;
  std::optional<DeferredPass> deferred_;
  std::optional<ForwardPass> forward_;
  std::optional<ClassicPass> classic_;
  std::optional<ShadowPass> shadow_;
  std::optional<LightImages> light_;
  std::optional<EnvironmentPass> environment_;
};

// Returns whether the scene is drawn through the seven targets; otherwise it is drawn forward.
bool uses_gbuffer(const Scene& scene, const RendererOptions& options);
// Returns the bytes of device memory that pictures of this size take (without the environment's picture).
std::uint64_t picture_bytes(const Scene& scene, const RendererOptions& options);

}  // namespace brdf::render
