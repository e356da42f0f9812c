// The passes that draw a scene: deferred (geometry into seven targets, then lighting) and forward.
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <span>
#include <tuple>

#include "render/gpu/gpu_layout.h"
#include "render/gpu/gpu_scene.h"

namespace brdf::render {

inline constexpr VkFormat kColorFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

// The seven targets and their depth, with 8, 16 or 32 bits per channel.
struct GBuffer {
  GBuffer(Device& device, VkExtent2D extent, int bits);
  int bits;
  std::array<Image, kTargetCount> targets;
  Image depth;
};
VkFormat gbuffer_format(int bits);

// Commands that all passes need.
void set_viewport(VkCommandBuffer commands, VkExtent2D extent);
VkRenderingAttachmentInfo attachment(const Image& image, VkImageLayout layout, VkAttachmentLoadOp load,
                                     const glm::vec4& clear);

void bind(VkCommandBuffer commands, VkPipelineLayout layout, std::uint32_t first, VkDescriptorSet set);
// Begins drawing into colour attachments of the same size and sets the viewport.
void begin_colors(VkCommandBuffer commands, std::initializer_list<Image*> images, VkAttachmentLoadOp load);
// Draws a triangle that covers the picture.
void draw_screen(VkCommandBuffer commands, VkPipeline pipeline);
// Returns the reflectances of a layer, each once.
std::vector<Reflectance> forms_in(const std::vector<Item>& layer);
// Returns the index of the layer's only item of this form, or -1 if there are several items or no item.
int only_item(const PreparedScene& scene, std::size_t layer, const Reflectance& form);

// Begins drawing meshes over the content of `color` (or over zeros), with a fresh depth buffer, and sets
// the viewport.
void begin_forward(VkCommandBuffer commands, Image& color, Image& depth,
                   VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_LOAD);

// Begins drawing meshes into the targets, which are cleared if `fresh` is set.
void begin_targets(VkCommandBuffer commands, GBuffer& gbuffer, bool fresh = true);

// Fills the picture with the background; surfaces are drawn over it.
class SkyPass {
 public:
  SkyPass(Device& device, const GpuScene& gpu);
  void record(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu, Image& color);

 private:
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> pipeline_;
};

class DeferredPass {
 public:
  DeferredPass(Device& device, const GpuScene& gpu, GBuffer& gbuffer);
  // Draws these parts of the meshes; `fresh`: the targets are cleared before.
  void record_geometry(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu, std::size_t layer,
                       std::span<const MeshPart> parts, bool fresh);
  // Lights each form of the layer in the part of `tile` that its objects cover. Layers after the first are
  // added.
  void record_lighting(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu,
                       std::size_t layer, const VkRect2D& tile, Image& color);
  // For other passes that read the targets.
  void prepare_to_read(VkCommandBuffer commands) const;
  VkDescriptorSetLayout targets_layout() const { return targets_layout_.get(); }
  VkDescriptorSet targets_set() const { return targets_set_; }

 private:
  VkPipeline geometry_pipeline(bool textured);
  VkPipeline lighting_pipeline(const Reflectance& form, int number, bool add, bool single, bool dark);

  Device* device_;
  GBuffer* gbuffer_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> targets_layout_;
  Owned<VkDescriptorPool> targets_pool_;
  VkDescriptorSet targets_set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> geometry_layout_, lighting_layout_;
  std::map<bool, Owned<VkPipeline>> geometry_pipelines_;
  FragmentCode lighting_code_;
  std::map<std::tuple<int, bool, bool, bool>, Owned<VkPipeline>> lighting_pipelines_;
};

// Lights each fragment when it is rasterised, as a comparison for deferred rendering. Supports one layer
// only.
class ForwardPass {
 public:
  ForwardPass(Device& device, const GpuScene& gpu);
  void record(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu, Image& color,
              Image& depth);

 private:
  VkPipeline pipeline(const Reflectance& form, int number, bool textured);

  Device* device_;
  Owned<VkPipelineLayout> layout_;
  FragmentCode code_;
  std::map<std::pair<int, bool>, Owned<VkPipeline>> pipelines_;
};

// Returns a small rectangle of pixels that contains the bounding box of each item of this form, or the whole
// picture if a box reaches behind the camera.
VkRect2D covered_by_form(const PreparedScene& scene, std::size_t layer, const Reflectance& form,
                         VkExtent2D extent);
// Returns the common part of two rectangles; its width or its height is 0 if there is none.
VkRect2D common(const VkRect2D& a, const VkRect2D& b);

}  // namespace brdf::render
