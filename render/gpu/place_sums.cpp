#include "render/gpu/place_sums.h"

#include "render/gpu/shader_code.h"

namespace brdf::render {
namespace {

constexpr std::array<Binding, 1> kDrawnBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 3}};
constexpr VkImageUsageFlags kPlacesSummed =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

}  // namespace

std::uint64_t place_sums_bytes(std::uint64_t pixels) {
  return 2 * pixels * std::uint64_t(texel_size(kColorFormat));
}

PlaceSums::PlaceSums(Device& device, Image& color, RunImages* run)
    : device_(&device),
      color_(&color),
      run_(run),
      sum_(device, kColorFormat, color.extent(), kPlacesSummed),
      differences_(device, kColorFormat, color.extent(), kPlacesSummed),
      sampler_(make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE)),
      set_layout_(make_set_layout(device, kDrawnBindings)),
      pool_(make_descriptor_pool(device, kDrawnBindings, 1)),
      set_(allocate_set(device, pool_.get(), set_layout_.get())) {
  // Without a run, the pipeline reads the first image only, but all bindings must be valid.
  const std::array drawn{color_, run ? &run->mean : color_, run ? &run->difference : color_};
  for (std::uint32_t k = 0; k < drawn.size(); ++k)
    write_image(device, set_, 0, drawn[k]->view(), sampler_.get(), k);
  const std::array sets{set_layout_.get()};
  layout_ = make_pipeline_layout(device, sets, 2 * sizeof(float));
  pipeline_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                     .fragment = shader_code::places,
                                     .constants = {run != nullptr},
                                     .colors = {kColorFormat, kColorFormat},
                                     .blend = Blend::add_all,
                                     .layout = layout_.get()});
}

void PlaceSums::record_add(VkCommandBuffer commands, float weight, float sign) {
  color_->transition(commands, Use::sampled);
  if (run_)
    for (Image* image : {&run_->mean, &run_->difference}) image->transition(commands, Use::sampled);
  const bool first = weights_ == 0;
  weights_ += weight;
  for (Image* image : {&sum_, &differences_}) image->transition(commands, Use::color_attachment, first);
  begin_colors(commands, {&sum_, &differences_},
               first ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD);
  bind(commands, layout_.get(), 0, set_);
  const std::array push{weight, sign};
  vkCmdPushConstants(commands, layout_.get(), kDrawingStages, 0, sizeof push, push.data());
  draw_screen(commands, pipeline_.get());
  vkCmdEndRendering(commands);
}

std::vector<float> PlaceSums::divided(Image& image) {
  std::vector<float> values = read_rgba(*device_, image);
  for (float& value : values) value /= weights_;
  return values;
}

std::vector<float> PlaceSums::mean() {
  return divided(sum_);
}

std::vector<float> PlaceSums::difference() {
  return divided(differences_);
}

}  // namespace brdf::render
