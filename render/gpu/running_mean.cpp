#include "render/gpu/running_mean.h"

#include <algorithm>
#include <cmath>

#include "render/gpu/shader_code.h"

namespace brdf::render {
namespace {

constexpr std::array<Binding, 1> kBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
constexpr VkImageUsageFlags kSummed =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

}  // namespace

RunningMean::RunningMean(Device& device, Image& image)
    : device_(&device),
      image_(&image),
      sum_(device, kColorFormat, image.extent(), kSummed),
      squares_(device, kColorFormat, image.extent(), kSummed) {
  sampler_ = make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  set_layout_ = make_set_layout(device, kBindings);
  pool_ = make_descriptor_pool(device, kBindings, 3);
  image_set_ = allocate_set(device, pool_.get(), set_layout_.get());
  sum_set_ = allocate_set(device, pool_.get(), set_layout_.get());
  other_set_ = allocate_set(device, pool_.get(), set_layout_.get());
  write_image(device, image_set_, 0, image.view(), sampler_.get());
  write_image(device, sum_set_, 0, sum_.view(), sampler_.get());
  const std::array sets{set_layout_.get()};
  layout_ = make_pipeline_layout(device, sets, sizeof(float));
  accumulate_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                       .fragment = shader_code::accumulate,
                                       .colors = {kColorFormat, kColorFormat},
                                       .blend = Blend::add,
                                       .layout = layout_.get()});
  mean_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                 .fragment = shader_code::mean,
                                 .colors = {kColorFormat},
                                 .blend = Blend::add_color,
                                 .layout = layout_.get()});
}

void RunningMean::record_add(VkCommandBuffer commands) {
  image_->transition(commands, Use::sampled);
  const bool first = count_++ == 0;
  for (Image* image : {&sum_, &squares_}) image->transition(commands, Use::color_attachment, first);
  begin_colors(commands, {&sum_, &squares_},
               first ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD);
  bind(commands, layout_.get(), 0, image_set_);
  draw_screen(commands, accumulate_.get());
  vkCmdEndRendering(commands);
}

void RunningMean::record(VkCommandBuffer commands, VkDescriptorSet from, Image& target, Over over,
                         float factor) {
  const bool discard = over == Over::black;
  target.transition(commands, Use::color_attachment, discard);
  begin_colors(commands, {&target}, discard ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD);
  bind(commands, layout_.get(), 0, from);
  vkCmdPushConstants(commands, layout_.get(), kDrawingStages, 0, sizeof factor, &factor);
  draw_screen(commands, mean_.get());
  vkCmdEndRendering(commands);
}

void RunningMean::record_mean(VkCommandBuffer commands, Image& target, Over over, float share) {
  sum_.transition(commands, Use::sampled);
  record(commands, sum_set_, target, over, share / float(count_));
}

void RunningMean::record_copy(VkCommandBuffer commands, Image& target) {
  image_->transition(commands, Use::sampled);
  record(commands, image_set_, target, Over::black, 1);
}

void RunningMean::record_share(VkCommandBuffer commands, Image& other, Image& target, float share) {
  other.transition(commands, Use::sampled);
  write_image(*device_, other_set_, 0, other.view(), sampler_.get());
  record(commands, other_set_, target, Over::what_is_there, share);
}

std::vector<float> RunningMean::standard_error() {
  std::vector<float> sums = read_rgba(*device_, sum_);
  const std::vector<float> squares = read_rgba(*device_, squares_);
  const double n = count_;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const double mean = double(sums[k]) / n, scatter = double(squares[k]) / n - mean * mean;
    sums[k] = n > 1 ? float(std::sqrt(std::max(scatter, 0.0) / (n - 1))) : 0;
  }
  return sums;
}

}  // namespace brdf::render
