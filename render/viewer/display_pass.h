// Draws pictures into the window: tone map, comparisons, the seven targets.
#pragma once

#include <map>

#include "render/compare/state.h"
#include "render/gpu/renderer.h"

namespace brdf::render {

class DisplayPass {
 public:
  DisplayPass(Device& device, VkRenderPass render_pass);
  // Sets the images to show from now on. `b` may be the same as `a`; `targets` is null if there are no
  // targets. The device must be idle.
  void show(const Image& a, const Image& b, Renderer* targets);
  // `place`: the place in the window, in pixels; pictures of another size are scaled.
  void record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place, VkExtent2D pictures,
              float object_extent, int bits);

 private:
  VkPipeline pipeline(Display display, ToneMap tone_map);

  Device* device_;
  VkRenderPass render_pass_;
  Image dither_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> layout_;
  std::map<std::pair<Display, ToneMap>, Owned<VkPipeline>> pipelines_;  // made when first shown
};

}  // namespace brdf::render
