// A scene prepared for drawing: meshes and textures are loaded, materials are flattened into items. Both
// the renderer and the Embree reference start from it.
#pragma once

#include <memory>

#include "render/light/light_map.h"
#include "render/mesh/mesh.h"
#include "render/scene/scene.h"
#include "render/scene/texture.h"
#include "render/scene/texture_rule.h"

namespace brdf::render {

using TextureSet = std::array<std::shared_ptr<const Texture>, 4>;  // indexed by TextureSlot

// One object with one term of its material. A sum of forms becomes one item per term, drawn in layers that
// are added; shapes that differ between channels become one item per channel.
struct Item {
  std::size_t object = 0;  // index into scene.objects, meshes and textures
  glm::mat3 linear{1}, normals{1};
  glm::vec3 origin{0};
  float extent = 1;            // no vertex is farther from the origin
  glm::vec3 low{-1}, high{1};  // the box of the mesh, before `linear` and `origin`
  // std::nullopt: the item only hides objects behind it (an object with fewer terms than there are layers).
  std::optional<Reflectance> form;
  float cos_turn = 1, sin_turn = 0;           // of tangent_phi
  std::array<std::vector<float>, 3> weights;  // of red, green, blue; in the order of the form's table
  std::vector<float> shape;                   // in the order of the form's table
  // Indices of the material's channels for red, green, blue.
  std::array<std::size_t, 3> channels{};
  // The rules by which the object's maps drive the parameters.
  std::vector<Rule> weight_rules, shape_rules;
};

// Kept because meshes have many vertices, and items are updated in every frame.
struct MeshBounds {
  glm::vec3 low, high;  // the box
  glm::vec4 sphere;     // centre and radius
};

struct PreparedScene {
  Scene scene;
  std::vector<std::shared_ptr<const Mesh>> meshes;  // per object
  std::vector<MeshBounds> mesh_bounds;              // per object
  std::vector<TextureSet> textures;                 // per object
  std::vector<std::vector<Item>> layers;            // every layer has an item per object
  std::shared_ptr<const LightMap> environment;      // null: no environment
  glm::vec4 bounds{0, 0, 0, 1};                     // sphere round all objects
};

// Prepares a scene. Throws InputError on a missing texture, an invalid model, a material whose channels are
// not colours, or if the objects together have more than this many triangles or texels (512 MiB).
inline constexpr std::size_t kMostTriangles = 20'000'000, kMostTexelsOfAll = 1 << 27;
PreparedScene prepare(Scene scene);
// Call after a change of only materials or transforms (the viewer's sliders); meshes and textures are kept.
void update_items(PreparedScene& prepared);

}  // namespace brdf::render
