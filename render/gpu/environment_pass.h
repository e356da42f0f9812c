// Light from an environment: runs of random directions for every pixel, added up over frames.
#pragma once

#include <map>
#include <tuple>

#include "render/gpu/light_points.h"
#include "render/gpu/passes.h"
#include "render/gpu/place_sums.h"
#include "render/gpu/running_mean.h"

namespace brdf::render {

// The picture of the light and its distributions on the device.
class LightImages {
 public:
  LightImages(Device& device, const LightMap& map);
  VkDescriptorSetLayout layout() const { return layout_.get(); }
  VkDescriptorSet set() const { return set_; }

 private:
  Image texels_, columns_, rows_, blurred_;
  Owned<VkSampler> sampler_, linear_;
  Owned<VkDescriptorSetLayout> layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};
// Returns the bytes of device memory that a light of this size takes, with its points.
std::uint64_t light_bytes(const LightMap& map);

class EnvironmentPass {
 public:
  // The light and the targets must outlive the pass.
  EnvironmentPass(Device& device, const GpuScene& gpu, const LightImages& light, const DeferredPass& deferred,
                  VkExtent2D extent, int gbuffer_bits);
  // Discards the sum because the scene has changed.
  void reset() { mean_.reset(); }
  // Discards the sum. From here on, runs have `samples_of_a_run` samples, at most kRun, and begin at sample
  // `first` of the sequence. A run takes every `stride`-th sample; the next run follows only if that is 1.
  void reset(int samples_of_a_run, int first, int stride = 1) {
    mean_.reset(), count_ = samples_of_a_run, first_ = first, stride_ = stride, smooth_ = false;
  }
  // Discards the sum. From here on, each run is the picture without noise of blurred_light.h.
  // `directions`: 1 or 2 for the lobe and as many for the cosine.
  void reset_to_smooth(int directions) { mean_.reset(), smooth_ = true, directions_ = directions; }
  bool is_smooth() const { return smooth_; }
  // Samples so far; 0 for the picture without noise.
  int samples() const { return smooth_ ? 0 : mean_.count() * count_; }

  // Draws the picture of the light behind the objects, over the content of `color`.
  void record_backdrop(VkCommandBuffer commands, const GpuScene& gpu, Image& color);
  // A run consists of begin_run(); for each layer record_points() and, while the layer's surfaces are in the
  // targets, record() for each tile of the picture; and end_run(), which adds the mean over all runs to
  // `color`. The smooth picture consists of calls of record() alone, which draw into `color` and include the
  // lights.
  void begin_run(VkCommandBuffer commands);
  void record_points(VkCommandBuffer commands, const GpuScene& gpu, std::uint32_t seed);
  void record(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu, std::size_t layer,
              const VkRect2D& tile, std::uint32_t seed, Image& color);
  void end_run(VkCommandBuffer commands, Image& color);
  RunImages& run() { return run_; }  // of the last run, also before its end

  // See RunningMean; each picture is a run.
  std::vector<float> standard_error() { return mean_.standard_error(); }

 private:
  RunPush push(std::uint32_t seed) const;
  VkPipeline pipeline(const Reflectance& form, int number, Blend blend, bool single);

  Device* device_;
  const LightImages* light_;
  const DeferredPass* deferred_;
  int bits_;
  int count_ = kRun, first_ = 0, stride_ = 1;
  int directions_ = 2;
  bool smooth_ = false;
  RunImages run_;
  RunningMean mean_;
  LightPoints points_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> backdrop_;
  FragmentCode code_;
  std::map<std::tuple<int, bool, Blend, bool>, Owned<VkPipeline>> pipelines_;
};

// Returns the bytes of device memory that the sums of a picture with this number of pixels take.
std::uint64_t sums_bytes(std::uint64_t pixels);

}  // namespace brdf::render
