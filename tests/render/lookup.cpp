// The lookup tables of the articles: values, clamping, and the layout of their texels.
#include "render/gpu/lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace brdf::render {
namespace {

float at(const std::vector<float>& table, double x, double y) {
  return table[std::size_t(int(y * kLookupSize) * kLookupSize + int(x * kLookupSize))];
}

TEST(Lookup, FresnelOfTheArticleAndOfItsSlip) {
  const auto exact = lookup_table(LookupFactor::fresnel, false),
             slip = lookup_table(LookupFactor::fresnel, true);
  EXPECT_NEAR(at(exact, 0.5, 0.9995), 0.04, 1e-4);
  EXPECT_NEAR(at(slip, 0.5, 0.9995), 0.25, 1e-3);
  EXPECT_NEAR(at(exact, 0.5, 0.5), 0.0892, 5e-4);
  EXPECT_NEAR(at(slip, 0.5, 0.5), 0.2653, 1e-3);
  EXPECT_EQ(at(slip, 0.5, 0), 1);  // 1.25 at grazing incidence, clamped
}

TEST(Lookup, ProductIsItsFactorsClamped) {
  const auto f = lookup_table(LookupFactor::fresnel, false),
             d = lookup_table(LookupFactor::distribution, false),
             g = lookup_table(LookupFactor::shadowing, false),
             product = lookup_table(LookupFactor::product, false);
  for (std::size_t k = 0; k < product.size(); k += 97) {
    if (d[k] >= 1) continue;  // D itself is clamped for the picture
    const double y = (double(k / kLookupSize) + 0.5) / kLookupSize;
    EXPECT_NEAR(product[k], std::min(1.0, double(f[k] * d[k] * g[k]) / y), 1e-5);
  }
}

TEST(Lookup, TexelsHoldTheTableToTheirBits) {
  const int size = 16;
  const auto table = lookup_table(LookupFactor::product, false, size);
  const auto bytes = lookup_texels({size, 8, true}, false), words = lookup_texels({size, 16, true}, false),
             floats = lookup_texels({size, 32, true}, false);
  ASSERT_EQ(bytes.size(), table.size());
  ASSERT_EQ(words.size(), 2 * table.size());
  ASSERT_EQ(floats.size(), 4 * table.size());
  for (std::size_t k = 0; k < table.size(); ++k) {
    std::uint16_t word;
    float value;
    std::memcpy(&word, &words[2 * k], 2);
    std::memcpy(&value, &floats[4 * k], 4);
    EXPECT_NEAR(float(bytes[k]) / 255, table[k], 0.501 / 255);
    EXPECT_NEAR(float(word) / 65535, table[k], 0.501 / 65535);
    EXPECT_EQ(value, table[k]);
  }
}

TEST(Lookup, PowerTableIsVerticalStripes) {
  const auto power = lookup_table(LookupFactor::power, false);
  for (int i = 0; i < kLookupSize; i += 31) {
    EXPECT_EQ(power[std::size_t(i)], power[std::size_t(400 * kLookupSize + i)]);
  }
}

}  // namespace
}  // namespace brdf::render
