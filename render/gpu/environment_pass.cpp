#include "render/gpu/environment_pass.h"

#include "render/gpu/shader_code.h"
#include "render/light/blurred_light.h"
#include "render/light/points.h"

namespace brdf::render {
namespace {

constexpr std::array<Binding, 4> kLightBindings{
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}, Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};
constexpr VkImageUsageFlags kUploaded = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
constexpr VkImageUsageFlags kDrawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

template <class T>
Image uploaded(Device& device, VkFormat format, VkExtent2D extent, std::span<const T> texels) {
  Image image(device, format, extent, kUploaded);
  upload(device, image, std::as_bytes(texels));
  return image;
}

}  // namespace

LightImages::LightImages(Device& device, const LightMap& map) {
  const VkExtent2D size{std::uint32_t(map.width()), std::uint32_t(map.height())};
  texels_ = uploaded(device, VK_FORMAT_R32G32B32A32_SFLOAT, size, map.texels());
  columns_ = uploaded(device, VK_FORMAT_R32_SFLOAT, size, map.columns());
  rows_ = uploaded(device, VK_FORMAT_R32_SFLOAT, {1, size.height}, map.rows());
  blurred_ = uploaded(device, VK_FORMAT_R32G32B32A32_SFLOAT, {kBlurredPictureWidth, kBlurredPictureHeight},
                      std::span<const glm::vec4>(blurred_light(map)));
  sampler_ = make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  linear_ = make_sampler(device, VK_FILTER_LINEAR, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  layout_ = make_set_layout(device, kLightBindings);
  pool_ = make_descriptor_pool(device, kLightBindings, 1);
  set_ = allocate_set(device, pool_.get(), layout_.get());
  std::uint32_t binding = 0;
  for (const Image* image : {&texels_, &columns_, &rows_})
    write_image(device, set_, binding++, image->view(), sampler_.get());
  write_image(device, set_, binding, blurred_.view(), linear_.get());
}

std::uint64_t light_bytes(const LightMap& map) {
  constexpr std::uint64_t kBlurred = std::uint64_t(kBlurredPictureWidth) * kBlurredPictureHeight;
  return map.texels().size_bytes() + map.columns().size_bytes() + map.rows().size_bytes() +
         kBlurred * sizeof(glm::vec4) + kLightPointsBytes;
}
std::uint64_t sums_bytes(std::uint64_t pixels) {
  constexpr std::uint64_t kImages = 4;  // the two of a run, two sums
  return kImages * pixels * std::uint64_t(texel_size(kColorFormat));
}

EnvironmentPass::EnvironmentPass(Device& device, const GpuScene& gpu, const LightImages& light,
                                 const DeferredPass& deferred, VkExtent2D extent, int gbuffer_bits)
    : device_(&device),
      light_(&light),
      deferred_(&deferred),
      bits_(gbuffer_bits),
      run_{{device, kColorFormat, extent, kDrawn}, {device, kColorFormat, extent, kDrawn}},
      mean_(device, run_.mean),
      points_(device),
      code_(shader_code::environment, shader_code::environment_text) {
  const std::array sets{gpu.frame_layout(), deferred.targets_layout(), light.layout(), points_.layout()};
  layout_ = make_pipeline_layout(device, sets, sizeof(RunPush));
  points_.make_pipeline_of(layout_.get());
  backdrop_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                     .fragment = shader_code::backdrop,
                                     .colors = {kColorFormat},
                                     .layout = layout_.get()});
}

VkPipeline EnvironmentPass::pipeline(const Reflectance& form, int number, Blend blend, bool single) {
  Owned<VkPipeline>& found = pipelines_[{number, smooth_, blend, single}];
  if (!found)
    found =
        make_pipeline(*device_, {.vertex = shader_code::screen_vertex,
                                 .fragment = code_.of(form, number),
                                 .constants = {std::uint32_t(number), std::uint32_t(bits_), smooth_, single},
                                 .colors = std::vector(smooth_ ? 1 : 2, kColorFormat),
                                 .blend = blend,
                                 .layout = layout_.get()});
  return found.get();
}

void EnvironmentPass::record_backdrop(VkCommandBuffer commands, const GpuScene& gpu, Image& color) {
  color.transition(commands, Use::color_attachment);
  begin_colors(commands, {&color}, VK_ATTACHMENT_LOAD_OP_DONT_CARE);
  bind(commands, layout_.get(), 0, gpu.frame_set());
  bind(commands, layout_.get(), 2, light_->set());
  draw_screen(commands, backdrop_.get());
  vkCmdEndRendering(commands);
}

void EnvironmentPass::begin_run(VkCommandBuffer commands) {
  for (Image* image : {&run_.mean, &run_.difference})
    image->transition(commands, Use::color_attachment, true);
  begin_colors(commands, {&run_.mean, &run_.difference}, VK_ATTACHMENT_LOAD_OP_CLEAR);
  vkCmdEndRendering(commands);
}

RunPush EnvironmentPass::push(std::uint32_t seed) const {
  RunPush push{-1, seed, smooth_ ? directions_ : count_, {}, {}};
  for (std::size_t d = 0; d < kPointDimensions; ++d) {
    push.first[d] = float(additive_recurrence(0, kPointSteps[d], std::uint64_t(first_ + samples())));
    push.step[d] = float(additive_recurrence(0, kPointSteps[d], std::uint64_t(stride_)));
  }
  return push;
}

void EnvironmentPass::record_points(VkCommandBuffer commands, const GpuScene& gpu, std::uint32_t seed) {
  bind(commands, layout_.get(), 0, gpu.frame_set());
  bind(commands, layout_.get(), 2, light_->set());
  points_.record(commands, layout_.get(), push(seed));
}

void EnvironmentPass::record(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu,
                             std::size_t layer, const VkRect2D& tile, std::uint32_t seed, Image& color) {
  deferred_->prepare_to_read(commands);
  points_.prepare_to_read(commands);
  for (Image* image : {&color, &run_.mean, &run_.difference})
    if ((image == &color) == smooth_) image->transition(commands, Use::color_attachment);
  if (smooth_)
    begin_colors(commands, {&color}, VK_ATTACHMENT_LOAD_OP_LOAD);
  else
    begin_colors(commands, {&run_.mean, &run_.difference}, VK_ATTACHMENT_LOAD_OP_LOAD);
  bind(commands, layout_.get(), 0, gpu.frame_set());
  bind(commands, layout_.get(), 1, deferred_->targets_set());
  bind(commands, layout_.get(), 2, light_->set());
  bind(commands, layout_.get(), 3, points_.set());
  RunPush push = this->push(seed);
  for (const Reflectance& form : forms_in(scene.layers[layer])) {
    const VkRect2D scissor = common(covered_by_form(scene, layer, form, color.extent()), tile);
    if (scissor.extent.width == 0 || scissor.extent.height == 0) continue;
    vkCmdSetScissor(commands, 0, 1, &scissor);
    push.item = smooth_ ? only_item(scene, layer, form) : -1;
    vkCmdPushConstants(commands, layout_.get(), kDrawingStages, 0, sizeof push, &push);
    const Blend blend = smooth_ && layer == 0 ? Blend::replace : Blend::add;
    draw_screen(commands, pipeline(form, gpu.number_of(form), blend, push.item >= 0));
  }
  vkCmdEndRendering(commands);
}

void EnvironmentPass::end_run(VkCommandBuffer commands, Image& color) {
  mean_.record_add(commands);
  mean_.record_mean(commands, color, RunningMean::Over::what_is_there);
}

}  // namespace brdf::render
