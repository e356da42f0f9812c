// The scene on the device: meshes, textures, camera, lights and items, with the descriptor sets that refer
// to them.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "render/gpu/fragment_code.h"
#include "render/scene/prepared.h"
#include "render/scene/shadow_view.h"
#include "render/vulkan/pipeline.h"
#include "render/vulkan/resource.h"

namespace brdf::render {

// Consecutive indices of an object's mesh.
struct MeshPart {
  std::size_t object = 0;
  std::uint32_t first = 0, count = 0;
};

class GpuScene {
 public:
  // `coarse`: large meshes are replaced by meshes with fewer triangles (mesh/simplified.h).
  GpuScene(Device& device, const PreparedScene& scene, bool coarse = false);
  // Updates camera, lights, colours and items; meshes and textures stay. The device must be idle.
  void update(const PreparedScene& scene);

  VkDescriptorSetLayout frame_layout() const { return frame_layout_.get(); }
  VkDescriptorSetLayout maps_layout() const { return maps_layout_.get(); }
  VkDescriptorSet frame_set() const { return frame_set_; }
  VkDescriptorSet maps_set(std::size_t object) const { return maps_sets_[object]; }
  // Sets the shadow map that the lighting reads (white until then).
  void set_shadow_map(VkImageView view, VkSampler sampler);
  // Returns all that the shadow map depends on if the meshes stay the same: the light, then the objects'
  // places.
  const std::vector<glm::mat4>& shadow_places() const { return shadow_places_; }
  // Returns the number by which shaders know a reflectance of the scene.
  int number_of(const Reflectance& reflectance) const { return numbers_.of(reflectance); }
  bool textured(std::size_t object) const { return textured_[object]; }
  // Returns back-face culling for closed meshes that are seen from outside, because their back faces are
  // hidden anyway.
  VkCullModeFlags cull_mode(const PreparedScene& scene, std::size_t object) const;
  // Binds the object's mesh (with one normal per face if `flat` is set), pushes the item's index, and
  // draws.
  void draw(VkCommandBuffer commands, VkPipelineLayout layout, std::size_t object, int item,
            bool flat = false);
  // The same for a part of the mesh.
  void draw(VkCommandBuffer commands, VkPipelineLayout layout, const MeshPart& part, int item);
  // Divides all meshes into parts of at most `triangles` triangles.
  std::vector<MeshPart> mesh_parts(std::uint32_t triangles) const;

 private:
  struct MeshBuffers {
    Buffer vertices, indices;
    std::uint32_t count = 0;
  };
  MeshBuffers upload_mesh(const Mesh& mesh);
  void draw(VkCommandBuffer commands, VkPipelineLayout layout, const MeshBuffers& mesh, const MeshPart& part,
            int item);
  const MeshBuffers& flat_mesh(std::size_t object);
  void upload_textures(const PreparedScene& scene);

  Device* device_;
  std::vector<std::shared_ptr<const Mesh>> sources_;
  std::map<const Mesh*, MeshBuffers> meshes_, flat_meshes_;
  std::vector<Image> images_;
  Image white_;
  Owned<VkSampler> sampler_;
  Buffer frame_, items_;
  Owned<VkDescriptorSetLayout> frame_layout_, maps_layout_;
  Owned<VkDescriptorPool> frame_pool_, maps_pool_;
  VkDescriptorSet frame_set_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> maps_sets_;
  std::vector<bool> textured_;
  std::vector<glm::mat4> shadow_places_;
  std::optional<ShadowView> shadow_;  // for these places
  ReflectanceNumbers numbers_;
};

// Returns the index in the shader's table of the item of an object in a layer.
inline int item_index(const PreparedScene& scene, std::size_t layer, std::size_t object) {
  return int(layer * scene.meshes.size() + object);
}

}  // namespace brdf::render
