// The mean and the variance of pictures that are drawn one after the other into one image, kept on the
// device.
#pragma once

#include "render/gpu/passes.h"

namespace brdf::render {

class RunningMean {
 public:
  // Each record_add() adds the present content of `image`, which must outlive this object.
  RunningMean(Device& device, Image& image);
  void reset() { count_ = 0; }
  int count() const { return count_; }

  void record_add(VkCommandBuffer commands);
  // Adds the mean's colour times `share` to the content of `target`, or to black.
  enum class Over { what_is_there, black };
  void record_mean(VkCommandBuffer commands, Image& target, Over over, float share = 1);
  // Copies the colour of the present content of `image` to `target`, with alpha 0.
  void record_copy(VkCommandBuffer commands, Image& target);
  // Adds the colour of another image of the same size times `share` to the content of `target`. The device
  // must be idle until the commands run.
  void record_share(VkCommandBuffer commands, Image& other, Image& target, float share);

  // Returns the standard error of the mean, estimated from the variance between the pictures: RGBA, row by
  // row. Requires at least two pictures.
  std::vector<float> standard_error();

 private:
  void record(VkCommandBuffer commands, VkDescriptorSet from, Image& target, Over over, float factor);

  Device* device_;
  Image* image_;
  int count_ = 0;
  Image sum_, squares_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet image_set_ = VK_NULL_HANDLE, sum_set_ = VK_NULL_HANDLE, other_set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> accumulate_, mean_;
};

}  // namespace brdf::render
