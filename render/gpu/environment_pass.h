// Light from all around: runs of random directions for every pixel, added up over frames.
#pragma once

#include <map>
#include <utility>

#include "render/gpu/passes.h"
#include "render/gpu/running_mean.h"
#include "render/light/points.h"

namespace brdf::render {

// The picture of the light and its distributions on the device.
class LightImages {
 public:
  LightImages(Device& device, const LightMap& map);
  VkDescriptorSetLayout layout() const { return layout_.get(); }
  VkDescriptorSet set() const { return set_; }

 private:
  Image texels_, columns_, rows_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};
// Bytes of device memory that a light of this size takes.
std::uint64_t light_bytes(const LightMap& map);

class EnvironmentPass {
 public:
  // The light and the targets outlive the pass.
  EnvironmentPass(Device& device, const GpuScene& gpu, const LightImages& light, const DeferredPass& deferred,
                  VkExtent2D extent, int gbuffer_bits);
  // What was added up is forgotten: the scene has changed.
  void reset() { mean_.reset(); }
  // The same, with runs of so many samples from here on, at most kRun, which begin at this one of the
  // sequence.
  void reset(int samples_of_a_run, int first) { mean_.reset(), count_ = samples_of_a_run, first_ = first; }
  int samples() const { return mean_.count() * count_; }

  // The light's picture behind the objects, over what is in `color`.
  void record_backdrop(VkCommandBuffer commands, const GpuScene& gpu, Image& color);
  // A run: begin, each layer while its surfaces are in the targets, and end, which adds the mean over all
  // runs so far to `color`.
  void begin_run(VkCommandBuffer commands);
  void record(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu, std::size_t layer,
              std::uint32_t seed);
  void end_run(VkCommandBuffer commands, Image& color);

  // See RunningMean; the pictures are runs.
  std::vector<float> standard_error() { return mean_.standard_error(); }

 private:
  VkPipeline pipeline(const Reflectance& form, int number);

  Device* device_;
  const LightImages* light_;
  const DeferredPass* deferred_;
  int bits_;
  int count_ = kRun, first_ = 0;
  Image run_;
  RunningMean mean_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> backdrop_;
  FragmentCode code_;
  std::map<int, Owned<VkPipeline>> pipelines_;
};

// Bytes of device memory that the sums of a picture of this size take.
std::uint64_t sums_bytes(std::uint64_t pixels);

}  // namespace brdf::render
