// The accuracy contract: largest error of every form in float and double against 50 digits, over the grid of
// validate/extremes.h, asserted on both sides.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include "brdf/material.h"
#include "brdf/microfacet.h"
#include "validate/exact.h"
#include "validate/extremes.h"
#include "validate/numerics.h"

namespace brdf::validate {
namespace {

struct Errors {
  double body, faint, tail;  // f >= 1e-6, >= 1e-12, >= 1e-30 of the lobe's peak
};
struct Contract {
  std::string_view form;
  Errors in_float, in_double;
};
// Bounds about 15 % above the measured error. The goal: body and faint 5e-6 | 1e-14, tails 5e-5 | 5e-14.
const std::vector<Contract> kContracts{
    {"lambert", {4.7e-8, 0, 0}, {5.2e-17, 0, 0}},
    {"oren_nayar", {2.5e-7, 0, 0}, {4.3e-16, 4e-16, 0}},
    {"oren_nayar_full", {4.4e-7, 1.2e-7, 0}, {7e-16, 7e-16, 2.4e-16}},
    {"oren_nayar_energy", {2.8e-7, 2.6e-7, 4.7e-8}, {4.5e-16, 3.1e-16, 2.5e-16}},
    {"oren_nayar_as_coded", {3e-7, 2.2e-7, 0}, {5.6e-16, 4.1e-16, 4.6e-16}},
    {"phong", {1.7e-6, 2.7e-6, 7.2e-6}, {3e-15, 6.6e-15, 1.2e-14}},
    {"phong_unnormalised", {1.8e-6, 2.6e-6, 7.3e-6}, {3.1e-15, 6.5e-15, 1.3e-14}},
    {"phong_classic", {1.8e-6, 2.8e-6, 7.3e-6}, {3e-15, 6.2e-15, 1.3e-14}},
    {"phong_as_coded", {1.2e-7, 0, 0}, {2.2e-16, 0, 0}},
    {"blinn_phong", {1.5e-6, 3.3e-6, 7.9e-6}, {3.9e-15, 5e-15, 1.6e-14}},
    {"blinn_phong_n8", {1.4e-6, 3.3e-6, 7.8e-6}, {3.8e-15, 5e-15, 1.6e-14}},
    {"blinn_phong_unnormalised", {1.6e-6, 3.3e-6, 7.8e-6}, {3.8e-15, 4.9e-15, 1.6e-14}},
    {"blinn_phong_as_coded", {5.4e-7, 0, 0}, {8.2e-16, 0, 0}},
    {"ward", {1.6e-6, 3.2e-6, 1.8e-5}, {2.8e-15, 5.5e-15, 1.9e-14}},
    {"ward_duer", {1.6e-6, 3.2e-6, 1.8e-5}, {2.5e-15, 5.4e-15, 1.9e-14}},
    {"ward_bounded", {1.4e-6, 3.2e-6, 1.8e-5}, {2.9e-15, 5.6e-15, 1.8e-14}},
    {"ward_as_coded", {1.6e-6, 3.3e-6, 1.4e-5}, {2.6e-15, 5.6e-15, 1.9e-14}},
    {"cook_torrance", {1.8e-6, 1.4e-6, 4.9e-6}, {3.1e-15, 1.2e-15, 5.5e-15}},
    {"cook_torrance_beckmann", {1.6e-6, 3.2e-6, 1.8e-5}, {2.9e-15, 5.3e-15, 1.9e-14}},
    {"cook_torrance_dielectric", {1.9e-6, 1.7e-6, 5.3e-6}, {3.8e-15, 2.3e-15, 1.1e-14}},
    {"cook_torrance_vcavity", {2.4e-6, 3.7e-6, 1.9e-5}, {4e-15, 5.6e-15, 1.9e-14}},
    {"cook_torrance_1982", {1.5e-6, 3.2e-6, 1.8e-5}, {2.9e-15, 5.5e-15, 1.9e-14}},
    {"cook_torrance_schlick_ggx", {1.7e-6, 9.4e-7, 2.3e-6}, {3.3e-15, 1.7e-15, 2.5e-15}},
    {"cook_torrance_as_printed", {1.7e-6, 1.4e-6, 2.5e-6}, {4e-15, 2.4e-15, 2.6e-15}},
    {"cook_torrance_as_coded", {2.4e-6, 2.5e-6, 0}, {7.5e-15, 5.9e-15, 0}},
};

void expect_close_below(double error, double bound, const NumericsRow& row) {
  EXPECT_LE(error, bound) << row.form << ' ' << row.scalar << " at " << row.where.parameters;
  EXPECT_GE(error, bound / 2) << row.form << ' ' << row.scalar << " is better than stated";
}

class Accuracy : public ::testing::TestWithParam<Contract> {};

TEST_P(Accuracy, IsWhatTheContractStates) {
  const Contract& contract = GetParam();
  const auto form = find_form(contract.form);
  ASSERT_TRUE(form);
  for (const NumericsRow& row : measure_numerics(*form)) {
    const Errors& bounds = row.scalar == "float" ? contract.in_float : contract.in_double;
    expect_close_below(row.max_error, bounds.body, row);
    expect_close_below(row.faint_error, bounds.faint, row);
    expect_close_below(row.tail_error, bounds.tail, row);
    EXPECT_TRUE(meets_budget(row)) << row.form << ' ' << row.scalar;
    EXPECT_EQ(row.nan, 0u);
    EXPECT_EQ(row.inf, 0u);
    EXPECT_EQ(row.negative > 0, row.form == "oren_nayar_full");
    EXPECT_LT(double(row.as_stored), 0.07 * double(row.count)) << "the grid's directions are unit vectors";
  }
}

INSTANTIATE_TEST_SUITE_P(EveryForm, Accuracy, ::testing::ValuesIn(kContracts),
                         [](const auto& param) { return std::string(param.param.form); });

TEST(AccuracyContracts, CoverTheCatalogue) {
  ASSERT_EQ(kContracts.size(), kFormCount);
  for_each_form([](auto form) {
    EXPECT_TRUE(std::any_of(kContracts.begin(), kContracts.end(), [&](const Contract& c) {
      return c.form == form.name;
    })) << form.name;
  });
}

// "// Error: 1.2e-16, in float 3.4e-8." above every form's struct.
TEST(AccuracyContracts, AreStatedInTheHeaders) {
  for (const Contract& contract : kContracts) {
    const FormInfo& form = info(*find_form(contract.form));
    std::ifstream in(std::string(BRDF_SOURCE_DIR "/libbrdf/brdf/forms/") + std::string(form.family) + ".h");
    std::string previous, line;
    while (std::getline(in, line) && !line.starts_with("struct " + std::string(form.name) + " "))
      previous = line;
    double in_double = 0, in_float = 0;
    EXPECT_EQ(std::sscanf(previous.c_str(), "// Error: %lf, in float %lf.", &in_double, &in_float), 2)
        << form.name;
    EXPECT_EQ(in_double, contract.in_double.body) << form.name;
    EXPECT_EQ(in_float, contract.in_float.body) << form.name;
  }
}

// volatile: g++ 12 at -O2 drops the rounding of a pair that goes to float and back.
template <class T>
Vec3<T> rounded(const Vec3<double>& w) {
  const auto one = [](double x) {
    volatile T y = T(x);
    return T(y);
  };
  return {one(w.x), one(w.y), one(w.z)};
}

// The exponent's rounding errors are carried along (brdf/two_part.h): the goal holds on any directions, not
// only on the grid's. Against W, at the vectors as stored, down to 1e-12 of the peak.
template <class T, class W>
double worst_gaussian_error() {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit;
  W worst = 0;
  for (int k = 0; k < 200000; ++k) {
    const Roughness<T> a{T(std::pow(10, -4 * unit(random))), T(std::pow(10, -4 * unit(random)))};
    const double radius = std::sqrt(10 + 17.6 * unit(random)), azimuth = 2 * kPi * unit(random);
    const double x = double(a.alpha_x) * radius * std::cos(azimuth),
                 y = double(a.alpha_y) * radius * std::sin(azimuth), length = std::sqrt(x * x + y * y + 1);
    const Vec3<double> i = direction(1.5 * unit(random), 2 * kPi * unit(random)),
                       h{x / length, y / length, 1 / length}, o = h * (2 * dot(i, h)) - i;
    if (o.z < 1e-3) continue;
    const Geometry<T> g = geometry(rounded<T>(i), rounded<T>(o));
    const W tan_x = (W(g.wi.x) + W(g.wo.x)) / (W(g.wi.z) + W(g.wo.z)) / W(a.alpha_x),
            tan_y = (W(g.wi.y) + W(g.wo.y)) / (W(g.wi.z) + W(g.wo.z)) / W(a.alpha_y);
    const W exponent = tan_x * tan_x + tan_y * tan_y;
    if (exponent > W(27.6)) continue;
    worst =
        std::max(worst, std::abs(W(slope_gaussian(a, g, T(1) / square(g.h.z))) / std::exp(-exponent) - 1));
  }
  return double(worst);
}
TEST(SlopeGaussian, MeetsTheGoalOnRandomDirections) {
  const double in_float = worst_gaussian_error<float, double>(),
               in_double = worst_gaussian_error<double, long double>();
  EXPECT_LE(in_float, 5e-6);
  EXPECT_GE(in_float, 2.5e-6);
  EXPECT_LE(in_double, 1e-14);
  EXPECT_GE(in_double, 5e-15);
}

// What rounding the directions to float does to GGX at 60 degrees within 1.5 widths of the peak.
double cost_of_storing(double alpha) {
  const Roughness<double> a{alpha, alpha};
  const auto lobe = [&](const Vec3<double>& wi, const Vec3<double>& wo) {
    const Geometry<double> g = geometry(wi, wo);
    return quotient(d_ggx(a, g), v_smith_ggx(a, g));
  };
  const auto stored = [](const Vec3<double>& w) {
    const Vec3<float> r = rounded<float>(w);
    const Vec3<double> v{r.x, r.y, r.z};
    return v * (1 / std::sqrt(dot(v, v)));
  };
  double worst = 0;
  for (int k = 0; k < 20000; ++k) {
    const Vec3<double> wi = direction(kPi / 3, 0.37 * k);
    const double slope = alpha * 1.5 * (k % 97) / 96.0, c = 1 / std::sqrt(1 + slope * slope);
    const Vec3<double> h{slope * std::cos(1.3 * k) * c, slope * std::sin(1.3 * k) * c, c};
    const Vec3<double> wo = h * (2 * dot(wi, h)) - wi;
    worst = std::max(worst, std::abs(lobe(stored(wi), stored(wo)) / lobe(wi, wo) - 1));
  }
  return worst;
}
TEST(StoredDirections, CostByThemselves) {
  EXPECT_NEAR(cost_of_storing(1e-4), 1.4e-3, 0.2e-3);
  EXPECT_NEAR(cost_of_storing(1e-2), 1.3e-5, 0.2e-5);
}

TEST(ExtremeDirections, AreUnitVectorsToAHundredthOfAnUlp) {
  for (const Vec3<double>& wi : extreme_lights()) {
    const Vec3<float> w = nearly_unit<float>(wi);
    const Vec3<Exact> v{Exact(w.x), Exact(w.y), Exact(w.z)};
    EXPECT_LT(double(Exact(abs(dot(v, v) - 1))), 1.2e-9);
    EXPECT_NEAR(w.x, wi.x, 1.3e-4 * std::abs(wi.x) + 1e-30);
  }
}

// |h|/2 keeps the half-angle's cosine near grazing, for directions as they are stored; wi.h/|h| does not,
// because stored vectors are not exactly unit.
template <class T>
std::pair<double, double> half_angle_errors() {
  double ours = 0, dot_product = 0;
  for (int k = 1; k < 400; ++k) {
    const double theta = (89.9 + 0.09 * k / 400) * kPi / 180;
    const Vec3<double> i = direction(theta, 0.3 + 0.001 * k),
                       o = direction(theta - 1e-4, 0.3 + 0.001 * k + kPi);
    const Vec3<T> wi{T(i.x), T(i.y), T(i.z)}, wo{T(o.x), T(o.y), T(o.z)};
    const Geometry<T> g = geometry(wi, wo);
    const Exact truth = geometry(exact_direction(wi), exact_direction(wo), kMinCosine<T>).cos_d;
    const auto error = [&](T cosine) { return double(Exact(abs(Exact(cosine) / truth - 1))); };
    ours = std::max(ours, error(g.cos_d));
    dot_product = std::max(dot_product, error(dot(g.wi, g.h) / std::sqrt(g.h2)));
  }
  return {ours, dot_product};
}

TEST(HalfAngle, KeepsItsAccuracyNearGrazing) {
  const auto [in_float, dot_float] = half_angle_errors<float>();
  EXPECT_LT(in_float, 1e-3);
  EXPECT_GT(dot_float, 30 * in_float);
  const auto [in_double, dot_double] = half_angle_errors<double>();
  EXPECT_LT(in_double, 2e-12);
  EXPECT_GT(dot_double, 30 * in_double);
}

}  // namespace
}  // namespace brdf::validate
