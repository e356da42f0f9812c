// Scenes of shapes that show materials.
#include <algorithm>
#include <cmath>

#include "render/mesh/mesh.h"
#include "render/scene/scene.h"

namespace brdf::render {
namespace {

// A part that never has the material shown: grey, with a lobe of this width.
struct Part {
  std::string_view mesh;
  double diffuse, f0, width;
};

// A shape that looks best if it is turned about y by `turn` degrees.
struct Shape {
  std::string_view name, body;
  float turn;
  std::vector<Part> others;
};

const std::vector<Shape>& dressed_shapes() {
  static const std::vector<Shape> shapes{
      {"shader_ball", "shader_ball:ball", 0, {{"shader_ball:stand", 0.12, 0.04, 0.35}}},
      {"sedan",
       "sedan:body",
       -38,
       {{"sedan:windows", 0.005, 0.05, 0.03},
        {"sedan:trim", 0.015, 0.04, 0.4},
        {"sedan:metal", 0, 0.9, 0.15},
        {"sedan:lamps", 0.02, 0.8, 0.05}}}};
  return shapes;
}

// Returns the catalogue's first canonical microfacet form with an f0, set to these values.
Material grey(const Part& part, const std::vector<std::string>& channels) {
  const auto form = find_form_if([](const ReflectanceInfo& table) {
    return table.canonical && table.facets != nullptr && table.weight_index(Role::f0) >= 0;
  });
  Material material = make_material(*form, channels);
  Term& term = material.terms[0];
  const ReflectanceInfo& table = info(term.form);
  const auto set = [&](Role role, double value) {
    const int weight = table.weight_index(role), shape = table.shape_index(role);
    for (std::vector<double>& weights : term.weights)
      if (weight >= 0) weights[std::size_t(weight)] = value;
    if (shape >= 0) term.shape[0][std::size_t(shape)] = value;
  };
  set(Role::diffuse, part.diffuse);
  set(Role::specular, 1);
  set(Role::f0, part.f0);
  set(Role::width, part.width);
  set(Role::width_across, part.width);
  return material;
}

// Returns the shape with its parts, in place of a unit sphere.
std::vector<Object> dressed(const Shape& shape, const Object& sphere) {
  const glm::vec4 bounds = bounding_sphere(make_mesh(std::string(shape.name), {}));
  Object object = sphere;
  object.mesh = shape.body;
  object.scale /= bounds.w;
  object.rotation.y = shape.turn;
  object.position -= linear_part(object) * glm::vec3(bounds);
  std::vector<Object> objects{object};
  object.label.clear();
  for (const Part& part : shape.others) {
    object.mesh = part.mesh;
    object.material = grey(part, sphere.material.channels);
    object.material_name = part.mesh;
    objects.push_back(object);
  }
  return objects;
}

}  // namespace

Scene shape_scene(const std::string& shape, const std::vector<std::pair<std::string, Material>>& materials) {
  constexpr float kTurn = -30, kAbove = 14;  // degrees
  Scene scene = material_scene(materials);
  const auto& shapes = dressed_shapes();
  const auto found = std::ranges::find_if(shapes, [&](const Shape& s) { return s.name == shape; });
  const Shape chosen = found == shapes.end() ? Shape{shape, shape, kTurn, {}} : *found;
  std::vector<Object> objects;
  for (const Object& sphere : scene.objects) {
    const std::vector<Object> parts = dressed(chosen, sphere);
    objects.insert(objects.end(), parts.begin(), parts.end());
  }
  scene.objects = std::move(objects);
  const float away = scene.camera.position.z;
  scene.camera.position.y = away * std::sin(glm::radians(kAbove));
  scene.camera.position.z = away * std::cos(glm::radians(kAbove));
  return scene;
}

}  // namespace brdf::render
