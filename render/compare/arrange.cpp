#include "render/compare/arrange.h"

#include <algorithm>
#include <cstdio>

#include "io/files/numbers.h"
#include "render/gpu/renderer.h"
#include "render/picture/canvas.h"

namespace brdf::render {
namespace {

BytePicture shown(const Comparison& c, bool second) {
  const Picture *measured = second ? c.b : c.a, *fine = second ? c.fine_b : c.fine_a;
  return displayed(fine ? *fine : *measured, c.tone_map, c.exposure, c.rounding);
}

BytePicture side(const Comparison& c, bool second) {
  BytePicture out = shown(c, second);
  if (c.labels) draw_label(out, second ? c.name_b : c.name_a);
  return out;
}

// Returns the measures of a difference, without the PSNR if the text is too wide for `width` pixels.
std::string measures(const Difference& d, int width, int pixels) {
  char error[48], noise[48];
  std::snprintf(error, sizeof error, "relative MSE %.3g", d.rel_mse);
  std::snprintf(noise, sizeof noise, ", PSNR %.1f dB", d.psnr);
  const std::string unknown =
      d.not_measured > 0 ? ", " + io::short_number(100 * d.not_measured, 2) + " % not measured" : "";
  const std::string all = std::string(error) + noise + unknown;
  return int(text_width(all, pixels)) + pixels <= width ? all : error + unknown;
}

// Draws the scale of the false colours along the upper edge, above a sphere that fills the picture: 1e-6 to
// 1 with a decade per sixth, or -50 to 50 %.
void draw_scale(BytePicture& picture, Scale scale) {
  const int pixels = std::max(9, label_pixels(picture) * 3 / 5), bar = std::max(4, pixels / 2), pad = bar / 2;
  const int width = picture.width - 2 * pad;
  if (width < 12 * pixels) return;  // no room for the numbers
  fill(picture, {0, 0}, {picture.width, pad + bar + 3 * pixels / 2}, {0, 0, 0}, 0.55f);
  const bool log = scale == Scale::logarithmic;
  for (int x = 0; x < width; ++x) {
    const float along = (float(x) + 0.5f) / float(width);
    const glm::vec3 color =
        (log ? false_color(std::pow(10.0f, 6 * along - 6)) : signed_color(kMostSigned * (2 * along - 1))) *
        255.0f;
    fill(picture, {pad + x, pad}, {1, bar},
         {std::uint8_t(color.r), std::uint8_t(color.g), std::uint8_t(color.b)});
  }
  const std::vector<std::string> words =
      log ? std::vector<std::string>{"1e-6", "1e-4", "1e-2", "1"}
          : std::vector<std::string>{"A darker by 50 %", "0", "A brighter by 50 %"};
  for (std::size_t k = 0; k < words.size(); ++k) {
    const float along = float(k) / float(words.size() - 1);  // the outermost numbers stay inside
    const float left = float(pad) + along * (float(width) - text_width(words[k], pixels));
    draw_text(picture, {left, float(pad + bar) + 1.15f * float(pixels)}, words[k], pixels);
  }
}

BytePicture false_colors(const Comparison& c) {
  const Scale scale = c.measured ? Scale::plus_minus : Scale::logarithmic;
  BytePicture out = difference_picture(*c.a, *c.b, scale);
  if (!c.labels) return out;
  draw_scale(out, scale);
  draw_label(out, measures(c.difference, out.width, smallest_label(out)));
  return out;
}

bool is_direction(Target target) {
  return target == Target::normal || target == Target::tangent || target == Target::bitangent;
}

BytePicture target_picture(Renderer& renderer, Target target, const Picture& ids, float extent) {
  const bool direction = is_direction(target), vector = direction || target == Target::position;
  Picture picture = picture_from(ids.width, ids.height, renderer.read_target(target));
  for (std::size_t p = 0; p < picture.pixels.size(); ++p) {
    glm::vec4& pixel = picture.pixels[p];
    const glm::vec3 value(pixel);
    if (ids.pixels[p].a < 0.5f / 255) {
      pixel = glm::vec4(0);
    } else if (vector && renderer.gbuffer_bits() != 8) {  // bytes already contain v/2 + 1/2
      pixel = glm::vec4((direction ? value : value / extent) * 0.5f + 0.5f, 1);
    }
  }
  return displayed(picture, vector ? ToneMap::none : ToneMap::srgb, 0);
}

}  // namespace

BytePicture arranged(const Comparison& c, Display display) {
  if (display == Display::difference) return false_colors(c);
  if (display == Display::flip) return side(c, true);
  if (display != Display::split) return side(c, false);
  BytePicture left = shown(c, false), right = shown(c, true);
  if (c.labels) {
    const int border = int(c.split * float(left.width));
    draw_label(left, c.name_a, Corner::left, border - 2);
    draw_label(right, c.name_b, Corner::right, left.width - border - 2);
  }
  return split(left, right, c.split);
}

BytePicture beside(const Comparison& c) {
  return sheet({side(c, false), side(c, true), false_colors(c)}, {}, 3);
}

BytePicture sheet(std::vector<BytePicture> pictures, const std::vector<std::string>& names, int columns) {
  for (std::size_t k = 0; k < std::min(names.size(), pictures.size()); ++k) draw_label(pictures[k], names[k]);
  const int width = pictures.at(0).width, height = pictures[0].height;
  const int across = std::min(columns, int(pictures.size()));
  BytePicture out(width * across, height * ((int(pictures.size()) + columns - 1) / columns));
  for (int k = 0; k < int(pictures.size()); ++k) {
    const int left = width * (k % columns), top = height * (k / columns);
    for (int y = 0; y < height; ++y) {
      const auto row = pictures[std::size_t(k)].pixels.begin() + std::ptrdiff_t(y) * width;
      std::copy(row, row + width,
                out.pixels.begin() + std::ptrdiff_t(top + y) * out.width + std::ptrdiff_t(left));
    }
  }
  return out;
}

BytePicture target_sheet(Renderer& renderer, bool labels) {
  const Scene& scene = renderer.scene().scene;
  float extent = 1e-6f;
  for (const Item& item : renderer.scene().layers[0]) extent = std::max(extent, item.extent);
  const Picture ids =
      picture_from(scene.camera.width, scene.camera.height, renderer.read_target(Target::position));
  std::vector<BytePicture> pictures;
  for (int k = 0; k < kTargetCount; ++k) pictures.push_back(target_picture(renderer, Target(k), ids, extent));
  pictures.push_back(
      displayed(picture_from(ids.width, ids.height, renderer.read_color()), scene.tone_map, scene.exposure));
  std::vector<std::string> names;
  if (labels) {
    names.assign(kNames<Target>.begin(), kNames<Target>.end());
    names.emplace_back("lighting");
  }
  return sheet(std::move(pictures), names, 4);
}

}  // namespace brdf::render
