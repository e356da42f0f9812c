#include "render/compare/measured.h"

#include "io/error.h"
#include "measured/tabulated.h"
#include "render/scene/prepared.h"

namespace brdf::render {
namespace {

Vec3<double> vec(const glm::vec3& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

}  // namespace

Measured interpolate(const io::SampleTable& table, const Material* fitted) {
  const std::array<std::size_t, 3> colours = require_colours(table.channels, table.source).of;
  const auto samples =
      std::make_shared<const measured::Tabulated>(std::make_shared<const measured::MeasuredReflectance>(
          table, fitted, measured::MeasuredReflectance::Beside::likeliest));
  return [samples, colours](const glm::vec3& wi, const glm::vec3& wo) {
    if (!(wi.z > 0 && wo.z > 0)) return MeasuredValue(glm::vec3(0));
    const measured::Seen seen = samples->at(vec(wi), vec(wo));
    glm::vec3 f;
    for (int c = 0; c < 3; ++c) f[c] = float(seen.f[colours[std::size_t(c)]]);
    return MeasuredValue(f * wi.z, seen.measured);
  };
}

MeasuredSpheres measured_spheres(const Material& fitted, const io::SampleTable& table, int size) {
  require_colours(fitted.channels, "the material");
  const Measured samples = interpolate(table, &fitted);
  Scene scene = material_scene({{"", fitted}});
  scene.ambient = glm::vec3(0);
  scene.camera.width = scene.camera.height = size;
  const ToneMap tone_map = scene.tone_map;
  const PreparedScene prepared = prepare(std::move(scene));
  ReferenceOptions options;
  const Picture a = render_reference(prepared, options);
  options.measured = &samples;
  const Picture b = render_reference(prepared, options);
  return {displayed(a, tone_map, 0), displayed(b, tone_map, 0), difference_picture(a, b, Scale::plus_minus),
          compare(a, b)};
}

}  // namespace brdf::render
