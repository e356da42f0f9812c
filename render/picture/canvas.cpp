#include "render/picture/canvas.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "render/text/font.h"

namespace brdf::render {
namespace {

std::vector<char32_t> shown_characters(const std::string& text) {
  try {
    return code_points(text);
  } catch (const InputError&) {
    std::vector<char32_t> out;
    for (const char c : text) out.push_back(static_cast<unsigned char>(c) < 0x80 ? char32_t(c) : U'?');
    return out;
  }
}

// Calls visit(glyph slot, pen) for each letter and returns the width in pixels.
template <class Visit>
float for_each_glyph(const std::string& text, int pixels, Visit visit) {
  // Each thread has its own font, because drawing changes the state of FreeType's faces.
  thread_local const Font font(Font::plain());
  FT_Set_Pixel_Sizes(font.face(), 0, FT_UInt(pixels));
  float pen = 0;
  for (const char32_t code : shown_characters(text)) {
    if (FT_Load_Char(font.face(), code, FT_LOAD_RENDER)) continue;
    visit(*font.face()->glyph, pen);
    pen += float(font.face()->glyph->advance.x) / 64;
  }
  return pen;
}

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 along = b - a;
  const float length2 = glm::dot(along, along);
  const float t = length2 > 0 ? glm::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0;
  return glm::distance(p, a + t * along);
}

}  // namespace

void blend(BytePicture& picture, int x, int y, ByteColor color, float share) {
  if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
  ByteColor& pixel = picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = std::uint8_t(std::lround(glm::mix(float(pixel[c]), float(color[c]), share)));
}

void fill(BytePicture& picture, glm::ivec2 corner, glm::ivec2 size, ByteColor color, float share) {
  for (int y = corner.y; y < corner.y + size.y; ++y)
    for (int x = corner.x; x < corner.x + size.x; ++x) blend(picture, x, y, color, share);
}

void draw_path(BytePicture& picture, const std::vector<glm::vec2>& points, float width, ByteColor color) {
  if (points.size() < 2) return;
  glm::vec2 low = points[0], high = points[0];
  for (const glm::vec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // The share of each pixel is determined by its nearest piece; joints are therefore not counted twice.
  const glm::ivec2 first(glm::floor(low - width - 1.0f)), last(glm::ceil(high + width + 1.0f));
  const glm::ivec2 size = last - first + 1;
  std::vector<float> share(std::size_t(size.x) * std::size_t(size.y), 0);
  for (std::size_t k = 1; k < points.size(); ++k) {
    const glm::vec2 a = points[k - 1], b = points[k];
    const glm::ivec2 from(glm::floor(glm::min(a, b) - width - 1.0f)),
        to(glm::ceil(glm::max(a, b) + width + 1.0f));
    for (int y = std::max(from.y, first.y); y <= std::min(to.y, last.y); ++y) {
      for (int x = std::max(from.x, first.x); x <= std::min(to.x, last.x); ++x) {
        const float d = distance_to_segment({float(x) + 0.5f, float(y) + 0.5f}, a, b);
        float& s = share[std::size_t(y - first.y) * std::size_t(size.x) + std::size_t(x - first.x)];
        s = std::max(s, glm::clamp(width / 2 + 0.5f - d, 0.0f, 1.0f));
      }
    }
  }
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const float s = share[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
      if (s > 0) blend(picture, first.x + x, first.y + y, color, s);
    }
  }
}

void draw_dot(BytePicture& picture, glm::vec2 at, float size, ByteColor color, float share) {
  constexpr ByteColor kRim{15, 15, 18};
  const float radius = size / 2;
  for (int y = int(at.y - radius) - 2; y <= int(at.y + radius) + 2; ++y) {
    for (int x = int(at.x - radius) - 2; x <= int(at.x + radius) + 2; ++x) {
      const float d = glm::distance(at, glm::vec2(float(x) + 0.5f, float(y) + 0.5f));
      blend(picture, x, y, kRim, share * glm::clamp(radius + 1.5f - d, 0.0f, 1.0f));
      blend(picture, x, y, color, share * glm::clamp(radius + 0.5f - d, 0.0f, 1.0f));
    }
  }
}

float text_width(const std::string& text, int pixels) {
  return for_each_glyph(text, pixels, [](const FT_GlyphSlotRec&, float) {});
}

void draw_text(BytePicture& picture, glm::vec2 baseline, const std::string& text, int pixels,
               ByteColor color) {
  for_each_glyph(text, pixels, [&](const FT_GlyphSlotRec& glyph, float pen) {
    const int left = int(std::lround(baseline.x + pen)) + glyph.bitmap_left;
    const int top = int(std::lround(baseline.y)) - glyph.bitmap_top;
    for (unsigned y = 0; y < glyph.bitmap.rows; ++y) {
      const unsigned char* row = glyph.bitmap.buffer + std::ptrdiff_t(y) * glyph.bitmap.pitch;
      for (unsigned x = 0; x < glyph.bitmap.width; ++x)
        if (row[x]) blend(picture, left + int(x), top + int(y), color, float(row[x]) / 255);
    }
  });
}

int label_pixels(const BytePicture& picture) {
  return std::clamp(picture.height / 24, 11, 40);
}

int smallest_label(const BytePicture& picture) {
  return std::max(9, 2 * label_pixels(picture) / 3);
}

std::string elided(const std::string& text, int pixels, float width) {
  if (text_width(text, pixels) <= width) return text;
  std::vector<std::string> letters;
  for (const char c : text) {
    const bool more = (static_cast<unsigned char>(c) & 0xc0) == 0x80 && !letters.empty();
    more ? letters.back() += c : letters.emplace_back(1, c);
  }
  for (std::size_t kept = letters.size(); kept-- > 2;) {
    std::string shorter;
    for (std::size_t k = 0; k < (kept + 1) / 2; ++k) shorter += letters[k];
    shorter += "\u2026";
    for (std::size_t k = letters.size() - kept / 2; k < letters.size(); ++k) shorter += letters[k];
    if (text_width(shorter, pixels) <= width) return shorter;
  }
  return "\u2026";
}

void draw_label(BytePicture& picture, const std::string& words, Corner corner, int most) {
  if (most <= 0) most = picture.width;
  const int smallest = smallest_label(picture);
  int pixels = label_pixels(picture);
  while (pixels > smallest && int(text_width(words, pixels)) + pixels > most) --pixels;
  const int pad = pixels / 2, height = 2 * pixels;
  const std::string text = elided(words, pixels, float(most - 2 * pad));
  const int width = int(std::ceil(text_width(text, pixels))) + 2 * pad;
  const int left = corner == Corner::left ? 0 : picture.width - width;
  fill(picture, {left, picture.height - height}, {width, height}, {0, 0, 0}, 0.55f);
  draw_text(picture, {float(left + pad), float(picture.height - height) + 1.35f * float(pixels)}, text,
            pixels);
}

}  // namespace brdf::render
