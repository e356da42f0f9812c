// Tests tables of linearly transformed cosines against the published table of GGX, against a quadrature of
// this file, and by their own statements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/integrals.h"
#include "interop/cosine_transform.h"
#include "io/files/error.h"
#include "io/material/settings.h"

namespace brdf::interop {
namespace {

using ::testing::HasSubstr;

Material chosen_form(const std::string& form, const std::vector<std::string>& set = {}) {
  return io::choose_material({.form = form, .set = set});
}

// The lobe of GGX with f0 = 1 and without a diffuse part.
Material white_ggx(double alpha) {
  return chosen_form("cook_torrance", {"kd=0", "ks=1", "f0=1", "alpha=" + std::to_string(alpha)});
}

double share_at(const CosineTransform& transform, std::size_t x, std::size_t y) {
  const double u = double(x) / 63, v = double(y) / 63;
  return misplaced_share(chosen_form("cook_torrance"), transform, 1 - v * v, u * u);
}

const CosineTable& table_of_ggx() {
  static const CosineTable table = cosine_table(chosen_form("cook_torrance"));
  return table;
}

// Half the integral of the difference of the densities, by the midpoint rule over the whole sphere.
double midpoint_share(const Material& material, const CosineTransform& transform, double cosine) {
  constexpr int kRings = 900, kTurns = 600;
  const Vec3<double> wo{std::sqrt(1 - cosine * cosine), 0, cosine};
  DirectionArrays<double> pairs(std::size_t(kRings) * kTurns);
  for (int r = 0; r < kRings; ++r)
    for (int t = 0; t < kTurns; ++t) {
      const double z = 1 - 2 * (r + 0.5) / kRings, phi = 2 * kPi * (t + 0.5) / kTurns,
                   s = std::sqrt(1 - z * z);
      pairs.set(std::size_t(r * kTurns + t), {s * std::cos(phi), s * std::sin(phi), z}, wo);
    }
  std::vector<double> f(pairs.size());
  eval_cos_batch(material.terms[0], 0, pairs.view(), f.data());
  double total = 0, difference = 0;
  for (const double value : f) total += value;
  const double node = 4 * kPi / double(f.size());
  for (std::size_t k = 0; k < f.size(); ++k)
    difference += std::abs(f[k] / (total * node) - transform.density(pairs.view().wi(k))) * node;
  return difference / 2;
}

// Texels of the table that selfshadow/ltc_code publishes and three.js 0.187 carries as LTC_MAT_1. That table
// minimises another measure, so that a share may be smaller there by a little.
void expect_no_more_misplaced_than_published() {
  struct Published {
    std::size_t x, y;
    CosineTransform transform;
    double share;
  };
  for (const Published& p : std::vector<Published>{
           {10, 0, {1, 0, 0, 0.0503999}, 0.00063},
           {30, 0, {1, 0, 0, 0.438197}, 0.016},
           {63, 0, {1, 0, 0, 1.12813}, 0.015},
           {8, 20, {0.80861, -0.0126855, 0.393407, 0.0260803}, 0.00061},
           {20, 30, {0.602861, -0.0962284, 0.492684, 0.1224}, 0.02},
           {40, 40, {0.632419, -0.287924, 0.584496, 0.454357}, 0.11},
           {63, 40, {0.999984, 0.000461885, -0.0000772859, 1.18099}, 0.023},
           {5, 50, {0.137012, -0.00433103, 0.343868, 0.00172744}, 0.0061},
           {16, 55, {0.0609109, -0.0295661, 0.241557, 0.00939127}, 0.12},
           {33, 60, {0.165809, -0.136453, 0.361094, 0.131928}, 0.3},
           {60, 62, {0.959656, -0.124099, 0.135909, 1.3956}, 0.093},
           {2, 10, {0.9503, -0.000438299, 0.217451, 0.00191543}, 2.2e-5},
       }) {
    EXPECT_NEAR(share_at(p.transform, p.x, p.y), p.share, 1e-4 + 0.05 * p.share) << p.x << ' ' << p.y;
    const double own = share_at(table_of_ggx().transforms[p.y * 64 + p.x], p.x, p.y);
    EXPECT_LT(own, 1.05 * p.share + 1e-4) << p.x << ' ' << p.y;
    EXPECT_GT(own, 0.4 * p.share - 1e-4) << p.x << ' ' << p.y;
  }
}

void expect_axes_of_the_layout() {
  // Along the normal the inverse is diagonal with about twice alpha as the last element; towards grazing
  // angles the lobe leans away from the viewer.
  for (const std::size_t k : {4u, 10u, 20u}) {
    const CosineTransform& m = table_of_ggx().transforms[k];
    const double alpha = double(k * k) / (63.0 * 63.0);
    EXPECT_NEAR(m.w / (2 * alpha), 1, 0.01);
    EXPECT_NEAR(m.y, 0, 2e-3);
  }
  const CosineTransform& leaning = table_of_ggx().transforms[40 * 64 + 16];
  const double s = 40.0 / 63, cosine = 1 - s * s, sine = std::sqrt(1 - cosine * cosine);
  EXPECT_GT(leaning.density({-sine, 0, cosine}), 100 * leaning.density({sine, 0, cosine}));
}

void expect_shares_of_a_quadrature() {
  for (const auto& [x, y] : {std::pair{30u, 10u}, {40u, 40u}, {63u, 30u}, {50u, 55u}}) {
    const double u = x / 63.0, v = y / 63.0, cosine = 1 - v * v;
    const CosineTransform& m = table_of_ggx().transforms[y * 64 + x];
    EXPECT_NEAR(share_at(m, x, y), midpoint_share(white_ggx(u * u), m, cosine), 2e-3) << x << ' ' << y;
  }
  EXPECT_GT(table_of_ggx().misplaced.value, table_of_ggx().misplaced_median);
  EXPECT_GT(table_of_ggx().between.value, table_of_ggx().misplaced.value);
  EXPECT_LE(table_of_ggx().between.value, 1);
}

void expect_kept_cosine_and_albedo() {
  const CosineTable lambert = cosine_table(chosen_form("lambert"), 8);
  for (const CosineTransform& m : lambert.transforms) {
    EXPECT_NEAR(m.x, 1, 4e-4);
    EXPECT_NEAR(m.y, 0, 4e-4);
    EXPECT_NEAR(m.z, 0, 4e-4);
    EXPECT_NEAR(m.w, 1, 4e-4);
  }
  EXPECT_LT(lambert.misplaced.value, 1e-4);
  EXPECT_EQ(lambert.bias[5], 0);
  const double v = 40.0 / 63, u = 30.0 / 63;
  const AlbedoResult white = directional_albedo(white_ggx(u * u).terms[0], 0, radians(std::acos(1 - v * v)),
                                                {}, {.fixed = Fixed::viewer});
  EXPECT_NEAR(table_of_ggx().white[40 * 64 + 30], white.value, 1e-5);
  EXPECT_GT(table_of_ggx().bias[60 * 64 + 10], table_of_ggx().bias[10 * 64 + 10]);
}

// One test, because every test is a process of its own, and the table takes seconds.
TEST(CosineTransforms, OfGgxMisplaceNoMoreLightThanThePublishedTable) {
  expect_no_more_misplaced_than_published();
  expect_axes_of_the_layout();
  expect_shares_of_a_quadrature();
  expect_kept_cosine_and_albedo();
}

TEST(CosineTransforms, RefuseWhatATableCannotHold) {
  try {
    cosine_table(chosen_form("ward", {"alpha_x=0.1", "alpha_y=0.3"}), 4);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("anisotropic"));
  }
}

TEST(CosineTransforms, CountIntegralsThatDidNotConverge) {
  CosineTable table{2, std::vector<CosineTransform>(4), {}, {}, "a lobe"};
  EXPECT_THAT(sentences(table)[2], HasSubstr("integrated within"));
  table.not_converged = 3;
  EXPECT_THAT(sentences(table)[2], HasSubstr("of 3 texels did not converge"));
  EXPECT_THAT(sentences(table)[2], ::testing::Not(HasSubstr("integrated within")));
  EXPECT_TRUE(to_json(table)["albedo_bound"].is_null());
}

}  // namespace
}  // namespace brdf::interop
