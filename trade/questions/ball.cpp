#include "trade/questions/ball.h"

#include "trade/questions/materials.h"
#include "trade/questions/names.h"

namespace brdf::trade {

render::Scene material_ball(int size) {
  render::Scene scene;
  scene.camera.width = scene.camera.height = size;
  scene.lights.push_back({});
  scene.objects.push_back({.mesh = "sphere", .material = make_material(named_form(names::kDiffuseForm))});
  return scene;
}

PicturePoints picture_points(const std::vector<render::LitPoint>& lit, int width) {
  PicturePoints points;
  for (const render::LitPoint& p : lit) {
    append(points.columns,
           fields_of(DirectionRow<double>{{p.wi.x, p.wi.y, p.wi.z}, {p.wo.x, p.wo.y, p.wo.z}}));
    points.weight.push_back(double(p.irradiance.x + p.irradiance.y + p.irradiance.z) / 3);
    points.pixel.push_back(std::size_t(p.y) * std::size_t(width) + std::size_t(p.x));
  }
  return points;
}

}  // namespace brdf::trade
