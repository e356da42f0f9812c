#include "render/gpu/classic_pass.h"

#include "render/gpu/passes.h"
#include "render/gpu/shader_code.h"

namespace brdf::render {
namespace {

constexpr std::array kTableBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};

}  // namespace

ClassicPass::ClassicPass(Device& device, const GpuScene& gpu, const LookupTexture& lookup)
    : device_(&device), lookup_(lookup) {
  table_layout_ = make_set_layout(device, kTableBindings);
  table_pool_ = make_descriptor_pool(device, kTableBindings, 2);
  sampler_ = make_sampler(device, lookup.bilinear ? VK_FILTER_LINEAR : VK_FILTER_NEAREST,
                          VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  const std::array sets{gpu.frame_layout(), table_layout_.get()};
  layout_ = make_pipeline_layout(device, sets, sizeof(int));
}

VkDescriptorSet ClassicPass::table_set(bool as_coded) {
  const auto found = tables_.find(as_coded);
  if (found != tables_.end()) return found->second.second;
  const VkFormat format = lookup_.bits == 8    ? VK_FORMAT_R8_UNORM
                          : lookup_.bits == 16 ? VK_FORMAT_R16_UNORM
                                               : VK_FORMAT_R32_SFLOAT;
  const auto size = std::uint32_t(lookup_.size);
  Image image(*device_, format, {size, size}, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
  upload(*device_, image, lookup_texels(lookup_, as_coded));
  const VkDescriptorSet set = allocate_set(*device_, table_pool_.get(), table_layout_.get());
  write_image(*device_, set, 0, image.view(), sampler_.get());
  tables_.emplace(as_coded, std::pair(std::move(image), set));
  return set;
}

VkPipeline ClassicPass::pipeline(const Scene& scene) {
  Owned<VkPipeline>& found = pipelines_[{scene.shading, scene.as_coded, scene.per_vertex}];
  if (!found) {
    found = make_pipeline(*device_,
                          {.vertex = shader_code::classic_vertex,
                           .fragment = shader_code::classic,
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
  const VkDescriptorSet table = table_set(scene.scene.as_coded);
  begin_forward(commands, color, depth);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, drawing);
  bind(commands, layout_.get(), 0, gpu.frame_set());
  bind(commands, layout_.get(), 1, table);
  for (std::size_t object = 0; object < scene.meshes.size(); ++object) {
    gpu.draw(commands, layout_.get(), object, item_index(scene, 0, object),
             scene.scene.shading == Shading::flat);
  }
  vkCmdEndRendering(commands);
}

}  // namespace brdf::render
