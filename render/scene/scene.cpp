#include "render/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "io/files/error.h"

namespace brdf::render {

io::ChannelColours require_colours(const std::vector<std::string>& channels, const std::string& what) {
  if (const auto colours = io::channel_colours(channels)) return *colours;
  throw InputError(
      what + ": has " + std::to_string(channels.size()) +
      " channels; a picture needs 1 or 3 channels, or three named r, g, b or by wavelength (465nm)");
}

Scene material_scene(const std::vector<std::pair<std::string, Material>>& materials) {
  Scene scene;
  const auto count = int(materials.size());
  const float span = 2.2f * float(count - 1);
  for (int k = 0; k < count; ++k) {
    Object object;
    object.material_name = materials[std::size_t(k)].first;
    object.material = materials[std::size_t(k)].second;
    if (count > 1) object.label = object.material_name;
    object.position.x = 2.2f * float(k) - span / 2;
    scene.objects.push_back(object);
  }
  scene.camera.height = 512;
  scene.camera.width = std::min(512 * count, 2048);
  // Moves the camera so that the whole row fits: its half width against the picture's.
  const float aspect = float(scene.camera.width) / float(scene.camera.height);
  const float half_view = std::tan(glm::radians(scene.camera.vertical_fov) / 2);
  scene.camera.position.z = std::max(4.0f, (span / 2 + 1.15f) / (half_view * aspect));
  // The light comes from the upper left front. With irradiance pi, a Lambertian surface that faces the
  // light appears with its reflectance.
  scene.lights.push_back({false, {1, -1, -1}, glm::vec3(1), float(kPi)});
  scene.ambient = glm::vec3(0.03f);
  // The background is dark at the top, behind the lit side of the objects, and light at the bottom, behind
  // their shadow side. No object of uniform brightness can therefore match the background all round.
  scene.background = glm::vec3(0.42f);
  scene.backdrop_top = glm::vec3(0.06f);
  return scene;
}

glm::mat3 linear_part(const Object& object) {
  glm::mat4 m(1);
  m = glm::rotate(m, glm::radians(object.rotation.z), {0, 0, 1});
  m = glm::rotate(m, glm::radians(object.rotation.y), {0, 1, 0});
  m = glm::rotate(m, glm::radians(object.rotation.x), {1, 0, 0});
  return glm::mat3(glm::scale(m, object.scale));
}

glm::mat3 to_picture(const Environment& environment) {
  return glm::mat3(glm::rotate(glm::mat4(1), glm::radians(-environment.rotation), glm::vec3(0, 1, 0)));
}

}  // namespace brdf::render
