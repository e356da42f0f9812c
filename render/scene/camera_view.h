// Camera geometry shared by the renderer, the reference and the pixel probe.
#pragma once

#include "render/scene/scene.h"

namespace brdf::render {

struct View {
  glm::vec3 position;
  glm::vec3 right, up, forward;  // the ray through ndc (x, y), y upwards, is forward + x right + y up

  glm::vec3 ray(glm::vec2 ndc) const { return forward + right * ndc.x + up * ndc.y; }
};

View make_view(const Camera& camera);
// Clip space of Vulkan with reversed depth: near plane at 1, infinity at 0.
glm::mat4 view_projection(const Camera& camera, float near_plane);
glm::vec2 pixel_center(int x, int y, int width, int height);

}  // namespace brdf::render
