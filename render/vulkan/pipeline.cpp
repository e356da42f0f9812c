#include "render/vulkan/pipeline.h"

#include <array>
#include <cstddef>

#include "render/mesh/mesh.h"

namespace brdf::render {
namespace {

constexpr VkVertexInputBindingDescription kVertexBinding{0, sizeof(Vertex), VK_VERTEX_INPUT_RATE_VERTEX};
// The tangent is last, so that shaders without a tangent use the first three attributes.
constexpr std::array kVertexAttributes{
    VkVertexInputAttributeDescription{0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
    VkVertexInputAttributeDescription{1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
    VkVertexInputAttributeDescription{3, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv)},
    VkVertexInputAttributeDescription{2, 0, VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, tangent)}};

VkPipelineColorBlendAttachmentState blend_state(Blend blend) {
  VkPipelineColorBlendAttachmentState state{};
  state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                         VK_COLOR_COMPONENT_A_BIT;
  if (blend != Blend::replace) {
    state.blendEnable = VK_TRUE;
    state.srcColorBlendFactor = state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    state.srcAlphaBlendFactor = blend == Blend::add_color ? VK_BLEND_FACTOR_ZERO : VK_BLEND_FACTOR_ONE;
    state.dstAlphaBlendFactor = blend == Blend::add ? VK_BLEND_FACTOR_ZERO : VK_BLEND_FACTOR_ONE;
  }
  return state;
}

}  // namespace

Owned<VkShaderModule> make_module(const Device& device, Spirv code) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  return owned(device.get(), vkCreateShaderModule, vkDestroyShaderModule, info, "vkCreateShaderModule");
}

