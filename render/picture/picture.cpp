#include "render/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/page/hatching.h"
#include "render/picture/dither.h"
#include "render/scene/display_rule.h"

namespace brdf::render {
namespace {

constexpr double kRelMseFloor = 0.01;  // the usual value: keeps black pixels from dominating

// Rounds up from the fraction `threshold` of a byte's step; 0.5 rounds to the nearest. Black and white stay
// unchanged.
std::array<std::uint8_t, 3> to_bytes(glm::vec3 c, float threshold = 0.5f) {
  std::array<std::uint8_t, 3> out{};
  for (int k = 0; k < 3; ++k)
    out[std::size_t(k)] = std::uint8_t(std::floor(glm::clamp(c[k], 0.0f, 1.0f) * 255 + 1 - threshold));
  return out;
}

}  // namespace

Picture picture_from(int width, int height, const std::vector<float>& rgba) {
  Picture picture(width, height);
  for (std::size_t k = 0; k < picture.pixels.size(); ++k)
    picture.pixels[k] = {rgba[4 * k], rgba[4 * k + 1], rgba[4 * k + 2], rgba[4 * k + 3]};
  return picture;
}

namespace {

// Returns the colour of the stripes, independent of the picture below.
constexpr std::array<std::uint8_t, 3> hatched(std::size_t x, std::size_t y) {
  const std::uint8_t grey = io::hatching(x, y);
  return {grey, grey, grey};
}

}  // namespace

Difference compare(const Picture& picture, const Picture& reference) {
  Difference out;
  double squared = 0, clamped = 0;
  std::size_t covered = 0, mismatched = 0, unknown = 0;
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    const glm::dvec4 a(picture.pixels[k]), b(reference.pixels[k]);
    if ((a.a > 0.5) != (b.a > 0.5)) ++mismatched;
    if (!(a.a > 0.5 && b.a > 0.5)) continue;
    if (!is_measured(reference.pixels[k])) {
      ++unknown;
      continue;
    }
    ++covered;
    for (int c = 0; c < 3; ++c) {
      squared += (a[c] - b[c]) * (a[c] - b[c]) / (b[c] * b[c] + kRelMseFloor);
      const double d = glm::clamp(a[c], 0.0, 1.0) - glm::clamp(b[c], 0.0, 1.0);
      clamped += d * d;
    }
  }
  if (covered > 0) {
    out.rel_mse = squared / double(3 * covered);
    out.psnr = clamped > 0 ? -10 * std::log10(clamped / double(3 * covered))
                           : std::numeric_limits<double>::infinity();
  }
  if (unknown > 0) out.not_measured = double(unknown) / double(covered + unknown);
  out.coverage_mismatch = double(mismatched) / double(picture.pixels.size());
  return out;
}

glm::vec3 tone_mapped(glm::vec3 linear, ToneMap tone_map, float exposure) {
  const glm::vec3 c = linear * std::exp2(exposure);
  const Colour<float> shown = tone_curve<float>(tone_map, {c.r, c.g, c.b});
  return {shown[0], shown[1], shown[2]};
}

BytePicture displayed(const Picture& picture, ToneMap tone_map, float exposure, Rounding rounding) {
  BytePicture out(picture.width, picture.height);
  for (std::size_t k = 0; k < out.pixels.size(); ++k) {
    const glm::vec4& pixel = picture.pixels[k];
    const std::size_t x = k % std::size_t(picture.width), y = k / std::size_t(picture.width);
    out.pixels[k] = is_surface(pixel) && !is_measured(pixel)
                        ? hatched(x, y)
                        : to_bytes(tone_mapped(glm::vec3(pixel), tone_map, exposure),
                                   rounding == Rounding::nearest ? 0.5f : dither_threshold(int(x), int(y)));
  }
  return out;
}

std::vector<double> surface_brightness(const Picture& picture) {
  std::vector<double> out;
  for (const glm::vec4& p : picture.pixels) {
    const float most = std::max({p.r, p.g, p.b});
    if (is_surface(p) && most > 0) out.push_back(double(most));
  }
  std::ranges::sort(out);
  return out;
}

float exposure_from(const Picture& picture) {
  const std::vector<double> lit = surface_brightness(picture);
  if (lit.empty()) return 0;
  const double bright = lit[std::size_t(kExposedShare * double(lit.size() - 1))];
  return float(std::clamp(std::round(100 * std::log2(kExposedTo / bright)) / 100, -20.0, 20.0));
}

double clipped_share(const Picture& picture, ToneMap tone_map, float exposure) {
  // Curves that never reach 1 clip where rounding to bytes gives the brightest byte.
  const bool clamps = tone_map == ToneMap::none || tone_map == ToneMap::srgb;
  std::size_t clipped = 0, covered = 0;
  for (const glm::vec4& p : picture.pixels) {
    if (p.a < 0.5f) continue;
    ++covered;
    const float most = std::max({p.r, p.g, p.b}) * std::exp2(exposure);
    if (clamps ? most > 1 : tone_mapped(glm::vec3(most), tone_map, 0).r * 255 >= 254.5f) ++clipped;
  }
  return covered ? double(clipped) / double(covered) : 0;
}

double not_finite_share(const Picture& picture) {
  std::size_t count = 0, covered = 0;
  for (const glm::vec4& p : picture.pixels) {
    if (p.a < 0.5f) continue;
    ++covered;
    count += !(std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b));
  }
  return covered ? double(count) / double(covered) : 0;
}

glm::vec3 false_color(float relative_difference) {
  const Colour<float> c = false_color_of(relative_difference);
  return {c[0], c[1], c[2]};
}

glm::vec3 signed_color(float relative_difference) {
  const Colour<float> c = signed_color_of(relative_difference);
  return {c[0], c[1], c[2]};
}

BytePicture difference_picture(const Picture& picture, const Picture& reference, Scale scale) {
  BytePicture out(picture.width, picture.height);
  for (std::size_t k = 0; k < out.pixels.size(); ++k) {
    if (!is_surface(picture.pixels[k]) && !is_surface(reference.pixels[k])) continue;
    if (is_surface(reference.pixels[k]) && !is_measured(reference.pixels[k])) {
      out.pixels[k] = hatched(k % std::size_t(picture.width), k / std::size_t(picture.width));
      continue;
    }
    const glm::vec3 a(picture.pixels[k]), b(reference.pixels[k]);
    float worst = 0;
    if (a == b && b == glm::vec3(0)) continue;  // unlit
    for (int c = 0; c < 3; ++c) {
      const float relative = (a[c] - b[c]) / std::max(std::abs(b[c]), 1e-6f);
      if (std::abs(relative) > std::abs(worst)) worst = relative;
    }
    out.pixels[k] =
        to_bytes(scale == Scale::logarithmic ? false_color(std::abs(worst)) : signed_color(worst));
  }
  return out;
}

BytePicture split(const BytePicture& left, const BytePicture& right, float share) {
  BytePicture out = left;
  const int border = int(share * float(out.width));
  for (int y = 0; y < out.height; ++y) {
    for (int x = border; x < out.width; ++x) {
      const std::size_t at = std::size_t(y) * std::size_t(out.width) + std::size_t(x);
      out.pixels[at] = x == border ? std::array<std::uint8_t, 3>{255, 255, 255} : right.pixels[at];
    }
  }
  return out;
}

}  // namespace brdf::render
