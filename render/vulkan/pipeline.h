// Compute pipelines, graphics pipelines for dynamic rendering, and descriptor sets.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/vulkan/device.h"

namespace brdf::render {

using Spirv = std::span<const std::uint32_t>;

enum class VertexInput { none, mesh, mesh_without_tangent, mesh_position };
// add: adds to the colour, with the new alpha; add_color: adds to the colour and keeps the alpha; add_all:
// adds to colour and alpha.
enum class Blend { replace, add, add_color, add_all };

struct PipelineDescription {
  Spirv vertex, fragment;
  std::vector<std::uint32_t> constants;  // specialisation constants 0, 1, ... of both shaders
  VertexInput input = VertexInput::none;
  std::vector<VkFormat> colors;
  bool depth = false;  // D32, reversed: nearer is greater
  // vkCmdSetCullMode decides before each draw; otherwise nothing is culled.
  bool culls = false;
  // Nothing is rasterised, to measure the cost of only the vertex work.
  bool vertices_only = false;
  Blend blend = Blend::replace;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkRenderPass render_pass = VK_NULL_HANDLE;  // null: dynamic rendering into `colors`
};

Owned<VkShaderModule> make_module(const Device& device, Spirv code);
Owned<VkPipeline> make_pipeline(const Device& device, const PipelineDescription& description);
// A pipeline of one compute shader.
Owned<VkPipeline> make_compute_pipeline(const Device& device, VkPipelineLayout layout, Spirv code,
                                        const VkSpecializationInfo* constants = nullptr);

struct Binding {
  VkDescriptorType type;
  std::uint32_t count = 1;
};
inline constexpr VkShaderStageFlags kDrawingStages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
// Creates a layout with bindings 0, 1, ... visible to these stages.
Owned<VkDescriptorSetLayout> make_set_layout(const Device& device, std::span<const Binding> bindings,
                                             VkShaderStageFlags stages = kDrawingStages);
Owned<VkPipelineLayout> make_pipeline_layout(const Device& device,
                                             std::span<const VkDescriptorSetLayout> sets,
                                             std::uint32_t push_constant_bytes,
                                             VkShaderStageFlags stages = kDrawingStages);
Owned<VkSampler> make_sampler(const Device& device, VkFilter filter, VkSamplerAddressMode address);

// Creates a pool for exactly `sets` sets of these bindings; `freeable`: the sets may be freed individually.
Owned<VkDescriptorPool> make_descriptor_pool(const Device& device, std::span<const Binding> bindings,
                                             std::uint32_t sets, bool freeable = false);
VkDescriptorSet allocate_set(const Device& device, VkDescriptorPool pool, VkDescriptorSetLayout layout);
void write_buffer(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type,
                  VkBuffer buffer);
void write_image(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view,
                 VkSampler sampler, std::uint32_t element = 0);

}  // namespace brdf::render
