// Camera geometry shared by the renderer, the reference and the pixel probe.
#pragma once

#include "render/scene/scene.h"

namespace brdf::render {

// The rays of a camera.
struct View {
  glm::vec3 position;
  // The ray through ndc (x, y), y upwards, is forward + x right + y up.
  glm::vec3 right, up, forward;

  glm::vec3 ray(glm::vec2 ndc) const { return forward + right * ndc.x + up * ndc.y; }
};

// Returns the view of the camera, shifted by the camera's offset.
View make_view(const Camera& camera);
// Returns the transform to Vulkan's clip space with reversed depth: 1 at the near plane, 0 at infinity.
glm::mat4 view_projection(const Camera& camera, float near_plane);
// Returns the centre of a pixel in ndc, y upwards; rows count from the top.
glm::vec2 pixel_center(int x, int y, int width, int height);

}  // namespace brdf::render
