// Tests lookup tables: against published values, against a quadrature of this file, at random places, and in
// the furnace with energy compensation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "brdf/integrals.h"
#include "brdf/random.h"
#include "brdf/targets/three_table.h"
#include "interop/lookup_table.h"
#include "io/files/error.h"
#include "io/material/settings.h"
#include "tests/thorough.h"

namespace brdf::interop {
namespace {

using ::testing::HasSubstr;

Material lobe(const std::string& form, const std::vector<std::string>& set = {}) {
  return io::choose_material({.form = form, .set = set});
}
LookupTable table_of(const char* form, TableKind kind, const char* layout) {
  return lookup_table(lobe(form), kind, *find_table_layout(layout));
}

// Scale and bias of GGX with Smith's correlated masking, by the midpoint rule over the half vector's slope
// distribution.
std::pair<double, double> split_sum(double cosine, double alpha) {
  constexpr int kRings = 1500, kTurns = 400;
  const double sine = std::sqrt(1 - cosine * cosine);
  double scale = 0, bias = 0;
  const auto lambda = [&](double z) { return (std::sqrt(1 + alpha * alpha * (1 / (z * z) - 1)) - 1) / 2; };
  for (int r = 0; r < kRings; ++r)
    for (int t = 0; t < kTurns; ++t) {
      const double u = (r + 0.5) / kRings, phi = kPi * (t + 0.5) / kTurns;
      const double h_z = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u)), h_s = std::sqrt(1 - h_z * h_z);
      const double c = sine * h_s * std::cos(phi) + cosine * h_z;  // wo.h
      const double i_z = 2 * c * h_z - cosine;
      if (c <= 0 || i_z <= 0) continue;
      const double g = 1 / (1 + lambda(cosine) + lambda(i_z));
      const double weight = g * c / (cosine * h_z) / (double(kRings) * kTurns), rise = std::pow(1 - c, 5);
      scale += weight * (1 - rise), bias += weight * rise;
    }
  return {scale, bias};
}

TEST(LookupTables, TexelsEqualAQuadratureOfTheFormula) {
  const LookupTable table = table_of("cook_torrance", TableKind::dfg, "unreal");
  ASSERT_EQ(table.channels, (std::vector<std::string>{"scale", "bias"}));
  for (const auto& [x, y] : {std::pair{4u, 31u}, {10u, 20u}, {64u, 8u}, {127u, 31u}, {40u, 15u}}) {
    const double cosine = (x + 0.5) / 128, roughness = (y + 0.5) / 32;
    const auto [scale, bias] = split_sum(cosine, roughness * roughness);
    EXPECT_NEAR(table.texels[0][y * 128 + x], scale, 1e-3) << x << ' ' << y;
    EXPECT_NEAR(table.texels[1][y * 128 + x], bias, 1e-3) << x << ' ' << y;
  }
}

TEST(LookupTables, TheTableOfThreeHasItsPublishedValues) {
  const LookupTable table = table_of("cook_torrance", TableKind::dfg, "three");
  ASSERT_EQ(table.width, kThreeSide);
  EXPECT_NEAR(table.texels[1][0], 0.852, 2e-3);  // (1 - 1/32)^5 within the texel's small width
  double worst = 0, sum = 0;
  for (std::size_t k = 0; k < kThreeAlbedo.size(); ++k) {
    const double difference = std::abs(table.texels[0][k] + table.texels[1][k] - kThreeAlbedo[k] * 1e-4);
    worst = std::max(worst, difference), sum += difference;
  }
  EXPECT_LT(worst, 0.016);  // the error of the published table (brdf/targets/three_table.h)
  EXPECT_GT(worst, 0.010);
  EXPECT_LT(sum / double(kThreeAlbedo.size()), 1e-3);
}

