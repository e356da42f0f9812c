#include "render/scene/shadow_view.h"

#include <algorithm>
#include <cmath>

namespace brdf::render {
namespace {

// Returns the box of the objects in the axes of `rows`; flat objects count only if there are no others.
PointBox box_along(const PreparedScene& prepared, const glm::mat3& rows) {
  PointBox solid, all;
  for (const Item& item : prepared.layers[0]) {
    PointBox own, turned;
    for (const Vertex& vertex : prepared.meshes[item.object]->vertices) {
      own.add(vertex.position);
      turned.add((item.origin + item.linear * vertex.position) * rows);
    }
    for (PointBox* box : {&all, own.is_flat() ? nullptr : &solid}) {
      if (!box) continue;
      box->add(turned.low);
      box->add(turned.high);
    }
  }
  return solid.size().x > 0 ? solid : all;
}

}  // namespace

std::optional<std::size_t> shadow_light(const Scene& scene) {
  for (std::size_t k = 0; scene.shadow && k < scene.lights.size(); ++k)
    if (!scene.lights[k].point) return k;
  return std::nullopt;
}

std::optional<ShadowView> shadow_view(const PreparedScene& prepared) {
  const std::optional<std::size_t> light = shadow_light(prepared.scene);
  if (!light) return std::nullopt;
  const glm::vec3 to_light = -glm::normalize(prepared.scene.lights[*light].vector);
  const glm::vec3 other = std::abs(to_light.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(other, to_light)), up = glm::cross(to_light, right);
  const PointBox box = box_along(prepared, {right, up, to_light});
  // A border of one per cent keeps the filter's taps inside.
  const glm::vec2 half = 0.505f * glm::max(glm::vec2(box.size()), glm::vec2(1e-6f));
  const glm::vec2 middle = (glm::vec2(box.low) + glm::vec2(box.high)) / 2.0f;
  const float reach = prepared.bounds.w, center = glm::dot(to_light, glm::vec3(prepared.bounds));
  ShadowView view;
  view.light = *light;
  view.projection = glm::transpose(
      glm::mat4(glm::vec4(right / half.x, -middle.x / half.x), glm::vec4(up / half.y, -middle.y / half.y),
                glm::vec4(to_light / (2 * reach), 0.5f - center / (2 * reach)), glm::vec4(0, 0, 0, 1)));
  return view;
}

}  // namespace brdf::render
