#include "render/gpu/light_points.h"

#include "render/gpu/shader_code.h"

namespace brdf::render {
namespace {

constexpr std::array<Binding, 2> kPointBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
                                                Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
constexpr VkExtent2D kPointExtent{kLightSquare, kLightSquare* std::uint32_t(kRun)};
constexpr VkImageUsageFlags kPointUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

}  // namespace

LightPoints::LightPoints(Device& device)
    : device_(&device),
      towards_(device, kColorFormat, kPointExtent, kPointUsage),
      radiance_(device, kColorFormat, kPointExtent, kPointUsage),
      sampler_(make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE)),
      layout_(make_set_layout(device, kPointBindings)),
      pool_(make_descriptor_pool(device, kPointBindings, 1)),
      set_(allocate_set(device, pool_.get(), layout_.get())) {
  write_image(device, set_, 0, towards_.view(), sampler_.get());
  write_image(device, set_, 1, radiance_.view(), sampler_.get());
}

void LightPoints::make_pipeline_of(VkPipelineLayout layout) {
  pipeline_ = make_pipeline(*device_, {.vertex = shader_code::screen_vertex,
                                       .fragment = shader_code::light_points,
                                       .colors = {kColorFormat, kColorFormat},
                                       .layout = layout});
}

void LightPoints::record(VkCommandBuffer commands, VkPipelineLayout layout, const RunPush& push) {
  for (Image* image : {&towards_, &radiance_}) image->transition(commands, Use::color_attachment, true);
  begin_colors(commands, {&towards_, &radiance_}, VK_ATTACHMENT_LOAD_OP_DONT_CARE);
  const VkRect2D wanted{{0, 0}, {kLightSquare, kLightSquare * std::uint32_t(push.count)}};
  vkCmdSetScissor(commands, 0, 1, &wanted);
  vkCmdPushConstants(commands, layout, kDrawingStages, 0, sizeof push, &push);
  draw_screen(commands, pipeline_.get());
  vkCmdEndRendering(commands);
}

void LightPoints::prepare_to_read(VkCommandBuffer commands) {
  for (Image* image : {&towards_, &radiance_}) image->transition(commands, Use::sampled);
}

}  // namespace brdf::render
