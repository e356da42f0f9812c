// The lookup-texture article's tables: Cook-Torrance baked over (n.h, n.l) for n = 1.5, m = 0.3 under h = n,
// hence l.h = n.l = n.v.
#pragma once

#include <cstddef>
#include <vector>

#include "render/picture/picture.h"

namespace brdf {
namespace render {

inline constexpr int kLookupSize = 512;
inline constexpr double kLookupIndex = 1.5, kLookupWidth = 0.3;

// What a table holds at x = n.h, y = n.l, always clamped to [0, 1].
enum class LookupFactor {
  product,       // F D G / (n.v): what is rendered; f_r cos_i = product / pi
  fresnel,       // F at l.h = y
  distribution,  // Beckmann's D, times pi/4
  shadowing,     // G of V-cavities = min(1, 2 n.h)
  reciprocal,    // 1 / (n.v)
  power,         // (n.h)^20, the table of "Phong" beside it
};

// size x size values at texel centres, rows from y = 0 upwards. as_coded: Fresnel with the article's slip, (g
// - c) (g - c) / (g + c) * (g + c).
std::vector<float> lookup_table(LookupFactor factor, bool as_coded, int size = kLookupSize);
// How the renderer stores and reads the product's table; by default as the article does.
struct LookupTexture {
  int size = kLookupSize;
  int bits = 8;  // 8 and 16: integers that hold [0, 1]; 32: floats
  bool bilinear = true;
};
// The product's table in the texture's bits.
std::vector<std::byte> lookup_texels(const LookupTexture& texture, bool as_coded);

// The same as a picture, y upwards.
BytePicture lookup_picture(LookupFactor factor, bool as_coded);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 6> kNames<render::LookupFactor>{
    "product", "fresnel", "distribution", "shadowing", "reciprocal", "power"};

}  // namespace brdf
