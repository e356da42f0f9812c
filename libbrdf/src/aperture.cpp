#include "brdf/aperture.h"

#include <algorithm>
#include <cmath>

#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/functions.h"

namespace brdf {

std::vector<ApertureNode> aperture_nodes(Angle full_width, int rings) {
  if (!(full_width > Angle{})) return {{{0, 0, 1}, 1}};
  const double sin_quarter = integrals::sin(full_width.radians() / 4);
  const double height = 2 * sin_quarter * sin_quarter;  // 1 - cos of the half angle, without cancellation
  const int steps = std::max(8, 2 * rings);
  const quadrature::GaussRule& rule = quadrature::gauss_legendre(rings);
  std::vector<ApertureNode> nodes;
  for (std::size_t k = 0; k < rule.node.size(); ++k) {
    const double t = rule.node[k] * height;
    const double radius = std::sqrt(t * (2 - t));
    for (int step = 0; step < steps; ++step) {
      const double phi = 2 * kPi * (step + (k % 2 ? 0.5 : 0.0)) / steps;
      nodes.push_back(
          {{radius * integrals::cos(phi), radius * integrals::sin(phi), 1 - t}, rule.weight[k] / steps});
    }
  }
  return nodes;
}

// The frame follows Duff et al. 2017, "Building an orthonormal basis, revisited".
Vec3<double> aperture_direction(const Vec3<double>& axis, const ApertureNode& node) {
  const double sign = std::copysign(1.0, axis.z);
  const double a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
  const Vec3<double> u{1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
  const Vec3<double> v{b, sign + axis.y * axis.y * a, -axis.y};
  const auto& [x, y, z] = node.direction;
  return {x * u.x + y * v.x + z * axis.x, x * u.y + y * v.y + z * axis.y, x * u.z + y * v.z + z * axis.z};
}

void eval_aperture(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
                   std::span<const ApertureNode> source, std::span<const ApertureNode> detector,
                   std::span<double> out) {
  std::vector<double> value(out.size());
  std::ranges::fill(out, 0.0);
  for (const ApertureNode& from : source) {
    const Vec3<double> light = aperture_direction(wi, from);
    for (const ApertureNode& to : detector) {
      eval(material, light, aperture_direction(wo, to), value);
      for (std::size_t c = 0; c < out.size(); ++c) out[c] += from.weight * to.weight * value[c];
    }
  }
}

}  // namespace brdf
