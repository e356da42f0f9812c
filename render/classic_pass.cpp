#include "render/classic_pass.h"

#include <cmath>

#include "render/lookup.h"
#include "render/passes.h"
#include "render/shader_code.h"

namespace brdf::render {
namespace {

constexpr std::array kTableBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};

}  // namespace

ClassicPass::ClassicPass(Device& device, const GpuScene& gpu) : device_(&device) {
  table_layout_ = make_set_layout(device, kTableBindings);
  table_pool_ = make_descriptor_pool(device, kTableBindings, 2);
  sampler_ = make_sampler(device, VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  const std::array sets{gpu.frame_layout(), table_layout_.get()};
  layout_ = make_pipeline_layout(device, sets, sizeof(int));
}

VkDescriptorSet ClassicPass::table_set(bool as_coded) {
  const auto found = tables_.find(as_coded);
  if (found != tables_.end()) return found->second.second;
  std::vector<std::uint8_t> bytes;
  for (const float v : lookup_table(LookupFactor::product, as_coded))
    bytes.push_back(std::uint8_t(std::lround(v * 255)));
  Image image(*device_, VK_FORMAT_R8_UNORM, {kLookupSize, kLookupSize},
              VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
  upload(*device_, image, std::as_bytes(std::span(bytes)));
  const VkDescriptorSet set = allocate_set(*device_, table_pool_.get(), table_layout_.get());
  write_image(*device_, set, 0, image.view(), sampler_.get());
  tables_.emplace(as_coded, std::pair(std::move(image), set));
  return set;
}

VkPipeline ClassicPass::pipeline(const Scene& scene) {
  Owned<VkPipeline>& found = pipelines_[{scene.shading, scene.as_coded, scene.per_vertex}];
  if (!found) {
    found = make_pipeline(*device_,
                          {.vertex = shader_code::classic_vertex(),
                           .fragment = shader_code::classic(),
                           .constants = {std::uint32_t(scene.shading), scene.as_coded, scene.per_vertex},
                           .input = VertexInput::mesh_without_tangent,
                           .colors = {kColorFormat},
                           .depth = true,
                           .layout = layout_.get()});
  }
  return found.get();
}

void ClassicPass::record(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu, Image& color,
                         Image& depth) {
  const VkPipeline drawing = pipeline(scene.scene);
  const std::array sets{gpu.frame_set(), table_set(scene.scene.as_coded)};
  begin_forward(commands, color, depth);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, drawing);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0,
                          std::uint32_t(sets.size()), sets.data(), 0, nullptr);
  for (std::size_t object = 0; object < scene.meshes.size(); ++object) {
    gpu.draw(commands, layout_.get(), object, item_index(scene, 0, object),
             scene.scene.shading == Shading::flat);
  }
  vkCmdEndRendering(commands);
}

}  // namespace brdf::render
