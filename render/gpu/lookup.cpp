#include "render/gpu/lookup.h"

#include <algorithm>
#include <cmath>

#include "brdf/fresnel.h"
#include "brdf/microfacet.h"

namespace brdf::render {
namespace {

double distribution(double cos_h) {
  Geometry<double> g{};
  g.h = {std::sqrt(1 - cos_h * cos_h), 0, cos_h};
  g.h2 = 1;
  const auto d = d_beckmann(Roughness<double>{kLookupWidth, kLookupWidth}, g);
  return kPi / 4 * d.num / d.den;
}

double value(LookupFactor factor, bool as_coded, double cos_h, double cos_i) {
  const double f =
      as_coded ? fresnel_dielectric_as_coded(kLookupIndex, cos_i) : fresnel_dielectric(kLookupIndex, cos_i);
  const double g = std::min(1.0, 2 * cos_h);
  switch (factor) {
    case LookupFactor::product:
      return f * distribution(cos_h) * g / cos_i;
    case LookupFactor::fresnel:
      return f;
    case LookupFactor::distribution:
      return distribution(cos_h);
    case LookupFactor::shadowing:
      return g;
    case LookupFactor::reciprocal:
      return 1 / cos_i;
    case LookupFactor::power:
      return std::pow(cos_h, 20);
  }
  return 0;
}

}  // namespace

std::vector<float> lookup_table(LookupFactor factor, bool as_coded, int size) {
  std::vector<float> table;
  table.reserve(std::size_t(size) * std::size_t(size));
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      table.push_back(
          float(std::clamp(value(factor, as_coded, (i + 0.5) / size, (j + 0.5) / size), 0.0, 1.0)));
    }
  }
  return table;
}

std::vector<std::byte> lookup_texels(const LookupTexture& texture, bool as_coded) {
  const std::vector<float> table = lookup_table(LookupFactor::product, as_coded, texture.size);
  std::vector<std::byte> bytes;
  const auto add = [&](auto texel) {
    const auto begin = reinterpret_cast<const std::byte*>(&texel);
    bytes.insert(bytes.end(), begin, begin + sizeof texel);
  };
  for (const float v : table) {
    if (texture.bits == 8)
      add(std::uint8_t(std::lround(v * 255)));
    else if (texture.bits == 16)
      add(std::uint16_t(std::lround(v * 65535)));
    else
      add(v);
  }
  return bytes;
}

BytePicture lookup_picture(LookupFactor factor, bool as_coded) {
  const std::vector<float> table = lookup_table(factor, as_coded);
  BytePicture picture(kLookupSize, kLookupSize);
  for (int y = 0; y < kLookupSize; ++y) {
    for (int x = 0; x < kLookupSize; ++x) {
      const float texel = table[std::size_t((kLookupSize - 1 - y) * kLookupSize + x)];
      const auto byte = std::uint8_t(std::lround(texel * 255));
      picture.pixels[std::size_t(y * kLookupSize + x)] = {byte, byte, byte};
    }
  }
  return picture;
}

}  // namespace brdf::render
