// Draws the shadow map: the depth of the scene from the light that casts a shadow.
#pragma once

#include "render/gpu/gpu_scene.h"

namespace brdf::render {

class ShadowPass {
 public:
  // The constructor installs the map in the scene's frame set.
  ShadowPass(Device& device, GpuScene& gpu);
  // Draws the map again only if the light or an object has moved.
  void record(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu);

 private:
  std::vector<glm::mat4> drawn_;  // GpuScene::shadow_places() of the map
  Image map_, depth_;
  Owned<VkSampler> sampler_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> pipeline_;
};

}  // namespace brdf::render
