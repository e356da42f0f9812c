#include "io/page/sphere/still.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/colour/neutral.h"
#include "io/files/parallel.h"
#include "io/files/png.h"
#include "io/page/hatching.h"
#include "io/page/html_report.h"
#include "io/page/sphere/studio.h"

namespace brdf::io::sphere {
namespace {

// The radius as a share of the picture's side, as in sphere.js, and the rim as a share of the radius, as in
// sphere.glsl.
constexpr double kRadius = 0.47, kRim = 0.9999;

using Pixel = std::array<unsigned char, 4>;

double sum(const Colour& f) {
  return f[0] + f[1] + f[2];
}

Pixel lit(const Colour& f, double light) {
  Pixel pixel{0, 0, 0, 255};
  const Colour shown = neutral_display<double>({f[0] * light, f[1] * light, f[2] * light});
  for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<unsigned char>(std::lround(255 * shown[c]));
  return pixel;
}

// A point of the picture, and the share of its pixel that the ball covers.
struct Spot {
  double x, y, covered;
};
Spot spot_at(int column, int row, int side) {
  const double radius = kRadius * side;
  const double x = (column + 0.5 - 0.5 * side) / radius, y = (0.5 * side - row - 0.5) / radius;
  const double distance = std::hypot(x, y), inside = std::fmin(1.0, kRim / std::fmax(distance, kRim));
  return {x * inside, y * inside, std::clamp((1 - distance) * radius + 0.5, 0.0, 1.0)};
}

Pixel hatched(int x, int y) {
  const unsigned char grey = hatching(std::size_t(x), std::size_t(y));
  return {grey, grey, grey, 255};
}

// Returns fitted over measured, minus 1, of all channels together.
double relative_difference(const Colour& fitted, const Colour& known) {
  const double of = std::fmax(sum(known), 1e-30);
  return (sum(fitted) - of) / of;
}

Pixel difference(const Colour& fitted, const Colour& known, double range) {
  unsigned char rgb[3];
  map_colour(0.5 + 0.5 * relative_difference(fitted, known) / range, rgb, Colours::diverging);
  return {rgb[0], rgb[1], rgb[2], 255};
}

// One square of RGBA pixels each for the fitted material and, if there is a measurement, for the
// measurement and the difference.
using Panels = std::vector<std::vector<unsigned char>>;

Panels panels_of(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure, int side) {
  constexpr std::size_t kBytes = std::tuple_size_v<Pixel>;
  Panels panels(measured ? 3 : 1, std::vector<unsigned char>(kBytes * std::size_t(side) * std::size_t(side)));
  const double gain = kPi * std::exp2(exposure);
  const double range = difference_range(fitted, measured);
  const View view = first_view();
  const auto draw_row = [&](std::size_t row_number) {
    const int row = int(row_number);
    for (int column = 0; column < side; ++column) {
      const auto add = [&](std::vector<unsigned char>& panel, Pixel pixel, double covered) {
        pixel[3] = static_cast<unsigned char>(std::lround(255 * covered));
        std::ranges::copy(pixel, &panel[kBytes * (row_number * std::size_t(side) + std::size_t(column))]);
      };
      const auto [x, y, covered] = spot_at(column, row, side);
      const auto [wi, wo] = pair_at(view, x, y);
      if (!(covered > 0 && wi.z > 0)) {
        for (auto& panel : panels) add(panel, {}, covered);
        continue;
      }
      const Colour f = fitted(wi, wo);
      add(panels[0], lit(f, wi.z * gain), covered);
      if (!measured) continue;
      const std::optional<Colour> m = measured(wi, wo);
      add(panels[1], m ? lit(*m, wi.z * gain) : hatched(column, row), covered);
      add(panels[2], m ? difference(f, *m, range) : hatched(column, row), covered);
    }
  };
  parallel_for(std::size_t(side), draw_row);
  return panels;
}

// Calls visit(wi, wo) at about 300 lit points of the first view.
void for_each_lit(const std::function<void(const Vec3<double>&, const Vec3<double>&)>& visit) {
  for (double y = -0.95; y < 1; y += 0.1)
    for (double x = -0.95; x < 1; x += 0.1) {
      if (x * x + y * y >= 1) continue;
      if (const auto [wi, wo] = pair_at(first_view(), x, y); wi.z > 0) visit(wi, wo);
    }
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
  stills.range = difference_range(fitted, measured);
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

namespace {

// Returns the mean of each 2 x 2 pixels; colours count by their alpha.
std::vector<unsigned char> halved(const std::vector<unsigned char>& panel, std::size_t side) {
  const std::size_t half = side / 2;
  std::vector<unsigned char> out(4 * half * half);
  for (std::size_t at = 0; at < half * half; ++at) {
    std::array<int, 4> sum{};
    for (const std::size_t corner : {std::size_t(0), std::size_t(1), side, side + 1}) {
      const unsigned char* pixel = &panel[4 * (2 * (at / half) * side + 2 * (at % half) + corner)];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c] * pixel[3];
      sum[3] += pixel[3];
    }
    for (std::size_t c = 0; c < 3; ++c)
      out[4 * at + c] = static_cast<unsigned char>(sum[3] > 0 ? (sum[c] + sum[3] / 2) / sum[3] : 0);
    out[4 * at + 3] = static_cast<unsigned char>((sum[3] + 2) / 4);
  }
  return out;
}

}  // namespace

StudioPictures studio_pictures(const Material& material, double exposure, int side) {
  const Studio studio(material);
  const View view = first_view();
  const double gain = std::exp2(exposure);
  constexpr std::size_t kBytes = std::tuple_size_v<Pixel>;
  std::vector<unsigned char> panel(kBytes * std::size_t(side) * std::size_t(side));
  parallel_for(std::size_t(side), [&](std::size_t row) {
    for (int column = 0; column < side; ++column) {
      const auto [x, y, covered] = spot_at(column, int(row), side);
      if (!(covered > 0)) continue;
      Pixel pixel = lit(studio.reflected(view, x, y), gain);
      pixel[3] = static_cast<unsigned char>(std::lround(255 * covered));
      std::ranges::copy(pixel, &panel[kBytes * (row * std::size_t(side) + std::size_t(column))]);
    }
  });
  return {png_of(side, panel), png_of(side / 2, halved(panel, std::size_t(side)))};
}

double studio_exposure(const Material& material) {
  constexpr double kDark = 1.0 / 64, kBright = 4;
  const Studio studio(material);
  std::vector<double> values;
  for (double y = -0.9; y < 1; y += 0.2)
    for (double x = -0.9; x < 1; x += 0.2) {
      if (x * x + y * y >= 1) continue;
      const Colour c = studio.reflected(first_view(), x, y);
      values.push_back(std::max({c[0], c[1], c[2]}));
    }
  std::ranges::sort(values);
  const double low = values[values.size() / 10], high = values[values.size() * 9 / 10];
  if (!(high > 0) || (low < kBright && high > kDark)) return 0;
  return std::clamp(std::floor(2 * std::log2(0.8 / high)) / 2, -12.0, 12.0);
}

double difference_range(const FittedPairs& fitted, const MeasuredPairs& measured) {
  constexpr double kSteps[] = {0.01, 0.02, 0.05, 0.1, 0.2}, kWidest = 0.5;
  std::vector<double> sizes;
  for_each_lit([&](const Vec3<double>& wi, const Vec3<double>& wo) {
    if (const std::optional<Colour> m = measured ? measured(wi, wo) : std::nullopt)
      sizes.push_back(std::abs(relative_difference(fitted(wi, wo), *m)));
  });
  if (sizes.empty()) return kWidest;
  const auto at = sizes.begin() + std::ptrdiff_t(sizes.size() * 19 / 20);
  std::ranges::nth_element(sizes, at);
  const auto* const step = std::ranges::find_if(kSteps, [&](double s) { return *at <= s; });
  return step == std::end(kSteps) ? kWidest : *step;
}

double exposure_of(const FittedPairs& fitted) {
  std::vector<double> values;
  for_each_lit([&](const Vec3<double>& wi, const Vec3<double>& wo) {
    const Colour f = fitted(wi, wo);
    values.push_back(kPi * wi.z * std::max({f[0], f[1], f[2]}));
  });
  const auto at = values.begin() + std::ptrdiff_t(values.size() * 9 / 10);
  std::ranges::nth_element(values, at);
  if (!(*at > 0)) return 0;
  return std::clamp(std::floor(2 * std::log2(0.8 / *at)) / 2, -12.0, 12.0);
}

}  // namespace brdf::io::sphere