Owned<VkPipeline> make_pipeline(const Device& device, const PipelineDescription& d) {
  const auto vertex = make_module(device, d.vertex), fragment = make_module(device, d.fragment);
  std::vector<VkSpecializationMapEntry> entries(d.constants.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {i, i * 4, 4};
  const VkSpecializationInfo specialization{std::uint32_t(entries.size()), entries.data(),
                                            d.constants.size() * 4, d.constants.data()};
  std::array<VkPipelineShaderStageCreateInfo, 2> stages{};
  for (std::size_t i = 0; i < 2; ++i) {
    stages[i] = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    stages[i].stage = i == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[i].module = i == 0 ? vertex.get() : fragment.get();
    stages[i].pName = "main";
  }
  stages[0].pSpecializationInfo = stages[1].pSpecializationInfo = &specialization;

  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  if (d.input != VertexInput::none) {
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &kVertexBinding;
    input.vertexAttributeDescriptionCount = d.input == VertexInput::mesh            ? 4
                                            : d.input == VertexInput::mesh_position ? 1
                                                                                    : 3;
    input.pVertexAttributeDescriptions = kVertexAttributes.data();
  }
  VkPipelineInputAssemblyStateCreateInfo assembly{
      VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.polygonMode = VK_POLYGON_MODE_FILL;
  raster.cullMode = VK_CULL_MODE_NONE;  // surfaces seen from behind get the back-face colour
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.lineWidth = 1;
  raster.rasterizerDiscardEnable = d.vertices_only;
  VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = d.depth;
  depth.depthCompareOp = VK_COMPARE_OP_GREATER;
  const std::vector<VkPipelineColorBlendAttachmentState> attachments(d.colors.size(), blend_state(d.blend));
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = std::uint32_t(attachments.size());
  blend.pAttachments = attachments.data();
  std::vector dynamic_states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  if (d.culls) dynamic_states.push_back(VK_DYNAMIC_STATE_CULL_MODE);
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = std::uint32_t(dynamic_states.size());
  dynamic.pDynamicStates = dynamic_states.data();

  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = std::uint32_t(d.colors.size());
  rendering.pColorAttachmentFormats = d.colors.data();
  rendering.depthAttachmentFormat = d.depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED;
  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  if (d.render_pass == VK_NULL_HANDLE) info.pNext = &rendering;
  info.renderPass = d.render_pass;
  info.stageCount = std::uint32_t(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &multisample;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = d.layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateGraphicsPipelines(device.get(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
        "vkCreateGraphicsPipelines");
  return Owned<VkPipeline>(device.get(), pipeline, vkDestroyPipeline);
}

Owned<VkPipeline> make_compute_pipeline(const Device& device, VkPipelineLayout layout, Spirv code,
                                        const VkSpecializationInfo* constants) {
  const Owned<VkShaderModule> module = make_module(device, code);
  VkComputePipelineCreateInfo create{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  create.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  create.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  create.stage.module = module.get();
  create.stage.pName = "main";
  create.stage.pSpecializationInfo = constants;
  create.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(vkCreateComputePipelines(device.get(), VK_NULL_HANDLE, 1, &create, nullptr, &pipeline),
        "vkCreateComputePipelines");
  return Owned<VkPipeline>(device.get(), pipeline, vkDestroyPipeline);
}

Owned<VkDescriptorSetLayout> make_set_layout(const Device& device, std::span<const Binding> bindings,
                                             VkShaderStageFlags stages) {
  std::vector<VkDescriptorSetLayoutBinding> entries(bindings.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i)
    entries[i] = {i, bindings[i].type, bindings[i].count, stages};
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = std::uint32_t(entries.size());
  info.pBindings = entries.data();
  return owned(device.get(), vkCreateDescriptorSetLayout, vkDestroyDescriptorSetLayout, info,
               "vkCreateDescriptorSetLayout");
}

Owned<VkPipelineLayout> make_pipeline_layout(const Device& device,
                                             std::span<const VkDescriptorSetLayout> sets,
                                             std::uint32_t push_constant_bytes, VkShaderStageFlags stages) {
  const VkPushConstantRange range{stages, 0, push_constant_bytes};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = std::uint32_t(sets.size());
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = push_constant_bytes > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  return owned(device.get(), vkCreatePipelineLayout, vkDestroyPipelineLayout, info, "vkCreatePipelineLayout");
}

Owned<VkSampler> make_sampler(const Device& device, VkFilter filter, VkSamplerAddressMode address) {
  VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = info.minFilter = filter;
  info.addressModeU = info.addressModeV = info.addressModeW = address;
  return owned(device.get(), vkCreateSampler, vkDestroySampler, info, "vkCreateSampler");
}

Owned<VkDescriptorPool> make_descriptor_pool(const Device& device, std::span<const Binding> bindings,
                                             std::uint32_t sets, bool freeable) {
  std::vector<VkDescriptorPoolSize> sizes;
  for (const Binding& binding : bindings) sizes.push_back({binding.type, binding.count * sets});
  VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  if (freeable) info.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  info.maxSets = sets;
  info.poolSizeCount = std::uint32_t(sizes.size());
  info.pPoolSizes = sizes.data();
  return owned(device.get(), vkCreateDescriptorPool, vkDestroyDescriptorPool, info, "vkCreateDescriptorPool");
}

VkDescriptorSet allocate_set(const Device& device, VkDescriptorPool pool, VkDescriptorSetLayout layout) {
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pool;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(device.get(), &info, &set), "vkAllocateDescriptorSets");
  return set;
}

void write_buffer(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type,
                  VkBuffer buffer) {
  const VkDescriptorBufferInfo target{buffer, 0, VK_WHOLE_SIZE};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = type;
  write.pBufferInfo = &target;
  vkUpdateDescriptorSets(device.get(), 1, &write, 0, nullptr);
}

void write_image(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view,
                 VkSampler sampler, std::uint32_t element) {
  const VkDescriptorImageInfo target{sampler, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set;
  write.dstBinding = binding;
  write.dstArrayElement = element;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  write.pImageInfo = &target;
  vkUpdateDescriptorSets(device.get(), 1, &write, 0, nullptr);
}

}  // namespace brdf::render
