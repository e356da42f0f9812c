// The tables of the lookup-texture article: Cook-Torrance tabulated over (n.h, n.l) for n = 1.5, m = 0.3
// under the assumption h = n, hence l.h = n.l = n.v.
#pragma once

#include <cstddef>
#include <vector>

#include "render/picture/picture.h"

namespace brdf {
namespace render {

inline constexpr int kLookupSize = 512;
inline constexpr double kLookupIndex = 1.5, kLookupWidth = 0.3;

// Content of a table at x = n.h, y = n.l, always clamped to [0, 1].
enum class LookupFactor {
  // F D G / (n.v), the table that is rendered; f_r cos_i = product / pi.
  product,
  fresnel,       // F at l.h = y
  distribution,  // Beckmann's D, times pi/4
  shadowing,     // G of V-cavities = min(1, 2 n.h)
  reciprocal,    // 1 / (n.v)
  power,         // (n.h)^20, the article's separate table of "Phong"
};

// Returns size x size values at texel centres, rows from y = 0 upwards. as_coded: Fresnel with the
// article's error, (g - c) (g - c) / (g + c) * (g + c).
std::vector<float> lookup_table(LookupFactor factor, bool as_coded, int size = kLookupSize);
// Storage and filtering of the product's table in the renderer. The defaults are those of the article.
struct LookupTexture {
  int size = kLookupSize;
  // 8 and 16: integers that represent [0, 1]; 32: floats.
  int bits = 8;
  bool bilinear = true;
};
// Returns the product's table with the bits of the texture.
std::vector<std::byte> lookup_texels(const LookupTexture& texture, bool as_coded);

// Returns a table as a picture, y upwards.
BytePicture lookup_picture(LookupFactor factor, bool as_coded);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 6> kNames<render::LookupFactor>{
    "product", "fresnel", "distribution", "shadowing", "reciprocal", "power"};

}  // namespace brdf
