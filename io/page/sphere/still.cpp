#include "io/page/sphere/still.h"

#include <algorithm>
#include <cmath>

#include "io/colour/srgb.h"
#include "io/files/parallel.h"
#include "io/files/png.h"
#include "io/page/hatching.h"
#include "io/page/html_report.h"

namespace brdf::io::sphere {
namespace {

// The radius as a share of the picture's side, as in sphere.js, and the rim as a share of the radius, as in
// sphere.glsl.
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

Pixel hatched(int x, int y) {
  const unsigned char grey = hatching(std::size_t(x), std::size_t(y));
  return {grey, grey, grey, 255};
}

Pixel difference(const Colour& fitted, const Colour& known) {
  const double of = std::fmax(sum(known), 1e-30);
  unsigned char rgb[3];
  map_colour((sum(fitted) - of) / of + 0.5, rgb, Colours::diverging);
  return {rgb[0], rgb[1], rgb[2], 255};
}

// One square of RGBA pixels each for the fitted material and, if there is a measurement, for the
// measurement and the difference.
using Panels = std::vector<std::vector<unsigned char>>;

Panels panels_of(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure, int side) {
  constexpr std::size_t kBytes = std::tuple_size_v<Pixel>;
  Panels panels(measured ? 3 : 1, std::vector<unsigned char>(kBytes * std::size_t(side) * std::size_t(side)));
  const double radius = kRadius * side, gain = kPi * std::exp2(exposure);
  const View view = first_view();
  const auto draw_row = [&](std::size_t row_number) {
    const int row = int(row_number);
    for (int column = 0; column < side; ++column) {
      const auto add = [&](std::vector<unsigned char>& panel, Pixel pixel, double covered) {
        pixel[3] = static_cast<unsigned char>(std::lround(255 * covered));
        std::ranges::copy(pixel, &panel[kBytes * (row_number * std::size_t(side) + std::size_t(column))]);
      };
      const double x = (column + 0.5 - 0.5 * side) / radius, y = (0.5 * side - row - 0.5) / radius;
      const double distance = std::hypot(x, y), covered = std::clamp((1 - distance) * radius + 0.5, 0.0, 1.0);
      const double inside = std::fmin(1.0, kRim / std::fmax(distance, kRim));
      const auto [wi, wo] = pair_at(view, x * inside, y * inside);
      if (!(covered > 0 && wi.z > 0)) {
        for (auto& panel : panels) add(panel, {}, covered);
        continue;
      }
      const Colour f = fitted(wi, wo);
      add(panels[0], lit(f, wi.z * gain), covered);
      if (!measured) continue;
      const std::optional<Colour> m = measured(wi, wo);
      add(panels[1], m ? lit(*m, wi.z * gain) : hatched(column, row), covered);
      add(panels[2], m ? difference(f, *m) : hatched(column, row), covered);
    }
  };
  parallel_for(std::size_t(side), draw_row);
  return panels;
}

std::string png_of(int side, const std::vector<unsigned char>& panel) {
  return png_of_pixels(std::size_t(side), std::size_t(side), panel);
}

}  // namespace

Stills still_pictures(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure, int side) {
  const Panels panels = panels_of(fitted, measured, exposure, side);
  Stills stills{.fitted = png_of(side, panels[0])};
  if (!measured) return stills;
  stills.measured = png_of(side, panels[1]);
  stills.difference = png_of(side, panels[2]);
  return stills;
}

std::string still_picture(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure,
                          int side) {
  const Panels panels = panels_of(fitted, measured, exposure, side);
  std::vector<unsigned char> bytes;
  for (std::ptrdiff_t row = 0; row < side; ++row)
    for (const auto& panel : panels)
      bytes.insert(bytes.end(), panel.begin() + 4 * side * row, panel.begin() + 4 * side * (row + 1));
  return png_of_pixels(panels.size() * std::size_t(side), std::size_t(side), bytes);
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
  std::ranges::nth_element(values, at);
  if (!(*at > 0)) return 0;
  return std::clamp(std::floor(2 * std::log2(0.8 / *at)) / 2, -12.0, 12.0);
}

}  // namespace brdf::io::sphere
