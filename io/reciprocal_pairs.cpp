#include "io/reciprocal_pairs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace brdf::io {
namespace {

// Angles are compared in units of 1e-4 degrees, so that 10.0 and 9.9999999 are one.
long key(double angle) {
  return std::lround(angle * 1e4);
}

double azimuth(const SampleTable& t, std::size_t k) {
  const double d = std::abs(std::remainder(t.phi_o[k] - t.phi_i[k], 360.0));
  // At a pole the azimuth means nothing.
  return t.theta_i[k] == 0 || t.theta_o[k] == 0 ? 0 : d;
}

using Curve = std::map<double, double>;  // viewer's polar angle, value

double interpolated(const Curve& curve, double theta) {
  const auto above = curve.lower_bound(theta);
  if (above == curve.end()) return NAN;
  if (above->first == theta) return above->second;
  if (above == curve.begin()) return NAN;
  const auto below = std::prev(above);
  const double x = (theta - below->first) / (above->first - below->first);
  return below->second + x * (above->second - below->second);
}

// Of one channel: light's polar angle, azimuth, curve. A pole belongs to every azimuth. Of directions that
// occur more than once (both sides of the plane of incidence, turns of the sample) the first counts: a mean
// would hide the noise.
std::map<double, std::map<long, Curve>> curves(const SampleTable& t, std::size_t channel) {
  std::map<double, std::set<long>> azimuths;
  for (std::size_t k = 0; k < t.rows(); ++k)
    if (t.theta_o[k] != 0) azimuths[t.theta_i[k]].insert(key(azimuth(t, k)));
  std::map<double, std::map<long, Curve>> found;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    auto& of_light = found[t.theta_i[k]];
    const double value = t.values[channel][k];
    if (t.theta_o[k] == 0)
      for (const long phi : azimuths[t.theta_i[k]]) of_light[phi].try_emplace(0.0, value);
    else
      of_light[key(azimuth(t, k))].try_emplace(t.theta_o[k], value);
  }
  return found;
}

}  // namespace

std::vector<ReciprocalPair> exact_pairs(const SampleTable& t) {
  std::map<std::tuple<long, long, long>, std::size_t> rows;
  for (std::size_t k = 0; k < t.rows(); ++k)
    rows.try_emplace({key(t.theta_i[k]), key(t.theta_o[k]), key(azimuth(t, k))}, k);
  std::vector<ReciprocalPair> pairs;
  for (const auto& [place, k] : rows) {
    const auto& [i, o, phi] = place;
    if (i >= o) continue;
    const auto partner = rows.find({o, i, phi});
    if (partner == rows.end()) continue;
    for (std::size_t c = 0; c < t.channels.size(); ++c)
      pairs.push_back(
          {t.theta_i[k], t.theta_o[k], azimuth(t, k), c, t.values[c][k], t.values[c][partner->second], k});
  }
  return pairs;
}

std::vector<ReciprocalPair> interpolated_pairs(const SampleTable& t) {
  constexpr std::size_t kMostLights = 400;  // more are scattered directions: nothing to interpolate along
  std::set<double> lights;
  for (std::size_t k = 0; k < t.rows() && lights.size() <= kMostLights; ++k) lights.insert(t.theta_i[k]);
  if (lights.size() > kMostLights) return {};
  std::vector<ReciprocalPair> pairs;
  for (std::size_t c = 0; c < t.channels.size(); ++c) {
    const auto all = curves(t, c);
    for (auto a = all.begin(); a != all.end(); ++a)
      for (auto b = std::next(a); b != all.end(); ++b)
        for (const auto& [phi, curve] : a->second) {
          const auto other = b->second.find(phi);
          if (other == b->second.end()) continue;
          const double forward = interpolated(curve, b->first),
                       backward = interpolated(other->second, a->first);
          if (forward > 0 && backward > 0)
            pairs.push_back({a->first, b->first, double(phi) * 1e-4, c, forward, backward, 0});
        }
  }
  return pairs;
}

double relative_difference(const ReciprocalPair& pair) {
  return std::abs(pair.forward - pair.backward) / (0.5 * (std::abs(pair.forward) + std::abs(pair.backward)));
}

}  // namespace brdf::io
