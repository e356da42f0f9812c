#include <cmath>

#include "io/material/material_file.h"
#include "trade/questions/held_out_cases.h"
#include "trade/questions/materials.h"
#include "trade/recommend/recommend.h"

namespace brdf::trade {
namespace {

glm::vec3 turned(const glm::vec3& v, float degrees) {
  const float a = glm::radians(degrees);
  return {v.x * std::cos(a) + v.z * std::sin(a), v.y, v.z * std::cos(a) - v.x * std::sin(a)};
}

// Moves camera and lights about the target: close enough to remain the same scene, but with directions that
// no fit has used.
render::Scene moved(render::Scene scene, float camera_degrees, float light_degrees, float closer) {
  render::Camera& camera = scene.camera;
  camera.position = camera.target + turned(camera.position - camera.target, camera_degrees) * closer;
  for (render::Light& light : scene.lights)
    light.vector = light.point ? camera.target + turned(light.vector - camera.target, light_degrees)
                               : turned(light.vector, light_degrees);
  return scene;
}

}  // namespace

std::vector<HeldOut> compare_held_out(const std::filesystem::path& scenes,
                                      const std::filesystem::path& materials,
                                      const std::function<void(double, const std::string&)>& progress) {
  std::vector<HeldOut> rows;
  for (const HeldOutCase& c : kHeldOutCases) {
    progress(double(rows.size()) / double(std::size(kHeldOutCases)),
             std::string(c.scene) + ", " + c.material);
    const render::Scene scene = render::load_scene(scenes / (std::string(c.scene) + ".json"));
    const Material truth = io::read_material(materials / (std::string(c.material) + ".json"));
    const RgbFunction reference = rgb_function(truth);
    const Reflectance form = named_form(c.form);
    const RgbFunction by_scene =
        rgb_function(fit_to_picture(form, scene_samples(view_of(scene), reference, 6000), false));
    const RgbFunction by_hemisphere =
        rgb_function(fit_to_picture(form, hemisphere_samples(reference, 6000), false));
    HeldOut row{c.scene, c.material, c.form};
    const struct {
      float camera, light, closer;
    } positions[] = {{6, -8, 1.0f}, {-5, 7, 1.1f}, {4, 9, 0.95f}};
    for (const auto& p : positions) {
      const SceneView view = view_of(moved(scene, p.camera, p.light, p.closer));
      row.scene_weighted += image_error(view, by_scene, reference) / std::size(positions);
      row.hemisphere_wide += image_error(view, by_hemisphere, reference) / std::size(positions);
    }
    rows.push_back(std::move(row));
  }
  progress(1, "");
  return rows;
}

}  // namespace brdf::trade