TEST(LookupTables, LayoutsDifferAsTheirProgramsDo) {
  const LookupTable filament = table_of("cook_torrance", TableKind::dfg, "filament");
  EXPECT_EQ(filament.channels, (std::vector<std::string>{"bias", "white"}));
  // The first row of Filament has roughness 1, and white is scale + bias.
  const TableFunction function(lobe("cook_torrance"), TableKind::dfg, false);
  const auto rough = function.directional(63.5 / 128, 1);
  EXPECT_NEAR(filament.texels[1][63], rough.values[0] + rough.values[1], 1e-5);
  EXPECT_NEAR(filament.texels[0][63], rough.values[1], 1e-5);
  // The second row, too: the coordinate is one texel high.
  const auto second = function.directional(63.5 / 128, std::pow(127.5 / 128, 2));
  EXPECT_NEAR(filament.texels[0][128 + 63], second.values[1], 1e-5);
  if (!thorough()) return;
  const LookupTable unity = table_of("cook_torrance", TableKind::dfg, "unity");
  // Unity's axis is the root of the cosine, with 0 and 1 at the outer texels.
  const auto corner = function.directional(1, 1);
  EXPECT_NEAR(unity.texels[1].back(), corner.values[0] + corner.values[1], 1e-5);
  const auto inner = function.directional(std::pow(20 / 63.0, 2), std::pow(30 / 63.0, 2));
  EXPECT_NEAR(unity.texels[0][30 * 64 + 20], inner.values[1], 1e-5);
}

TEST(LookupTables, NoRandomPlaceIsReadWorseThanStated) {
  Random random(5);
  const std::tuple<const char*, TableKind, const char*> tables[] = {
      {"cook_torrance", TableKind::dfg, "unreal"},
      {"cook_torrance", TableKind::albedo, "brdf"},
      {"ward_bounded", TableKind::albedo, "unity"},
      {"cook_torrance_beckmann", TableKind::dfg, "three"}};
  for (std::size_t t = 0; t < std::size(tables); t += thorough() ? 1 : 3) {
    const auto& [form, kind, name] = tables[t];
    const LookupTable table = table_of(form, kind, name);
    const TableFunction function(lobe(form), kind, table.layout->bias_first);
    EXPECT_EQ(table.not_converged, 0u) << form;
    EXPECT_LT(table.texel_bound, 1.1e-5) << form;
    double worst = 0;
    const int places = thorough() ? 10'000 : 3'000;
    for (int k = 0; k < places; ++k) {
      const double x = random.uniform(), y = random.uniform();
      const TablePlace place = place_at(*table.layout, x, y);
      const auto exact = function.directional(place.cosine, place.alpha);
      for (std::size_t c = 0; c < exact.values.size(); ++c)
        worst = std::max(worst, std::abs(table.read(c, x, y) - exact.values[c]) - exact.bound);
    }
    EXPECT_LE(worst, table.reading.difference) << form << ' ' << name;
    EXPECT_GT(worst, table.reading.difference / 30) << form << ' ' << name;
  }
}

// f + (1 - E(o)) (1 - E(i))/(pi (1 - mean)), integrated over the incident light.
TEST(LookupTables, TheFurnaceClosesWithTheAlbedoTable) {
  const LookupTable table = table_of("cook_torrance", TableKind::albedo, "brdf");
  const TableFunction function(lobe("cook_torrance"), TableKind::albedo, false);
  double worst = 0, grazing = 0, without = 0;
  for (const double roughness : {0.02, 0.05, 0.1, 0.15, 0.2, 0.33, 0.5, 0.71, 0.9, 1.0})
    for (const double cosine : {0.003, 0.03, 0.05, 0.1, 0.23, 0.5, 0.77, 1.0}) {
      const auto albedo = [&](double c) { return table.read(0, std::sqrt(c), roughness); };
      const double mean = table.read(1, 0.5, roughness);
      double lost = 0;  // integral of (1 - E(i)) cos_i
      constexpr int kSteps = 2000;
      for (int k = 0; k < kSteps; ++k) {
        const double c = (k + 0.5) / kSteps;
        lost += 2 * kPi * (1 - albedo(c)) * c / kSteps;
      }
      const double single = function.directional(cosine, roughness * roughness).values[0];
      const double whole = single + (1 - albedo(cosine)) * lost / (kPi * (1 - mean));
      double& largest = cosine < 0.03 ? grazing : worst;
      largest = std::max(largest, std::abs(whole - 1));
      without = std::max(without, 1 - single);
    }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(worst, 5e-4);
  // Nearer to the horizon the bilinear reading of narrow lobes is wrong.
  EXPECT_NEAR(grazing, 6.8e-3, 5e-4);
  EXPECT_GT(without, 0.3);
}

