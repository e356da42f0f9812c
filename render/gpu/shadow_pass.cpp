#include "render/gpu/shadow_pass.h"

#include "render/gpu/passes.h"
#include "render/gpu/shader_code.h"
#include "render/scene/shadow_view.h"

namespace brdf::render {
namespace {

constexpr VkFormat kMapFormat = VK_FORMAT_R32G32_SFLOAT;
constexpr VkExtent2D kMapExtent{kShadowMapSize, kShadowMapSize};

}  // namespace

ShadowPass::ShadowPass(Device& device, GpuScene& gpu)
    : map_(device, kMapFormat, kMapExtent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT),
      depth_(device, VK_FORMAT_D32_SFLOAT, kMapExtent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT),
      sampler_(make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE)) {
  const std::array sets{gpu.frame_layout()};
  layout_ = make_pipeline_layout(device, sets, sizeof(int));
  pipeline_ = make_pipeline(device, {.vertex = shader_code::shadow_vertex,
                                     .fragment = shader_code::shadow,
                                     .input = VertexInput::mesh_position,
                                     .colors = {kMapFormat},
                                     .depth = true,
                                     .layout = layout_.get()});
  gpu.set_shadow_map(map_.view(), sampler_.get());
}

void ShadowPass::record(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu) {
  if (gpu.shadow_places() == drawn_) return;
  drawn_ = gpu.shadow_places();
  begin_forward(commands, map_, depth_, VK_ATTACHMENT_LOAD_OP_CLEAR);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
  bind(commands, layout_.get(), 0, gpu.frame_set());
  for (std::size_t object = 0; object < scene.meshes.size(); ++object)
    gpu.draw(commands, layout_.get(), object, item_index(scene, 0, object));
  vkCmdEndRendering(commands);
  map_.transition(commands, Use::sampled);
}

}  // namespace brdf::render
