#include "render/gpu/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/files/error.h"
#include "render/gpu/gpu_layout.h"
#include "render/mesh/simplified.h"
#include "render/scene/camera_view.h"

namespace brdf::render {
namespace {

constexpr std::array kFrameBindings{Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
                                    Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
                                    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER}};  // the shadow map
// Cells across a simplified mesh: about 5 pixels each in a picture of half the window's size.
constexpr int kCoarseCells = 64;
constexpr std::size_t kMostCoarseTriangles = 8000;
constexpr std::array<Binding, 1> kMapBindings{
    Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, std::uint32_t(kNames<TextureSlot>.size())}};

GpuLight gpu_light(const Light& light) {
  const glm::vec3 irradiance = light.color * light.intensity;
  if (light.point) return {glm::vec4(light.vector, 1), glm::vec4(irradiance, 1)};
  return {glm::vec4(-glm::normalize(light.vector), 0), glm::vec4(irradiance, glm::length(light.vector))};
}

std::vector<glm::mat4> places_for_shadow(const PreparedScene& prepared) {
  glm::mat4 light(0);
  if (const std::optional<std::size_t> k = shadow_light(prepared.scene))
    light = {glm::vec4(prepared.scene.lights[*k].vector, 1), glm::vec4(float(*k)), glm::vec4(0),
             glm::vec4(0)};
  std::vector<glm::mat4> places{light};
  for (const Item& item : prepared.layers[0]) {
    places.emplace_back(item.linear);
    places.back()[3] = glm::vec4(item.origin, 1);
  }
  return places;
}

GpuFrame gpu_frame(const PreparedScene& prepared, const std::optional<ShadowView>& shadow) {
  const Scene& scene = prepared.scene;
  const View view = make_view(scene.camera);
  GpuFrame frame{};
  frame.view_projection = view_projection(scene.camera, prepared.bounds.w * 1e-3f);
  frame.camera = glm::vec4(view.position, 1);
  frame.right = glm::vec4(view.right, 0);
  frame.up = glm::vec4(view.up, 0);
  frame.forward = glm::vec4(view.forward, 0);
  frame.ambient = glm::vec4(scene.ambient, 0);
  frame.back_color = glm::vec4(scene.back_color, 0);
  frame.background = glm::vec4(scene.background, 0);
  frame.zenith = glm::vec4(scene.sky_zenith.value_or(scene.backdrop_top.value_or(scene.background)), 0);
  if (scene.environment) {
    const float turn = glm::radians(scene.environment->rotation);
    frame.environment = {std::cos(turn), std::sin(turn), scene.environment->intensity,
                         scene.environment->floor.value_or(kNoFloor)};
  }
  frame.counts = {int(scene.lights.size()),
                  scene.sky_zenith     ? kSky
                  : scene.backdrop_top ? kBackdrop
                                       : 0,
                  scene.camera.width, scene.camera.height};
  if (shadow) frame.shadow_projection = shadow->projection;
  const auto objects = float(prepared.meshes.size());
  frame.shadow = shadow ? glm::vec4(shadow->light, kShadowMapSize, objects, 0) : glm::vec4(-1, 0, objects, 0);
  for (std::size_t k = 0; k < scene.lights.size(); ++k) frame.lights[k] = gpu_light(scene.lights[k]);
  return frame;
}

// Sets the ranges with which the shape's parameters are stored as bytes.
void set_ranges(GpuItem& out, std::span<const ParameterInfo> shape) {
  out.shape_high = glm::vec4(1);
  for (int i = 0; i < int(shape.size()); ++i) {
    const ParameterInfo& p = shape[std::size_t(i)];
    // A logarithmic parameter that starts at 0 (an exponent) is stored from 1 upwards.
    const double low = p.log_scale ? std::log2(p.min > 0 ? p.min : 1.0) : p.min;
    out.shape_low[i] = float(low);
    out.shape_high[i] = float(p.log_scale ? std::log2(p.usual_max) : p.usual_max);
    if (p.log_scale) out.form.y |= 1 << i;
  }
}