TEST(LookupTables, FormsWithoutF0HaveOneChannel) {
  EXPECT_EQ(table_of("ward_bounded", TableKind::dfg, "unity").channels, std::vector<std::string>{"albedo"});
  const LookupTable lambert = table_of("lambert", TableKind::dfg, "three");
  EXPECT_EQ(lambert.width * lambert.height, 16u);  // no roughness
  for (const double value : lambert.texels[0]) EXPECT_NEAR(value, 0.5, 1e-12);
}

TEST(LookupTables, AParameterCalledRoughnessFollowsTheAxis) {
  const LookupTable table = table_of("oren_nayar_energy", TableKind::dfg, "three");
  ASSERT_EQ(table.width, 16u);
  Material same = lobe("oren_nayar_energy");
  same.terms[0].shape[0][0] = 10.5 / 16;
  const AlbedoResult exact = directional_albedo(same.terms[0], 0, radians(std::acos(3.5 / 16)), {}, {});
  EXPECT_NEAR(table.texels[0][3 * 16 + 10], exact.value, 1e-5);
  EXPECT_GT(std::abs(table.texels[0][3 * 16 + 2] - exact.value), 1e-4);
}

TEST(LookupTables, NumbersOfFormatsAreRoundedToTheNearest) {
  EXPECT_EQ(stored(1.0 / 3, TableFormat::half), 0.333251953125);
  EXPECT_EQ(stored(1, TableFormat::half), 1);
  EXPECT_EQ(stored(3e-8, TableFormat::half),
            std::ldexp(1.0, -24) * std::nearbyint(3e-8 * std::ldexp(1.0, 24)));
  EXPECT_EQ(stored(0.5, TableFormat::bits8), 128.0 / 255);
  EXPECT_EQ(stored(1.2, TableFormat::bits10), 1);
}

TEST(LookupTables, NoBoundIsStatedForIntegralsThatDidNotConverge) {
  LookupTable table{find_table_layout("three"), 16, 16, {"albedo"}};
  table.texel_bound = 1e-6;
  EXPECT_THAT(sentences(table)[2], HasSubstr("integrated within 1e-06"));
  table.not_converged = 3;
  table.reading.unknown = 5;
  table.reading.difference = -1;
  const std::vector<std::string> said = sentences(table);
  EXPECT_THAT(said, ::testing::Each(::testing::Not(HasSubstr("within"))));
  EXPECT_THAT(said, ::testing::Each(::testing::Not(HasSubstr("largest difference"))));
  EXPECT_THAT(said[2], HasSubstr("the integrals of 3 did not converge"));
  EXPECT_THAT(said[3], HasSubstr("unknown at 5 places"));
  EXPECT_TRUE(to_json(table)["texel_bound"].is_null());
}

TEST(LookupTables, MaterialsThatNoTableHoldsAreRefused) {
  const auto refusal = [](const Material& material) -> std::string {
    try {
      lookup_table(material, TableKind::dfg, *find_table_layout("three"));
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(lobe("ward", {"alpha_x=0.1", "alpha_y=0.2"})), HasSubstr("anisotropic"));
  Material sum = lobe("ward");
  sum.terms.push_back(sum.terms[0]);
  EXPECT_THAT(refusal(sum), HasSubstr("sum of terms"));
  Material coloured = lobe("ward", {"kd=0.1,0.2,0.3"});
  coloured.terms[0].shape = {{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}};
  EXPECT_THAT(refusal(coloured), HasSubstr("one shape"));
}

}  // namespace
}  // namespace brdf::interop
