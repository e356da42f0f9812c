#include "render/compare/measured.h"

#include "measured/on_sphere.h"
#include "measured/tabulated.h"
#include "render/scene/scene.h"

namespace brdf::render {
namespace {

Vec3<double> vec(const glm::vec3& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

}  // namespace

Measured interpolate(const io::SampleTable& table, const Material* fitted) {
  const auto seen = measured::seen_in_colour(table, fitted, measured::MeasuredReflectance::Beside::likeliest);
  const std::array<std::size_t, 3> colours = require_colours(seen->channels(), table.source).of;
  const auto samples = std::make_shared<const measured::Tabulated>(seen);
  return [samples, colours](const glm::vec3& wi, const glm::vec3& wo) {
    if (!(wi.z > 0 && wo.z > 0)) return MeasuredValue(glm::vec3(0));
    const measured::Seen value = samples->at(vec(wi), vec(wo));
    glm::vec3 f;
    for (int c = 0; c < 3; ++c) f[c] = float(value.f[colours[std::size_t(c)]]);
    return MeasuredValue(f * wi.z, value.measured);
  };
}

}  // namespace brdf::render