// Takes at most kMostWeights weights and kMostShape shape parameters; pictures with other shading modes
// need no more.
GpuItem gpu_item(const Item& item, const TextureSet& textures, const ReflectanceNumbers& numbers) {
  GpuItem out{};
  out.model = glm::mat4(item.linear);
  out.model[3] = glm::vec4(item.origin, 1);
  out.normals = glm::mat4(item.normals);
  out.form = {-1, 0, -1, -1};
  const std::size_t weights = std::min(item.weight_rules.size(), kMostWeights);
  const std::size_t shape = std::min(item.shape.size(), kMostShape);
  float largest = 1;
  for (std::size_t k = 0; k < weights; ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      out.weights[k][int(c)] = item.weights[c][k];
      if (k < 2) largest = std::max(largest, item.weights[c][k]);
    }
    out.weight_rules[int(k)] = int(item.weight_rules[k]);
  }
  for (std::size_t k = 0; k < shape; ++k) {
    out.shape[int(k)] = item.shape[k];
    out.shape_rules[int(k)] = int(item.shape_rules[k]);
  }
  if (shape == kMostShape) out.form.y |= kFourthShape;
  out.weights[0].a = item.cos_turn;
  out.weights[1].a = item.sin_turn;
  out.weights[2].a = item.extent;
  out.weight_scale.x = largest;
  for (std::size_t slot = 0; slot < textures.size(); ++slot)
    if (textures[slot]) out.weight_rules.w |= 1 << slot;
  if (!item.form) return out;
  const ReflectanceInfo& info = item.form->info();
  set_ranges(out, info.shape.first(shape));
  const auto place = [&](Role role) {
    const int at = info.weight_index(role);
    return at < int(weights) ? at : -1;
  };
  out.form = {numbers.of(*item.form), out.form.y, place(Role::diffuse), place(Role::specular)};
  return out;
}

}  // namespace

GpuScene::GpuScene(Device& device, const PreparedScene& scene, bool coarse)
    : device_(&device), sources_(scene.meshes) {
  frame_layout_ = make_set_layout(device, kFrameBindings);
  maps_layout_ = make_set_layout(device, kMapBindings);
  frame_pool_ = make_descriptor_pool(device, kFrameBindings, 1);
  frame_set_ = allocate_set(device, frame_pool_.get(), frame_layout_.get());
  for (const auto& mesh : sources_) {
    if (meshes_.contains(mesh.get())) continue;
    const bool simpler = coarse && mesh->triangles() > kMostCoarseTriangles;
    meshes_.emplace(mesh.get(), upload_mesh(simpler ? simplified(*mesh, kCoarseCells) : *mesh));
  }
  upload_textures(scene);
  set_shadow_map(white_.view(), sampler_.get());
  update(scene);
}

void GpuScene::set_shadow_map(VkImageView view, VkSampler sampler) {
  write_image(*device_, frame_set_, 2, view, sampler);
}

