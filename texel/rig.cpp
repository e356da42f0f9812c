#include "texel/rig.h"

namespace brdf::texel {

bool is_in_range(const Rig& rig) {
  const auto is_length = [](double x) { return x >= kShortest && x <= kLongest; };
  const auto is_distance = [&](double x) { return is_length(x) || (std::isinf(x) && x > 0); };
  return is_distance(rig.light_distance) && is_distance(rig.viewer_distance) &&
         (rig.texel_size == 0 || is_length(rig.texel_size));
}

Vec3<double> place_of(const Rig& rig, std::size_t width, std::size_t height, double column, double row) {
  return {rig.texel_size * (column + 0.5 - 0.5 * double(width)),
          rig.texel_size * (0.5 * double(height) - row - 0.5), 0};
}

Vec3<double> direction_from(const Vec3<double>& place, const Vec3<double>& from_middle, double distance) {
  if (!std::isfinite(distance)) return from_middle;
  const Vec3<double> way = from_middle * distance - place;
  return way * (1 / std::sqrt(dot(way, way)));
}

double irradiance_at(const Vec3<double>& place, const Vec3<double>& from_middle, double distance) {
  if (!std::isfinite(distance)) return 1;
  const Vec3<double> way = from_middle * distance - place;
  return distance * distance / dot(way, way);
}

}  // namespace brdf::texel
