#include "render/gpu/passes.h"

#include <algorithm>
#include <cmath>

#include "render/gpu/shader_code.h"
#include "render/scene/camera_view.h"

namespace brdf::render {
namespace {

constexpr std::array<Binding, 1> kTargetBindings{
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, std::uint32_t(kTargetCount)}};
constexpr VkImageLayout kColorLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;

// Begins to draw on the whole extent.
void begin_rendering(VkCommandBuffer commands, VkExtent2D extent,
                     std::span<const VkRenderingAttachmentInfo> colors,
                     const VkRenderingAttachmentInfo* depth = nullptr) {
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = extent;
  info.layerCount = 1;
  info.colorAttachmentCount = std::uint32_t(colors.size());
  info.pColorAttachments = colors.data();
  info.pDepthAttachment = depth;
  vkCmdBeginRendering(commands, &info);
  set_viewport(commands, extent);
}

// Makes the image the depth attachment, cleared at the beginning and left out at the end.
VkRenderingAttachmentInfo cleared_depth(VkCommandBuffer commands, Image& depth) {
  depth.transition(commands, Use::depth_attachment, true);
  VkRenderingAttachmentInfo info =
      attachment(depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR, glm::vec4(0));
  info.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  return info;
}

}  // namespace

int only_item(const PreparedScene& scene, std::size_t layer, const Reflectance& form) {
  int found = -1;
  for (const Item& item : scene.layers[layer]) {
    if (item.form != form) continue;
    if (found >= 0) return -1;
    found = item_index(scene, layer, item.object);
  }
  return found;
}

void bind(VkCommandBuffer commands, VkPipelineLayout layout, std::uint32_t first, VkDescriptorSet set) {
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, first, 1, &set, 0, nullptr);
}

void draw_screen(VkCommandBuffer commands, VkPipeline pipeline) {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdDraw(commands, 3, 1, 0, 0);
}

std::vector<Reflectance> forms_in(const std::vector<Item>& layer) {
  std::vector<Reflectance> forms;
  for (const Item& item : layer)
    if (item.form && std::ranges::find(forms, *item.form) == forms.end()) forms.push_back(*item.form);
  return forms;
}

VkFormat gbuffer_format(int bits) {
  return bits == 8    ? VK_FORMAT_R8G8B8A8_UNORM
         : bits == 32 ? VK_FORMAT_R32G32B32A32_SFLOAT
                      : VK_FORMAT_R16G16B16A16_SFLOAT;
}

GBuffer::GBuffer(Device& device, VkExtent2D extent, int channel_bits) : bits(channel_bits) {
  for (Image& target : targets) {
    target = Image(
        device, gbuffer_format(bits), extent,
        VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  }
  depth = Image(device, VK_FORMAT_D32_SFLOAT, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
}

void set_viewport(VkCommandBuffer commands, VkExtent2D extent) {
  // The negative height makes y point upwards, as in the rest of the project.
  const VkViewport viewport{0, float(extent.height), float(extent.width), -float(extent.height), 0, 1};
  const VkRect2D scissor{{0, 0}, extent};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &scissor);
}

VkRenderingAttachmentInfo attachment(const Image& image, VkImageLayout layout, VkAttachmentLoadOp load,
                                     const glm::vec4& clear) {
  VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  info.imageView = image.view();
  info.imageLayout = layout;
  info.loadOp = load;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  for (int c = 0; c < 4; ++c) info.clearValue.color.float32[c] = clear[c];
  return info;
}

void begin_colors(VkCommandBuffer commands, std::initializer_list<Image*> images, VkAttachmentLoadOp load) {
  std::vector<VkRenderingAttachmentInfo> colors;
  for (const Image* image : images) colors.push_back(attachment(*image, kColorLayout, load, glm::vec4(0)));
  begin_rendering(commands, (*images.begin())->extent(), colors);
}

VkRect2D common(const VkRect2D& a, const VkRect2D& b) {
  const std::int32_t left = std::max(a.offset.x, b.offset.x), top = std::max(a.offset.y, b.offset.y);
  const std::int32_t right = std::min(a.offset.x + std::int32_t(a.extent.width),
                                      b.offset.x + std::int32_t(b.extent.width)),
                     bottom = std::min(a.offset.y + std::int32_t(a.extent.height),
                                       b.offset.y + std::int32_t(b.extent.height));
  return {{left, top}, {std::uint32_t(std::max(right - left, 0)), std::uint32_t(std::max(bottom - top, 0))}};
}

VkRect2D covered_by_form(const PreparedScene& scene, std::size_t layer, const Reflectance& form,
                         VkExtent2D extent) {
  const glm::mat4 project = view_projection(scene.scene.camera, 1e-3f);
  glm::vec2 low(1), high(-1);
  for (const Item& item : scene.layers[layer]) {
    if (item.form != form) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 at(corner & 1 ? item.high.x : item.low.x, corner & 2 ? item.high.y : item.low.y,
                         corner & 4 ? item.high.z : item.low.z);
      const glm::vec4 clip = project * glm::vec4(item.origin + item.linear * at, 1);
      if (clip.w < 1e-3f * item.extent) return {{0, 0}, extent};
      low = glm::min(low, glm::vec2(clip) / clip.w);
      high = glm::max(high, glm::vec2(clip) / clip.w);
    }
  }
  low = glm::clamp(low, -1.0f, 1.0f);
  high = glm::clamp(high, -1.0f, 1.0f);
  // One pixel more at each side, because the positions of the vertices are rounded.
  const float w = float(extent.width), h = float(extent.height);
  const auto left = std::int32_t((low.x + 1) / 2 * w) - 1, top = std::int32_t((1 - high.y) / 2 * h) - 1;
  const auto right = std::int32_t(std::ceil((high.x + 1) / 2 * w)) + 1,
             bottom = std::int32_t(std::ceil((1 - low.y) / 2 * h)) + 1;
  if (right <= left || bottom <= top) return {{0, 0}, {0, 0}};
  return common({{0, 0}, extent}, {{left, top}, {std::uint32_t(right - left), std::uint32_t(bottom - top)}});
}

