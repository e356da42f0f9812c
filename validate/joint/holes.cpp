#include "validate/joint/holes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/random.h"

namespace brdf::validate {
namespace {

constexpr int kRings = 1 << 8;
static_assert(long{kRings} * kRings == kHoleDirections);

// A direction of the cosine distribution in the cell of a ring and a sector.
Vec3<double> direction_in(int ring, int sector, Random& random) {
  const double rho2 = (ring + random.uniform()) / kRings,
               phi = 2 * kPi * (sector + random.uniform()) / kRings;
  const double rho = std::sqrt(rho2);
  return {rho * std::cos(phi), rho * std::sin(phi), std::sqrt(1 - rho2)};
}

}  // namespace

Holes holes_of(const Trio& trio, std::uint64_t seed) {
  Random random(seed);
  Holes out;
  const std::size_t channels = std::min<std::size_t>(trio.channels(), 3);
  std::array<double, 3> all{}, lost{};
  for (int ring = 0; ring < kRings; ++ring) {
    std::vector<Vec3<double>> wi;
    for (int sector = 0; sector < kRings; ++sector) wi.push_back(direction_in(ring, sector, random));
    const std::vector<double> f = trio.f(wi, false), density = trio.density(wi);
    for (std::size_t k = 0; k < wi.size(); ++k) {
      double brightest = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        const double value = f[c * wi.size() + k];
        if (!std::isfinite(value)) continue;
        brightest = std::max(brightest, value * wi[k].z);
        all[c] += value;
        if (!(density[k] > 0)) lost[c] += value;
      }
      if (!(brightest > 0)) continue;
      ++out.directions;
      if (density[k] > 0) continue;
      ++out.dark;
      if (brightest > out.brightest_value) out.brightest_value = brightest, out.brightest = wi[k];
    }
  }
  for (std::size_t c = 0; c < channels; ++c)
    if (all[c] > 0) out.share = std::max(out.share, lost[c] / all[c]);
  return out;
}

double least_hole(double probability) {
  return -std::log(probability) / double(kHoleDirections);
}

}  // namespace brdf::validate
