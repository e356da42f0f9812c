#include "render/viewer/display_pass.h"

#include <cmath>

#include "render/gpu/shader_code.h"
#include "render/picture/dither.h"

namespace brdf::render {
namespace {

constexpr std::array kBindings{
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2},
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, std::uint32_t(kTargetCount)},
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};

struct Push {  // as in shaders/display.frag
  glm::ivec2 size, origin, place;
  float gain, split, extent;
  int bits, plus_minus;
};

// Returns a tile of the thresholds for rounding to bytes.
Image dither_tile(Device& device) {
  std::vector<float> thresholds;
  for (int k = 0; k < kDitherTile * kDitherTile; ++k)
    thresholds.push_back(dither_threshold(k % kDitherTile, k / kDitherTile));
  Image tile(device, VK_FORMAT_R32_SFLOAT, {kDitherTile, kDitherTile},
             VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
  upload(device, tile, std::as_bytes(std::span(thresholds)));
  return tile;
}

}  // namespace

DisplayPass::DisplayPass(Device& device, VkRenderPass render_pass)
    : device_(&device), render_pass_(render_pass), dither_(dither_tile(device)) {
  sampler_ = make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  set_layout_ = make_set_layout(device, kBindings);
  pool_ = make_descriptor_pool(device, kBindings, 1);
  set_ = allocate_set(device, pool_.get(), set_layout_.get());
  write_image(device, set_, 2, dither_.view(), sampler_.get());
  const std::array sets{set_layout_.get()};
  layout_ = make_pipeline_layout(device, sets, sizeof(Push));
}

VkPipeline DisplayPass::pipeline(Display display, ToneMap tone_map) {
  Owned<VkPipeline>& pipeline = pipelines_[{display, tone_map}];
  if (!pipeline.get())
    pipeline = make_pipeline(
        *device_, {.vertex = shader_code::screen_vertex,
                   .fragment = shader_code::display,
                   .constants = {std::uint32_t(display), std::uint32_t(tone_map), std::uint32_t(kDitherTile)},
                   .colors = {VK_FORMAT_UNDEFINED},
                   .layout = layout_.get(),
                   .render_pass = render_pass_});
  return pipeline.get();
}

void DisplayPass::show(const Image& a, const Image& b, Renderer* targets) {
  write_image(*device_, set_, 0, a.view(), sampler_.get(), 0);
  write_image(*device_, set_, 0, b.view(), sampler_.get(), 1);
  for (std::uint32_t k = 0; k < kTargetCount; ++k)
    write_image(*device_, set_, 1, targets ? targets->target(Target(k)).view() : a.view(), sampler_.get(), k);
}

void DisplayPass::record(VkCommandBuffer commands, const ViewState& state, const VkRect2D& place,
                         VkExtent2D pictures, float object_extent, int bits) {
  const VkViewport viewport{float(place.offset.x),
                            float(place.offset.y),
                            float(place.extent.width),
                            float(place.extent.height),
                            0,
                            1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &place);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline(state.display, state.scene.tone_map));
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set_, 0, nullptr);
  const Push push{{int(pictures.width), int(pictures.height)},
                  {place.offset.x, place.offset.y},
                  {int(place.extent.width), int(place.extent.height)},
                  std::exp2(state.scene.exposure),
                  state.split,
                  object_extent,
                  bits,
                  state.other == Other::samples};
  vkCmdPushConstants(commands, layout_.get(), kDrawingStages, 0, sizeof push, &push);
  vkCmdDraw(commands, 3, 1, 0, 0);
}

}  // namespace brdf::render
