#include "io/page/sphere/studio.h"

#include <algorithm>
#include <cmath>

#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/error.h"

namespace brdf::io::sphere {
namespace {

constexpr double kNarrowest = 0.005, kWidest = 1;

// Returns f_r of the brightest channel for both directions at the same place.
double seen_back(const FittedPairs& fitted, double theta, double phi) {
  const Vec3<double> w = direction(radians(theta), radians(phi));
  const Colour f = fitted(w, w);
  return std::max({f[0], f[1], f[2]});
}

// Returns the angle at which the value has fallen to a share of the way from the middle to 60 degrees.
double angle_of_share(const FittedPairs& fitted, double phi, double share) {
  const double outside = seen_back(fitted, kPi / 3, phi), peak = seen_back(fitted, 0, phi) - outside;
  if (!(peak > 1e-3 * std::fabs(outside))) return kPi / 3;
  double low = 1e-4, high = kPi / 3;
  for (int k = 0; k < 30; ++k) {
    const double middle = std::sqrt(low * high);
    (seen_back(fitted, middle, phi) - outside > share * peak ? low : high) = middle;
  }
  return high;
}

Vec3<float> rounded(const Vec3<double>& w) {
  return {float(w.x), float(w.y), float(w.z)};
}

Vec3<double> local(const Vec3<double>& w, const Vec3<double>& t, const Vec3<double>& b,
                   const Vec3<double>& n) {
  return {dot(w, t), dot(w, b), dot(w, n)};
}

}  // namespace

std::array<double, 2> lobe_widths(const FittedPairs& fitted) {
  // GGX falls to the share s where tan^2 = width^2 (1/sqrt(s) - 1).
  const auto width = [&](double phi, double share) {
    return std::tan(angle_of_share(fitted, phi, share)) / std::sqrt(1 / std::sqrt(share) - 1);
  };
  const double narrow = std::fmin(width(0, 0.5), width(kPi / 2, 0.5)),
               wide = std::fmax(width(0, 0.03), width(kPi / 2, 0.03));
  return {std::clamp(std::fmin(narrow, wide), kNarrowest, kWidest),
          std::clamp(std::fmax(narrow, wide), kNarrowest, kWidest)};
}

Studio::Studio(const Material& given) : material_(in_colour(given)) {
  const std::optional<ChannelColours> colours = channel_colours(material_.channels);
  if (!colours) throw InputError("the channels of the material cannot be converted to a colour");
  channels_ = colours->of;
  widths_ = lobe_widths(fitted_pairs(material_));
}

Colour Studio::reflected(const View& view, double x, double y) const {
  constexpr std::size_t kAll = std::size_t(kStillRounds * kDirections);
  const auto [n, t, b] = frame_at(view, x, y);
  const Vec3<double> wo = local(view.towards, t, b, n);
  DirectionArrays<float> pairs(kAll);
  std::array<std::array<double, 3>, kAll> weights{};
  constexpr std::array steps = additive_recurrence_steps<2>();
  for (int k = 0; k < kStillRounds; ++k) {
    const double u1 = additive_recurrence(0.5, steps[0], std::uint64_t(k)),
                 u2 = additive_recurrence(0.5, steps[1], std::uint64_t(k));
    const std::array boxes = studio::box_directions(u1, u2);
    for (int j = 0; j < kDirections; ++j) {
      const Vec3<double> wi = j < kBoxes ? local(boxes[std::size_t(j)], t, b, n)
                              : j == kBoxes
                                  ? sample_cosine(u1, u2)
                                  : lobe_direction(widths_[std::size_t(j - kBoxes - 1)], u1, u2, wo);
      const std::size_t at = std::size_t(k * kDirections + j);
      pairs.set(at, rounded(wi), rounded(wo));
      if (!(wi.z > 0)) continue;
      const Vec3<double> w = t * wi.x + b * wi.y + n * wi.z;
      const double density = studio::box_density(w) + wi.z / kPi + lobe_density(widths_[0], wi, wo) +
                             lobe_density(widths_[1], wi, wo);
      const double share = studio::floor_share(n, w) / (density * kStillRounds);
      weights[at] = studio::radiance(w);
      for (double& weight : weights[at]) weight *= share;
    }
  }
  Colour sum{};
  std::vector<float> values(kAll);
  for (const Term& term : material_.terms)
    for (std::size_t c = 0; c < 3; ++c) {
      if (c == 0 || channels_[c] != channels_[c - 1])
        eval_cos_batch(term, channels_[c], pairs.view(), values.data());
      for (std::size_t k = 0; k < kAll; ++k) sum[c] += double(values[k]) * weights[k][c];
    }
  return sum;
}

}  // namespace brdf::io::sphere
