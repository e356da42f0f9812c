// The points of a run that follow the light, found once for all squares of pixels (render/light/points.h).
#pragma once

#include "render/gpu/passes.h"
#include "render/light/points.h"

namespace brdf::render {

// The layout of the runs' push constants is the same as in shaders/points.glsl.
struct RunPush {
  std::int32_t item;
  std::uint32_t seed;
  std::int32_t count;
  float first[kPointDimensions], step[kPointDimensions];
};

// Bytes of device memory of the points.
inline constexpr std::uint64_t kLightPointsBytes =
    2 * std::uint64_t(kLightSquare) * kLightSquare * std::uint64_t(kRun) * sizeof(glm::vec4);

class LightPoints {
 public:
  explicit LightPoints(Device& device);
  // `layout`: of the frame, the targets, the light and layout(), with a RunPush.
  void make_pipeline_of(VkPipelineLayout layout);
  // Draws the points of a run; the sets of the frame and of the light are bound.
  void record(VkCommandBuffer commands, VkPipelineLayout layout, const RunPush& push);
  void prepare_to_read(VkCommandBuffer commands);
  VkDescriptorSetLayout layout() const { return layout_.get(); }
  VkDescriptorSet set() const { return set_; }

 private:
  Device* device_;
  Image towards_, radiance_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  Owned<VkPipeline> pipeline_;
};

}  // namespace brdf::render
