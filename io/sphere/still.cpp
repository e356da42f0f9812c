#include "io/sphere/still.h"

#include <algorithm>
#include <cmath>

#include "io/html_report.h"
#include "io/png.h"
#include "io/srgb.h"

namespace brdf::io::sphere {
namespace {

// As in sphere.js, of the picture's side, and as in sphere.glsl, of the radius.
constexpr double kRadius = 0.47, kRim = 0.9999;

using Pixel = std::array<unsigned char, 4>;

unsigned char encoded(double linear) {
  return static_cast<unsigned char>(std::lround(255 * srgb_encoded(std::clamp(linear, 0.0, 1.0))));
}

double sum(const Colour& f) {
  return f[0] + f[1] + f[2];
}

Pixel lit(const Colour& f, double light) {
  return {encoded(f[0] * light), encoded(f[1] * light), encoded(f[2] * light), 255};
}

// As hatched() of sphere.glsl.
Pixel hatched(int x, int y, double radius) {
  const auto grey = static_cast<unsigned char>(std::fmod(x + y, radius / 8) < radius / 40 ? 89 : 140);
  return {grey, grey, grey, 255};
}

Pixel difference(const Colour& fitted, const Colour& known) {
  const double of = std::fmax(sum(known), 1e-30);
  unsigned char rgb[3];
  map_colour((sum(fitted) - of) / of + 0.5, rgb, Colours::diverging);
  return {rgb[0], rgb[1], rgb[2], 255};
}

}  // namespace

std::string still_picture(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure,
                          int side) {
  const int panels = measured ? 3 : 1, width = panels * side;
  const double radius = kRadius * side, gain = kPi * std::exp2(exposure);
  const View view = first_view();
  std::vector<unsigned char> bytes;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < width; ++column) {
      const int panel = column / side, up = side - 1 - row;
      const double x = (column % side + 0.5 - 0.5 * side) / radius, y = (up + 0.5 - 0.5 * side) / radius;
      const double distance = std::hypot(x, y), covered = std::clamp((1 - distance) * radius + 0.5, 0.0, 1.0);
      Pixel pixel{};
      if (covered > 0) {
        const double inside = std::fmin(1.0, kRim / std::fmax(distance, kRim));
        const auto [wi, wo] = pair_at(view, x * inside, y * inside);
        pixel = {0, 0, 0, 255};
        if (wi.z > 0) {
          const Colour f = fitted(wi, wo);
          const std::optional<Colour> m = panel > 0 ? measured(wi, wo) : f;
          pixel = !m ? hatched(column, up, radius) : panel == 2 ? difference(f, *m) : lit(*m, wi.z * gain);
        }
        pixel[3] = static_cast<unsigned char>(std::lround(255 * covered));
      }
      bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    }
  return png_of_pixels(std::size_t(width), std::size_t(side), bytes);
}

double exposure_of(const FittedPairs& fitted) {
  std::vector<double> values;
  const View view = first_view();
  for (double y = -0.95; y < 1; y += 0.1)
    for (double x = -0.95; x < 1; x += 0.1) {
      if (x * x + y * y >= 1) continue;
      const auto [wi, wo] = pair_at(view, x, y);
      if (wi.z <= 0) continue;
      const Colour f = fitted(wi, wo);
      values.push_back(kPi * wi.z * std::max({f[0], f[1], f[2]}));
    }
  const auto at = values.begin() + std::ptrdiff_t(values.size() * 9 / 10);
  std::nth_element(values.begin(), at, values.end());
  if (!(*at > 0)) return 0;
  return std::clamp(std::floor(2 * std::log2(0.8 / *at)) / 2, -12.0, 12.0);
}

}  // namespace brdf::io::sphere
