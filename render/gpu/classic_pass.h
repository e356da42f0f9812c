// The articles' shading modes, drawn forward: vertex_color, flat, gouraud, phong, phong_blinn and lookup.
#pragma once

#include <map>
#include <tuple>

#include "render/gpu/gpu_scene.h"
#include "render/gpu/lookup.h"

namespace brdf::render {

class ClassicPass {
 public:
  ClassicPass(Device& device, const GpuScene& gpu, const LookupTexture& lookup = {});
  // Draws over the background that is already in `color`.
  void record(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu, Image& color,
              Image& depth);

 private:
  VkPipeline pipeline(const Scene& scene);
  // The lookup texture, with or without the article's error.
  VkDescriptorSet table_set(bool as_coded);

  Device* device_;
  LookupTexture lookup_;
  Owned<VkDescriptorSetLayout> table_layout_;
  Owned<VkDescriptorPool> table_pool_;
  Owned<VkSampler> sampler_;
  Owned<VkPipelineLayout> layout_;
  std::map<bool, std::pair<Image, VkDescriptorSet>> tables_;
  std::map<std::tuple<Shading, bool, bool>, Owned<VkPipeline>> pipelines_;
};

}  // namespace brdf::render
