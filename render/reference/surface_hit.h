// The surface under a ray, as shaders/surface.glsl computes it under a fragment.
#pragma once

#include "render/scene/prepared.h"

namespace brdf::render {

struct SurfaceHit {
  bool front = true;
  std::array<std::vector<float>, 3> weights;  // of red, green, blue
  std::vector<float> shape;
  glm::vec3 diffuse{0};  // the weight of that role, 0 where there is none
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1}, tangent{1, 0, 0}, bitangent{0, 1, 0};
};

// Attributes of the triangle where the ray from the camera meets its plane; the item has a form. In double: a
// tracer's own barycentric weights have lost digits by the distance over the triangle's size, and with them
// the normal.
SurfaceHit surface_at(const PreparedScene& scene, const Item& item, std::uint32_t triangle,
                      const glm::vec3& ray);

inline glm::vec3 to_local(const glm::vec3& w, const SurfaceHit& s) {
  return {glm::dot(w, s.tangent), glm::dot(w, s.bitangent), glm::dot(w, s.normal)};
}

// f_r cos_i of the item's form with the surface's parameters, in float.
glm::vec3 eval_cos_at(const Item& item, const SurfaceHit& s, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace brdf::render
