#include "synth/patch_symmetry.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "io/samples/degrees.h"

namespace brdf::synth {
namespace {

using io::klems::Patch;

using DirectionPair = std::array<Vec3<double>, 2>;  // of the light and of the viewer

// Compares f_r at pairs of directions around the mirror direction and far from it.
template <class Change>
bool is_unchanged(const Material& material, Change&& change) {
  constexpr double kSame = 1e-6;
  constexpr double kFromMirror[][2] = {{0, 0}, {1, 2}, {-4, 9}, {9, -35}, {-3, 80}, {4, 171}};
  std::vector<double> before(material.channels.size()), after(before.size());
  for (const double theta : {5.0, 35.0, 70.0, 83.0})
    for (const double phi : {0.0, 13.0, 90.0, 201.0})
      for (const auto& [from_theta, from_phi] : kFromMirror) {
        const DirectionPair pair{io::unit_vector(theta, phi),
                                 io::unit_vector(std::abs(theta + from_theta) / 1.05, phi + 180 + from_phi)};
        const DirectionPair changed = change(pair);
        eval(material, pair[0], pair[1], before);
        eval(material, changed[0], changed[1], after);
        for (std::size_t c = 0; c < before.size(); ++c)
          if (!(std::abs(before[c] - after[c]) <= kSame * std::abs(before[c]))) return false;
      }
  return true;
}

}  // namespace

PatchSymmetry symmetry_of(const Material& material) {
  const auto turned = [](double by) {
    return [c = io::cos_degrees(by), s = io::sin_degrees(by)](DirectionPair pair) {
      for (Vec3<double>& w : pair) w = {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
      return pair;
    };
  };
  PatchSymmetry out;
  out.turn = !is_anisotropic(material) && is_unchanged(material, turned(13)) &&
             is_unchanged(material, turned(90)) && is_unchanged(material, turned(201));
  out.mirror_x = is_unchanged(material, [](DirectionPair pair) {
    for (Vec3<double>& w : pair) w.y = -w.y;
    return pair;
  });
  out.mirror_y = is_unchanged(material, [](DirectionPair pair) {
    for (Vec3<double>& w : pair) w.x = -w.x;
    return pair;
  });
  out.exchange = is_unchanged(material, [](DirectionPair pair) { return DirectionPair{pair[1], pair[0]}; });
  return out;
}

PatchSymmetry::Class PatchSymmetry::class_of(const Patch& light, const Patch& viewer) const {
  constexpr double kPerDegree = 1e6;  // finer than all steps
  const auto whole = [](double degrees) {
    return std::lround(io::within_turn(degrees) * kPerDegree) % std::lround(360 * kPerDegree);
  };
  constexpr unsigned kMirrorX = 1, kMirrorY = 2, kExchange = 4, kImages = 8;
  const unsigned possible =
      (mirror_x ? kMirrorX : 0u) | (mirror_y ? kMirrorY : 0u) | (exchange ? kExchange : 0u);
  std::optional<Class> least;
  for (unsigned image = 0; image < kImages; ++image) {
    if ((image & ~possible) != 0) continue;
    const Patch *first = &light, *second = &viewer;
    // Light is incident from the azimuth of its patch + 180 degrees.
    double from = light.phi + 180, to = viewer.phi;
    if (image & kExchange) std::swap(first, second), std::swap(from, to);
    if (image & kMirrorX) from = -from, to = -to;
    if (image & kMirrorY) from = 180 - from, to = 180 - to;
    if (turn) to -= from, from = 0;
    const Class own{std::lround(first->lower * kPerDegree), std::lround(second->lower * kPerDegree),
                    whole(from), whole(to)};
    if (!least || own < *least) least = own;
  }
  return *least;
}

}  // namespace brdf::synth
