// The surface under a ray, as shaders/surface.glsl computes it under a fragment.
#pragma once

#include "render/scene/prepared.h"

namespace brdf::render {

struct Surface {
  bool front = true;
  std::array<glm::vec3, 3> weights{};
  std::array<float, 4> shape{};
  glm::vec3 position{0};
  glm::vec3 normal{0, 0, 1}, tangent{1, 0, 0}, bitangent{0, 1, 0};
};

// Attributes of the triangle where the ray from the camera meets its plane. In double: a tracer's own
// barycentric weights have lost digits by the distance over the triangle's size, and with them the normal.
Surface surface_at(const PreparedScene& scene, const Item& item, std::uint32_t triangle,
                   const glm::vec3& ray);

inline glm::vec3 to_local(const glm::vec3& w, const Surface& s) {
  return {glm::dot(w, s.tangent), glm::dot(w, s.bitangent), glm::dot(w, s.normal)};
}

// f_r cos_i of a form (by its index in Reflectance) with the surface's parameters, in float.
glm::vec3 eval_cos_at(int form, const Surface& s, const glm::vec3& wi, const glm::vec3& wo);

}  // namespace brdf::render