SkyPass::SkyPass(Device& device, const GpuScene& gpu) {
  const std::array sets{gpu.frame_layout()};
  layout_ = make_pipeline_layout(device, sets, 0);
  pipeline_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                     .fragment = shader_code::sky,
                                     .colors = {kColorFormat},
                                     .layout = layout_.get()});
}

void SkyPass::record(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu,
                     Image& color) {
  color.transition(commands, Use::color_attachment, true);
  const bool sky = scene.scene.sky_zenith || scene.scene.backdrop_top;
  const auto target =
      attachment(color, kColorLayout, sky ? VK_ATTACHMENT_LOAD_OP_DONT_CARE : VK_ATTACHMENT_LOAD_OP_CLEAR,
                 glm::vec4(scene.scene.background, 0));
  begin_rendering(commands, color.extent(), {&target, 1});
  if (sky) {
    bind(commands, layout_.get(), 0, gpu.frame_set());
    draw_screen(commands, pipeline_.get());
  }
  vkCmdEndRendering(commands);
}

DeferredPass::DeferredPass(Device& device, const GpuScene& gpu, GBuffer& gbuffer)
    : device_(&device),
      gbuffer_(&gbuffer),
      lighting_code_(shader_code::lighting, shader_code::lighting_text) {
  sampler_ = make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
  targets_layout_ = make_set_layout(device, kTargetBindings);
  targets_pool_ = make_descriptor_pool(device, kTargetBindings, 1);
  targets_set_ = allocate_set(device, targets_pool_.get(), targets_layout_.get());
  for (std::uint32_t k = 0; k < kTargetCount; ++k)
    write_image(device, targets_set_, 0, gbuffer.targets[k].view(), sampler_.get(), k);
  const std::array geometry_sets{gpu.frame_layout(), gpu.maps_layout()};
  const std::array lighting_sets{gpu.frame_layout(), targets_layout_.get()};
  geometry_layout_ = make_pipeline_layout(device, geometry_sets, sizeof(int));
  lighting_layout_ = make_pipeline_layout(device, lighting_sets, sizeof(int));
}

VkPipeline DeferredPass::geometry_pipeline(bool textured) {
  Owned<VkPipeline>& pipeline = geometry_pipelines_[textured];
  if (!pipeline) {
    pipeline = make_pipeline(*device_, {.vertex = shader_code::mesh_vertex,
                                        .fragment = shader_code::gbuffer,
                                        .constants = {std::uint32_t(gbuffer_->bits), textured},
                                        .input = VertexInput::mesh,
                                        .colors = std::vector(kTargetCount, gbuffer_format(gbuffer_->bits)),
                                        .depth = true,
                                        .culls = true,
                                        .layout = geometry_layout_.get()});
  }
  return pipeline.get();
}

VkPipeline DeferredPass::lighting_pipeline(const Reflectance& form, int number, bool add, bool single,
                                           bool dark) {
  Owned<VkPipeline>& pipeline = lighting_pipelines_[{number, add, single, dark}];
  if (!pipeline) {
    pipeline = make_pipeline(
        *device_, {.vertex = shader_code::screen_vertex,
                   .fragment = lighting_code_.of(form, number),
                   .constants = {std::uint32_t(number), std::uint32_t(gbuffer_->bits), single, dark},
                   .colors = {kColorFormat},
                   .blend = add ? Blend::add : Blend::replace,
                   .layout = lighting_layout_.get()});
  }
  return pipeline.get();
}

