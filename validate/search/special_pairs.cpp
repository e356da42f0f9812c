#include "validate/search/special_pairs.h"

#include <algorithm>
#include <cmath>

#include "validate/search/degrees.h"
#include "validate/search/search.h"

namespace brdf::validate {
namespace {

constexpr double kHorizon = 1e-16;  // a cosine; no angle in degrees comes closer

Where place_of(const Pair& p, Where above) {
  return std::min(p.wi.z, p.wo.z) < kHorizon ? Where::horizon : above;
}

void add_coincident(std::vector<PlacedPair>& out, double theta, double phi) {
  for (const Pair& p : {pair_at_angles(theta, phi, theta, phi), pair_at_angles(theta, phi, theta, phi + 180),
                        pair_at_angles(0, 0, theta, phi), pair_at_angles(theta, phi, 0, 0)})
    out.push_back({p, place_of(p, Where::coincident)});
}

}  // namespace

std::vector<PlacedPair> placed_pairs(std::size_t inside, std::size_t angles, std::uint64_t seed) {
  std::vector<PlacedPair> out;
  for (std::size_t k = 0; k < inside; ++k) {
    const std::vector<double> u = cover_point(k, 4, seed);
    const auto theta = [](double x) { return in_degrees(std::acos(x)); };
    const Pair p = pair_at_angles(theta(u[0]), 360 * u[1], theta(u[2]), 360 * u[3]);
    out.push_back({p, place_of(p, Where::inside)});
  }
  add_coincident(out, 0, 0);
  for (std::size_t k = 0; k < angles; ++k) {
    const std::vector<double> u = cover_point(k, 2, seed);
    add_coincident(out, 90 * u[0], k % 4 == 0 ? 0 : 360 * u[1]);
  }
  // Beyond 90 degrees f must be 0, and therefore finite.
  const double low[] = {0, 40, 80, 89.9, 89.9999, 90 - 1e-9, 90, 90 + 1e-9, 120, 180};
  for (const double theta_i : low)
    for (const double theta_o : low)
      for (const double phi : {0.0, 57.0, 90.0, 180.0, 270.0}) {
        const Pair p = pair_at_angles(theta_i, 0, theta_o, phi);
        out.push_back({p, place_of(p, Where::coincident)});
      }
  // Both cosines exactly 0, and the light opposite to the viewer.
  for (const double phi : {0.0, 57.0, 180.0}) {
    Pair p = pair_at_angles(90, 0, 90, phi);
    p.wi.z = p.wo.z = 0;
    out.push_back({p, Where::horizon});
  }
  return out;
}

}  // namespace brdf::validate
