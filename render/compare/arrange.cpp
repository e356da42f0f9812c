#include "render/compare/arrange.h"

#include <algorithm>
#include <cstdio>

#include "render/gpu/renderer.h"
#include "render/picture/canvas.h"

namespace brdf::render {
namespace {

BytePicture side(const Comparison& c, bool second) {
  BytePicture out = displayed(second ? *c.b : *c.a, c.tone_map, c.exposure);
  if (c.labels) draw_label(out, second ? c.name_b : c.name_a);
  return out;
}

std::string measures(const Difference& d) {
  char text[96];
  std::snprintf(text, sizeof text, "relative MSE %.3g, PSNR %.1f dB", d.rel_mse, d.psnr);
  return text;
}

// The scale of the false colours along the upper edge: 1e-6 to 1, a decade per sixth.
void draw_scale(BytePicture& picture) {
  const int pixels = label_pixels(picture), bar = std::max(4, pixels / 2), pad = pixels / 2;
  const int width = picture.width - 2 * pad;
  if (width < 12 * pixels) return;  // no room for its numbers
  fill(picture, {0, 0}, {picture.width, bar + 2 * pixels + pad}, {0, 0, 0}, 0.55f);
  for (int x = 0; x < width; ++x) {
    const float decade = -6 + 6 * (float(x) + 0.5f) / float(width);
    const glm::vec3 color = false_color(std::pow(10.0f, decade)) * 255.0f;
    fill(picture, {pad + x, pad}, {1, bar},
         {std::uint8_t(color.r), std::uint8_t(color.g), std::uint8_t(color.b)});
  }
  for (int k = 0; k <= 6; k += 2) {
    const std::string text = k == 6 ? "1" : "1e-" + std::to_string(6 - k);
    const float shift = k == 0 ? 0 : k == 6 ? 1 : 0.5f;  // the outermost stay inside
    const float left = float(pad) + float(width) * float(k) / 6 - shift * text_width(text, pixels);
    draw_text(picture, {left, float(pad + bar) + 1.2f * float(pixels)}, text, pixels);
  }
}

BytePicture false_colors(const Comparison& c) {
  BytePicture out = difference_picture(*c.a, *c.b);
  if (!c.labels) return out;
  draw_scale(out);
  draw_label(out, measures(c.difference));
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
    } else if (vector && renderer.gbuffer_bits() != 8) {  // bytes hold v/2 + 1/2 already
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
  BytePicture left = displayed(*c.a, c.tone_map, c.exposure);
  BytePicture right = displayed(*c.b, c.tone_map, c.exposure);
  if (c.labels) {
    draw_label(left, c.name_a, Corner::left);
    draw_label(right, c.name_b, Corner::right);
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