void begin_targets(VkCommandBuffer commands, GBuffer& gbuffer, bool fresh) {
  const VkAttachmentLoadOp load = fresh ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  std::array<VkRenderingAttachmentInfo, kTargetCount> colors{};
  for (std::size_t k = 0; k < kTargetCount; ++k) {
    gbuffer.targets[k].transition(commands, Use::color_attachment, fresh);
    colors[k] = attachment(gbuffer.targets[k], kColorLayout, load, glm::vec4(0));
  }
  gbuffer.depth.transition(commands, Use::depth_attachment, fresh);
  const VkRenderingAttachmentInfo depth =
      attachment(gbuffer.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, load, glm::vec4(0));
  begin_rendering(commands, gbuffer.depth.extent(), colors, &depth);
}

void DeferredPass::record_geometry(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu,
                                   std::size_t layer, std::span<const MeshPart> parts, bool fresh) {
  begin_targets(commands, *gbuffer_, fresh);
  bind(commands, geometry_layout_.get(), 0, gpu.frame_set());
  for (const MeshPart& part : parts) {
    const std::size_t object = part.object;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, geometry_pipeline(gpu.textured(object)));
    bind(commands, geometry_layout_.get(), 1, gpu.maps_set(object));
    vkCmdSetCullMode(commands, gpu.cull_mode(scene, object));
    gpu.draw(commands, geometry_layout_.get(), part, item_index(scene, layer, object));
  }
  vkCmdEndRendering(commands);
}

void DeferredPass::prepare_to_read(VkCommandBuffer commands) const {
  for (Image& target : gbuffer_->targets) target.transition(commands, Use::sampled);
}

void DeferredPass::record_lighting(VkCommandBuffer commands, const PreparedScene& scene, const GpuScene& gpu,
                                   std::size_t layer, const VkRect2D& tile, Image& color) {
  prepare_to_read(commands);
  color.transition(commands, Use::color_attachment);
  begin_colors(commands, {&color}, VK_ATTACHMENT_LOAD_OP_LOAD);
  bind(commands, lighting_layout_.get(), 0, gpu.frame_set());
  bind(commands, lighting_layout_.get(), 1, targets_set_);
  const bool dark = scene.scene.lights.empty() && scene.scene.ambient == glm::vec3(0);
  for (const Reflectance& form : forms_in(scene.layers[layer])) {
    const VkRect2D scissor = common(covered_by_form(scene, layer, form, color.extent()), tile);
    if (scissor.extent.width == 0 || scissor.extent.height == 0) continue;
    vkCmdSetScissor(commands, 0, 1, &scissor);
    const int single = only_item(scene, layer, form);
    vkCmdPushConstants(commands, lighting_layout_.get(), kDrawingStages, 0, sizeof single, &single);
    draw_screen(commands, lighting_pipeline(form, gpu.number_of(form), layer > 0, single >= 0, dark));
  }
  vkCmdEndRendering(commands);
}

void begin_forward(VkCommandBuffer commands, Image& color, Image& depth, VkAttachmentLoadOp load) {
  color.transition(commands, Use::color_attachment, load == VK_ATTACHMENT_LOAD_OP_CLEAR);
  const auto target = attachment(color, kColorLayout, load, glm::vec4(0));
  const VkRenderingAttachmentInfo depth_target = cleared_depth(commands, depth);
  begin_rendering(commands, color.extent(), {&target, 1}, &depth_target);
}

ForwardPass::ForwardPass(Device& device, const GpuScene& gpu)
    : device_(&device), code_(shader_code::forward, shader_code::forward_text) {
  const std::array sets{gpu.frame_layout(), gpu.maps_layout()};
  layout_ = make_pipeline_layout(device, sets, sizeof(int));
}

VkPipeline ForwardPass::pipeline(const Reflectance& form, int number, bool textured) {
  Owned<VkPipeline>& found = pipelines_[{number, textured}];
  if (!found) {
    found = make_pipeline(*device_, {.vertex = shader_code::mesh_vertex,
                                     .fragment = code_.of(form, number),
                                     .constants = {std::uint32_t(number), textured},
                                     .input = VertexInput::mesh,
                                     .colors = {kColorFormat},
                                     .depth = true,
                                     .culls = true,
                                     .layout = layout_.get()});
  }
  return found.get();
}

void ForwardPass::record(VkCommandBuffer commands, const PreparedScene& scene, GpuScene& gpu, Image& color,
                         Image& depth) {
  begin_forward(commands, color, depth);
  bind(commands, layout_.get(), 0, gpu.frame_set());
  for (std::size_t object = 0; object < scene.meshes.size(); ++object) {
    const Item& item = scene.layers[0][object];
    if (!item.form) continue;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                      pipeline(*item.form, gpu.number_of(*item.form), gpu.textured(object)));
    bind(commands, layout_.get(), 1, gpu.maps_set(object));
    vkCmdSetCullMode(commands, gpu.cull_mode(scene, object));
    gpu.draw(commands, layout_.get(), object, item_index(scene, 0, object));
  }
  vkCmdEndRendering(commands);
}

}  // namespace brdf::render
