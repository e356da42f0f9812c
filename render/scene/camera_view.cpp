#include "render/scene/camera_view.h"

#include <cmath>

namespace brdf::render {

namespace {

View view_through_centres(const Camera& camera) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
  const float half = std::tan(glm::radians(camera.vertical_fov) / 2);
  const float aspect = float(camera.width) / float(camera.height);
  return {camera.position, right * (half * aspect), glm::cross(right, forward) * half, forward};
}

// Returns the shift in ndc.
glm::vec2 shift_of(const Camera& camera) {
  return {2 * camera.offset.x / float(camera.width), -2 * camera.offset.y / float(camera.height)};
}

}  // namespace

View make_view(const Camera& camera) {
  View view = view_through_centres(camera);
  view.forward = view.ray(shift_of(camera));
  return view;
}

glm::mat4 view_projection(const Camera& camera, float near_plane) {
  const View view = view_through_centres(camera);
  const glm::vec2 shift = shift_of(camera);
  // Rows of the clip transform: x/w is the ndc of View::ray, z/w = near/depth.
  const glm::vec3 z = view.forward;
  const glm::vec3 x = view.right / glm::dot(view.right, view.right) - shift.x * z,
                  y = view.up / glm::dot(view.up, view.up) - shift.y * z;
  const glm::vec3& p = camera.position;
  return glm::transpose(glm::mat4(glm::vec4(x, -glm::dot(x, p)), glm::vec4(y, -glm::dot(y, p)),
                                  glm::vec4(0, 0, 0, near_plane), glm::vec4(z, -glm::dot(z, p))));
}

glm::vec2 pixel_center(int x, int y, int width, int height) {
  return {(float(x) + 0.5f) / float(width) * 2 - 1, 1 - (float(y) + 0.5f) / float(height) * 2};
}

}  // namespace brdf::render
