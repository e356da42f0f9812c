// The surface under a ray, computed as shaders/surface.glsl computes the surface under a fragment.
#pragma once

#include "render/scene/prepared.h"

namespace brdf::render {

struct SurfaceHit {
  bool front = true;
  std::array<std::vector<float>, 3> weights;  // of red, green, blue
  std::vector<float> shape;
  glm::vec3 diffuse{0};  // the weight of that role, 0 if the form has no such weight
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1}, tangent{1, 0, 0}, bitangent{0, 1, 0};
};

// Returns the attributes of the triangle at the intersection of the camera's ray with the triangle's plane.
// The item must have a form. Computed in double precision: the barycentric weights of the ray tracer lose
// digits in proportion to the distance over the triangle's size, and the normal would lose them too.
SurfaceHit surface_at(const PreparedScene& scene, const Item& item, std::uint32_t triangle,
                      const glm::vec3& ray);

// Returns a world-space vector in the frame of the item: that of the surface, turned by tangent_phi.
inline glm::vec3 to_local(const glm::vec3& w, const SurfaceHit& s) {
  return {glm::dot(w, s.tangent), glm::dot(w, s.bitangent), glm::dot(w, s.normal)};
}

// Returns a direction of the item's frame in the frame of the surface, in which the tangent of the material
// has the azimuth tangent_phi.
inline glm::vec3 in_surface(const glm::vec3& w, const Item& item) {
  return {item.cos_turn * w.x - item.sin_turn * w.y, item.sin_turn * w.x + item.cos_turn * w.y, w.z};
}

// Returns f_r cos_i of the item's form with the parameters of the surface, in float.
glm::vec3 eval_cos_at(const Item& item, const SurfaceHit& s, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace brdf::render
