// The renderer's default sphere without a renderer: a unit sphere, a camera at distance 4 with a field of
// view of 32 degrees, a directional light of irradiance pi from the upper left front. The ray of a pixel
// passes through its centre.
#pragma once

#include <cmath>
#include <vector>

#include "brdf/vec3.h"

namespace brdf::measured {

struct Pixel {
  int x, y;
  Vec3<double> wi, wo;               // in the surface's frame
  double theta_i, theta_o, theta_h;  // degrees
};

// Returns the pixels on which the surface faces light and viewer.
inline std::vector<Pixel> lit_pixels(int size) {
  const double distance = 4, half = std::tan(16 * kPi / 180), third = 1 / std::sqrt(3.0);
  const Vec3<double> light{-third, third, third};
  std::vector<Pixel> out;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      Vec3<double> ray{half * (2 * (x + 0.5) / size - 1), half * (1 - 2 * (y + 0.5) / size), -1};
      ray = ray * (1 / std::sqrt(dot(ray, ray)));
      const double b = -ray.z * distance, root = b * b - distance * distance + 1;
      if (root < 0) continue;
      const double t = b - std::sqrt(root);
      const Vec3<double> n{t * ray.x, t * ray.y, distance + t * ray.z};
      const Vec3<double> to_viewer = ray * -1.0;
      // The tangent follows the sphere's circles of latitude.
      const double across = std::hypot(n.x, n.z);
      const Vec3<double> tangent{n.z / across, 0, -n.x / across};
      const Vec3<double> bitangent = cross(n, tangent);
      const auto local = [&](const Vec3<double>& w) {
        return Vec3<double>{dot(w, tangent), dot(w, bitangent), dot(w, n)};
      };
      const Vec3<double> wi = local(light), wo = local(to_viewer);
      if (!(wi.z > 0 && wo.z > 0)) continue;
      const Vec3<double> h = wi + wo;
      const auto degrees_from = [](double cosine) { return std::acos(cosine) * 180 / kPi; };
      out.push_back(
          {x, y, wi, wo, degrees_from(wi.z), degrees_from(wo.z), degrees_from(h.z / std::sqrt(dot(h, h)))});
    }
  }
  return out;
}

}  // namespace brdf::measured
