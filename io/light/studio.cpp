#include "io/light/studio.h"

namespace brdf::io::studio {
namespace {

Vec3<double> unit(const Vec3<double>& v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

SoftBox box(const Vec3<double>& toward, const std::array<double, 2>& half, double edge,
            const std::array<double, 3>& radiance) {
  const Vec3<double> centre = unit(toward), across = unit(cross(Vec3<double>{0, 1, 0}, centre));
  return {centre, across, cross(centre, across), half, edge, radiance};
}

}  // namespace

const std::array<SoftBox, 3>& soft_boxes() {
  static const std::array<SoftBox, 3> boxes{box({-0.75, 0.8, 0.75}, {0.5, 0.5}, 0.12, {3.2, 3.1, 3.0}),
                                            box({1.0, 0.15, 0.45}, {0.2, 0.75}, 0.15, {1.5, 1.6, 1.75}),
                                            box({0.35, 0.75, -0.85}, {0.75, 0.22}, 0.15, {2.0, 2.0, 2.0})};
  return boxes;
}

}  // namespace brdf::io::studio