GpuScene::MeshBuffers GpuScene::upload_mesh(const Mesh& mesh) {
  return {make_buffer(*device_, std::span(mesh.vertices), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT),
          make_buffer(*device_, std::span(mesh.indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT),
          std::uint32_t(mesh.indices.size())};
}

const GpuScene::MeshBuffers& GpuScene::flat_mesh(std::size_t object) {
  const Mesh* source = sources_[object].get();
  const auto found = flat_meshes_.find(source);
  if (found != flat_meshes_.end()) return found->second;
  return flat_meshes_.emplace(source, upload_mesh(flat_shaded(*source))).first->second;
}

void GpuScene::upload_textures(const PreparedScene& scene) {
  const auto make = [&](const Texture& texture, VkFormat format) {
    Image image(*device_, format, {std::uint32_t(texture.width), std::uint32_t(texture.height)},
                VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    upload(*device_, image, std::as_bytes(std::span(texture.texels)));
    return image;
  };
  white_ = make(constant_texture(glm::vec4(1)), VK_FORMAT_R8G8B8A8_UNORM);
  sampler_ = make_sampler(*device_, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_REPEAT);
  const auto objects = std::uint32_t(scene.textures.size());
  maps_pool_ = make_descriptor_pool(*device_, kMapBindings, objects);
  for (const TextureSet& set : scene.textures) {
    maps_sets_.push_back(allocate_set(*device_, maps_pool_.get(), maps_layout_.get()));
    textured_.push_back(false);
    for (std::uint32_t slot = 0; slot < set.size(); ++slot) {
      const Image* image = &white_;
      if (set[slot]) {
        // Albedo maps are in sRGB; the device decodes them.
        images_.push_back(make(*set[slot], TextureSlot(slot) == TextureSlot::albedo
                                               ? VK_FORMAT_R8G8B8A8_SRGB
                                               : VK_FORMAT_R8G8B8A8_UNORM));
        image = &images_.back();
        textured_.back() = true;
      }
      write_image(*device_, maps_sets_.back(), 0, image->view(), sampler_.get(), slot);
    }
  }
}

void GpuScene::update(const PreparedScene& scene) {
  if (std::vector<glm::mat4> places = places_for_shadow(scene); places != shadow_places_) {
    shadow_places_ = std::move(places);
    shadow_ = shadow_view(scene);
  }
  const GpuFrame frame = gpu_frame(scene, shadow_);
  std::vector<GpuItem> items;
  if (scene.layers.size() * scene.meshes.size() > kMostItems) {
    throw InputError("the renderer draws at most " + std::to_string(kMostItems) +
                     " objects; each term of a sum counts as one");
  }
  for (const auto& layer : scene.layers) {
    for (const Item& item : layer) {
      if (item.form) numbers_.add(*item.form);
      items.push_back(gpu_item(item, scene.textures[item.object], numbers_));
    }
  }
  if (!frame_) frame_ = Buffer(*device_, sizeof frame, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  if (!items_) items_ = Buffer(*device_, kMostItems * sizeof(GpuItem), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  std::memcpy(frame_.data(), &frame, sizeof frame);
  std::memcpy(items_.data(), items.data(), items.size() * sizeof(GpuItem));
  write_buffer(*device_, frame_set_, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, frame_.get());
  write_buffer(*device_, frame_set_, 1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, items_.get());
}

VkCullModeFlags GpuScene::cull_mode(const PreparedScene& scene, std::size_t object) const {
  const Item& item = scene.layers[0][object];
  const bool outside = glm::distance(scene.scene.camera.position, item.origin) > item.extent;
  const bool mirrored = glm::determinant(item.linear) < 0;
  return sources_[object]->closed && outside && !mirrored ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE;
}

void GpuScene::draw(VkCommandBuffer commands, VkPipelineLayout layout, const MeshBuffers& mesh,
                    const MeshPart& part, int item) {
  const VkBuffer vertices = mesh.vertices.get();
  const VkDeviceSize offset = 0;
  vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &offset);
  vkCmdBindIndexBuffer(commands, mesh.indices.get(), 0, VK_INDEX_TYPE_UINT32);
  vkCmdPushConstants(commands, layout, kDrawingStages, 0, sizeof item, &item);
  vkCmdDrawIndexed(commands, part.count, 1, part.first, 0, 0);
}

void GpuScene::draw(VkCommandBuffer commands, VkPipelineLayout layout, std::size_t object, int item,
                    bool flat) {
  const MeshBuffers& mesh = flat ? flat_mesh(object) : meshes_.at(sources_[object].get());
  draw(commands, layout, mesh, {object, 0, mesh.count}, item);
}

void GpuScene::draw(VkCommandBuffer commands, VkPipelineLayout layout, const MeshPart& part, int item) {
  draw(commands, layout, meshes_.at(sources_[part.object].get()), part, item);
}

std::vector<MeshPart> GpuScene::mesh_parts(std::uint32_t triangles) const {
  std::vector<MeshPart> parts;
  for (std::size_t object = 0; object < sources_.size(); ++object) {
    const std::uint32_t count = meshes_.at(sources_[object].get()).count;
    for (std::uint32_t first = 0; first < count; first += 3 * triangles)
      parts.push_back({object, first, std::min(count - first, 3 * triangles)});
  }
  return parts;
}

}  // namespace brdf::render
