// Draws pictures into the window: tone map, comparisons, the seven targets.
#pragma once

#include <map>
#include <tuple>

#include "render/compare/state.h"
#include "render/gpu/renderer.h"

namespace brdf::render {

class DisplayPass {
 public:
  DisplayPass(Device& device, VkRenderPass render_pass);
  // Sets the images to show from now on. `b` may be the same as `a`; `targets` is null if there are no
  // targets. The device must be idle.
  void show(const Image& a, const Image& b, Renderer* targets);
  struct Look {
    Display display;
    ToneMap tone_map;
    float exposure, split;
    bool plus_minus;      // the difference on a signed scale
    VkExtent2D pictures;  // size
    float object_extent;
    int bits;
  };
  // Records the part that comes before the window's own pass. `place`: the size in the window, in pixels.
  // Pictures of another size are finished at their own size and then enlarged, because the tone map takes
  // most of the time.
  void prepare(VkCommandBuffer commands, const Look& look, VkExtent2D place);
  void record(VkCommandBuffer commands, const Look& look, const VkRect2D& place);

 private:
  void draw(VkCommandBuffer commands, const Look& look, const VkRect2D& place, VkRenderPass render_pass);
  void enlarge(VkCommandBuffer commands, const VkRect2D& place);
  VkPipeline pipeline(const Look& look, VkRenderPass render_pass);

  Device* device_;
  VkRenderPass render_pass_;
  Image dither_, small_;  // small_: a finished picture that is enlarged
  Owned<VkSampler> sampler_, linear_;
  Owned<VkDescriptorSetLayout> set_layout_, small_set_layout_;
  Owned<VkDescriptorPool> pool_, small_pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE, small_set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> layout_, enlarging_layout_;
  Owned<VkPipeline> enlarging_;
  std::map<std::tuple<Display, ToneMap, bool>, Owned<VkPipeline>> pipelines_;  // made when first shown
};

}  // namespace brdf::render
