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

constexpr std::array kSmallBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
constexpr VkFormat kSmallFormat = VK_FORMAT_R8G8B8A8_UNORM;

struct EnlargingPush {  // as in shaders/enlarge.frag
  glm::ivec2 origin, place;
};

// Returns whether pictures are finished at their own size. The targets are shown pixel by pixel.
bool is_enlarged(const DisplayPass::Look& look, VkExtent2D place) {
  return look.display != Display::gbuffer &&
         (look.pictures.width != place.width || look.pictures.height != place.height);
}

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

void set_place(VkCommandBuffer commands, const VkRect2D& place) {
  const VkViewport viewport{float(place.offset.x),
                            float(place.offset.y),
                            float(place.extent.width),
                            float(place.extent.height),
                            0,
                            1};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &place);
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
  linear_ = make_sampler(device, VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  small_set_layout_ = make_set_layout(device, kSmallBindings);
  small_pool_ = make_descriptor_pool(device, kSmallBindings, 1);
  small_set_ = allocate_set(device, small_pool_.get(), small_set_layout_.get());
  const std::array small_sets{small_set_layout_.get()};
  enlarging_layout_ = make_pipeline_layout(device, small_sets, sizeof(EnlargingPush));
  enlarging_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                      .fragment = shader_code::enlarge,
                                      .colors = {VK_FORMAT_UNDEFINED},
                                      .layout = enlarging_layout_.get(),
                                      .render_pass = render_pass});
}

VkPipeline DisplayPass::pipeline(const Look& look, VkRenderPass render_pass) {
  Owned<VkPipeline>& pipeline = pipelines_[{look.display, look.tone_map, render_pass != VK_NULL_HANDLE}];
  if (!pipeline.get())
    pipeline = make_pipeline(
        *device_,
        {.vertex = shader_code::screen_vertex,
         .fragment = shader_code::display,
         .constants = {std::uint32_t(look.display), std::uint32_t(look.tone_map), std::uint32_t(kDitherTile)},
         .colors = {render_pass ? VK_FORMAT_UNDEFINED : kSmallFormat},
         .layout = layout_.get(),
         .render_pass = render_pass});
  return pipeline.get();
}

void DisplayPass::show(const Image& a, const Image& b, Renderer* targets) {
  write_image(*device_, set_, 0, a.view(), sampler_.get(), 0);
  write_image(*device_, set_, 0, b.view(), sampler_.get(), 1);
  for (std::uint32_t k = 0; k < kTargetCount; ++k)
    write_image(*device_, set_, 1, targets ? targets->target(Target(k)).view() : a.view(), sampler_.get(), k);
}

void DisplayPass::prepare(VkCommandBuffer commands, const Look& look, VkExtent2D place) {
  if (!is_enlarged(look, place)) return;
  const VkExtent2D size = look.pictures;
  if (small_.extent().width != size.width || small_.extent().height != size.height) {
    small_ =
        Image(*device_, kSmallFormat, size, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    write_image(*device_, small_set_, 0, small_.view(), linear_.get());
  }
  small_.transition(commands, Use::color_attachment, true);
  begin_colors(commands, {&small_}, VK_ATTACHMENT_LOAD_OP_DONT_CARE);
  draw(commands, look, {{0, 0}, size}, VK_NULL_HANDLE);
  vkCmdEndRendering(commands);
  small_.transition(commands, Use::sampled);
}

void DisplayPass::record(VkCommandBuffer commands, const Look& look, const VkRect2D& place) {
  if (is_enlarged(look, place.extent))
    enlarge(commands, place);
  else
    draw(commands, look, place, render_pass_);
}

void DisplayPass::enlarge(VkCommandBuffer commands, const VkRect2D& place) {
  set_place(commands, place);
  bind(commands, enlarging_layout_.get(), 0, small_set_);
  const EnlargingPush push{{place.offset.x, place.offset.y},
                           {int(place.extent.width), int(place.extent.height)}};
  vkCmdPushConstants(commands, enlarging_layout_.get(), kDrawingStages, 0, sizeof push, &push);
  draw_screen(commands, enlarging_.get());
}

void DisplayPass::draw(VkCommandBuffer commands, const Look& look, const VkRect2D& place,
                       VkRenderPass render_pass) {
  set_place(commands, place);
  bind(commands, layout_.get(), 0, set_);
  const Push push{{int(look.pictures.width), int(look.pictures.height)},
                  {place.offset.x, place.offset.y},
                  {int(place.extent.width), int(place.extent.height)},
                  std::exp2(look.exposure),
                  look.split,
                  look.object_extent,
                  look.bits,
                  look.plus_minus};
  vkCmdPushConstants(commands, layout_.get(), kDrawingStages, 0, sizeof push, &push);
  draw_screen(commands, pipeline(look, render_pass));
}

}  // namespace brdf::render
