// Sums of a picture over several places in its pixels, kept on the device.
#pragma once

#include "render/gpu/passes.h"

namespace brdf::render {

// A run of samples of an environment's light: the mean over the run, and half the difference between the
// means of its two halves (of a run of one sample: the sample).
struct RunImages {
  Image mean, difference;
};

// Returns the bytes of device memory that the sums of a picture with this number of pixels take.
std::uint64_t place_sums_bytes(std::uint64_t pixels);

class PlaceSums {
 public:
  // Each record_add() adds the present content of `color` and of `run`, which must outlive this object. `run`
  // is null without an environment.
  PlaceSums(Device& device, Image& color, RunImages* run);
  void reset() { weights_ = 0; }
  // `weight`: of this place; `sign`: of the difference.
  void record_add(VkCommandBuffer commands, float weight, float sign);

  // Return the weighted means, RGBA row by row. A of the picture is the share of the places that show a
  // surface.
  std::vector<float> mean();
  // Both halves of the samples have the same expected value, so the mean difference has the variance of the
  // mean picture and the expected value 0.
  std::vector<float> difference();

 private:
  std::vector<float> divided(Image& image);

  Device* device_;
  Image* color_;
  RunImages* run_;
  float weights_ = 0;
  Image sum_, differences_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> pipeline_;
};

}  // namespace brdf::render
