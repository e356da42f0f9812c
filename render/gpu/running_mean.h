// The mean of pictures that are drawn one after the other into one image, and their scatter, kept on the
// device.
#pragma once

#include "render/gpu/passes.h"

namespace brdf::render {

class RunningMean {
 public:
  // Of what `image` shows whenever it is added; it outlives this.
  RunningMean(Device& device, Image& image);
  void reset() { count_ = 0; }
  int count() const { return count_; }

  void record_add(VkCommandBuffer commands);
  // Adds the mean's colour to what is in `target`, or to black.
  enum class Over { what_is_there, black };
  void record_mean(VkCommandBuffer commands, Image& target, Over over);

  // RGBA, row by row; after at least two pictures: the standard error of the mean, told from the scatter
  // between them.
  std::vector<float> standard_error();

 private:
  Device* device_;
  Image* image_;
  int count_ = 0;
  Image sum_, squares_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet image_set_ = VK_NULL_HANDLE, sum_set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> accumulate_, mean_;
};

}  // namespace brdf::render
