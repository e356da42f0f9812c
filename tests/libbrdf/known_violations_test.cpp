// Known faults, asserted as facts with numeric bounds on both sides: the violations of the forms, and the
// misprints and slips of the source documents.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "brdf/forms.h"
#include "brdf/integrals.h"
#include "brdf/material.h"
#include "brdf/targets.h"
#include "tests/libbrdf/half_vector_quadrature.h"
#include "tests/thorough.h"

namespace brdf {
namespace {

using Values = std::vector<double>;

double albedo(const Reflectance& form, const Values& weights, const Values& shape, double theta,
              Fixed fixed = Fixed::light, double tolerance = 1e-8) {
  Term term = make_term(form, 1);
  term.weights[0] = weights;
  term.shape[0] = shape;
  const AlbedoResult r = directional_albedo(term, 0, degrees(theta), {}, {fixed, tolerance});
  EXPECT_TRUE(r.converged) << info(form).name << " at " << theta;
  return r.value;
}
double value(const Reflectance& form, const Values& weights, const Values& shape, const Vec3<double>& wi,
             const Vec3<double>& wo) {
  Term term = make_term(form, 1);
  term.weights[0] = weights;
  term.shape[0] = shape;
  double f = 0;
  eval(Material{{"y"}, {term}}, wi, wo, {&f, 1});
  return f;
}
// Expects the albedo to exceed 1 from the angle `theta` on, bracketed to 0.01 degrees.
void expect_albedo_crosses_one_at(const Reflectance& form, const Values& weights, const Values& shape,
                                  double theta) {
  EXPECT_LT(albedo(form, weights, shape, theta - 0.01), 1) << info(form).name;
  EXPECT_GT(albedo(form, weights, shape, theta + 0.01), 1) << info(form).name;
}

// --- Phong ------------------------------------------------------------------------------------------------

TEST(KnownViolations, PhongUnnormalisedReflectsTooMuchBelowExponent428) {
  for (double n : {0.0, 1.0, 20.0})
    EXPECT_NEAR(albedo(phong_unnormalised{}, {0, 1}, {n}, 0), 2 * kPi / (n + 2), 1e-7);
  EXPECT_GT(albedo(phong_unnormalised{}, {0, 1}, {4.28}, 0), 1);
  EXPECT_LT(albedo(phong_unnormalised{}, {0, 1}, {4.29}, 0), 1);
}

TEST(KnownViolations, PhongLosesOneMinusCosine) {
  for (double theta : {30.0, 60.0, 80.0})
    EXPECT_NEAR(albedo(phong{}, {0, 1}, {1e5}, theta), std::cos(degrees(theta).radians()), 1e-4);
}

TEST(KnownViolations, PhongAsCodedHasItsTwoAlbedos) {
  const double rho = 0.7, metallic = 0.4, f0 = 0.03 + metallic * (rho - 0.03);
  for (double theta : {0.0, 60.0, 89.0}) {
    const double c = std::cos(degrees(theta).radians());
    EXPECT_NEAR(albedo(phong_as_coded{}, {rho}, {metallic}, theta), (rho + kPi * f0 * std::pow(c, 16)) / c,
                1e-6 / c);
    EXPECT_NEAR(albedo(phong_as_coded{}, {rho}, {metallic}, theta, Fixed::viewer),
                2 * rho + f0 * 2 * kPi / 17, 1e-7);
  }
  EXPECT_GT(albedo(phong_as_coded{}, {0.5}, {0}, 30, Fixed::viewer), 1);
  EXPECT_LT(albedo(phong_as_coded{}, {0.49}, {0}, 30, Fixed::viewer), 1);
}

TEST(KnownViolations, PhongClassicIsBoundedForTheViewerOnly) {
  EXPECT_NEAR(albedo(phong_classic{}, {0, 1}, {10}, 0, Fixed::viewer), 1, 1e-7);
  EXPECT_NEAR(albedo(phong_classic{}, {0, 1}, {10}, 90, Fixed::viewer), 0.5, 1e-6);
  EXPECT_NEAR(albedo(phong_classic{}, {0, 1}, {10}, 0), 11.0 / 12, 1e-7);
  const double far = albedo(phong_classic{}, {0, 1}, {10}, 89.9),
               farther = albedo(phong_classic{}, {0, 1}, {10}, 89.99);
  EXPECT_NEAR(farther / far, 10, 0.1);
}

TEST(KnownViolations, ThePowerOfPhongBreaksElsewhere) {
  EXPECT_TRUE(std::isnan(std::pow(-0.1, 2.5)));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(0, 1);
  float largest = 0;
  for (int k = 0; k < 10000; ++k) {  // the mirror direction of a rounded unit vector with itself
    const Vec3<double> w = direction(radians(1.5 * unit(random)), radians(6 * unit(random)));
    const Vec3<float> r{float(w.x), float(w.y), float(w.z)};
    largest = std::max(largest, std::pow(dot(r, r), 1e6f));
  }
  EXPECT_GT(largest, 1.1f);
  EXPECT_LT(largest, 1.5f);
}

// --- Blinn-Phong ------------------------------------------------------------------------------------------

TEST(KnownViolations, BlinnPhongN8GainsEnergyAtNormalIncidence) {
  for (double n : {0.01, 1.0, 100.0, 1e4}) EXPECT_GT(albedo(blinn_phong_n8{}, {0, 1}, {n}, 0), 1);
  EXPECT_NEAR(albedo(blinn_phong_n8{}, {0, 1}, {8.764}, 0), 1.075201, 1e-6);
  EXPECT_LT(albedo(blinn_phong_n8{}, {0, 1}, {8.6}, 0), 1.075201);
  EXPECT_LT(albedo(blinn_phong_n8{}, {0, 1}, {8.9}, 0), 1.075201);
}

TEST(KnownViolations, BlinnPhongAsAMicrofacetFormNeedsMasking) {
  const double n = 50;
  const double e = half_vector_albedo(std::sqrt(2 / n), direction(degrees(89), {}),
                                      [&](const auto& wi, const auto& wo, const auto& h) {
                                        return (n + 2) / (2 * kPi) * std::pow(h.z, n) / (4 * wi.z * wo.z);
                                      });
  EXPECT_NEAR(e, 3.73, 5e-3);
}

TEST(KnownViolations, BlinnPhongUnnormalisedDiffuseIntegratesToPi) {
  for (double theta : {0.0, 70.0})
    EXPECT_NEAR(albedo(blinn_phong_unnormalised{}, {1, 0}, {20}, theta), kPi, 1e-7);
}

TEST(KnownViolations, APlainPowerLosesThreeDigitsPerExponentOfTenThousand) {
  const float n = 1e4f;
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    const double slope = 2e-2 * k / 2000;
    const float cos_h = float(1 / std::sqrt(1 + slope * slope));
    const double truth = std::exp(-0.5 * n * std::log1p(slope * slope));
    worst = std::max(worst, std::abs(std::pow(cos_h, n) / truth - 1));
  }
  EXPECT_NEAR(worst, 3e-8 * n, 0.5e-8 * n);
}

// --- Cook-Torrance ----------------------------------------------------------------------------------------

TEST(KnownViolations, CookTorranceAsPrintedIsNotReciprocal) {
  const Vec3<double> normal{0, 0, 1}, low = direction(degrees(89.5), {});
  const double toward = value(cook_torrance_as_printed{}, {0, 1, 0}, {1, 1}, low, normal);
  const double back = value(cook_torrance_as_printed{}, {0, 1, 0}, {1, 1}, normal, low);
  EXPECT_LT(toward, 1e-9 * back);
  EXPECT_GT(back, 0.01);
}

TEST(KnownViolations, OneSidedClampsBreakReciprocity) {
  const auto clamped = [](const Vec3<double>& wi, const Vec3<double>& wo) {
    Geometry<double> g = geometry(wi, wo);
    g.cos_i = std::max(g.cos_i, 1e-3);
    return quotient(d_ggx(Roughness<double>{0.3, 0.3}, g), v_smith_ggx(Roughness<double>{0.3, 0.3}, g));
  };
  const Vec3<double> a = direction(radians(1.0), {}), b{-std::sqrt(1 - 1e-8), 0, 1e-4};
  EXPECT_GT(std::abs(clamped(a, b) / clamped(b, a) - 1), 1e-3);
  EXPECT_EQ(value(cook_torrance{}, {0, 1, 1}, {0.3, 0.3}, a, b),
            value(cook_torrance{}, {0, 1, 1}, {0.3, 0.3}, b, a));
}

// The popular compensation f (1 + f0 (1/E(wo) - 1)). Exchanging the directions changes its value by the
// ratio E(wi)/E(wo).
TEST(KnownViolations, ScalingByTheViewersAlbedoBreaksReciprocity) {
  const double low = albedo(cook_torrance{}, {0, 1, 1}, {1, 1}, radians(std::acos(0.1)).degrees());
  const double normal = albedo(cook_torrance{}, {0, 1, 1}, {1, 1}, 0);
  EXPECT_NEAR(low / normal, 2.48, 0.005);
  EXPECT_NEAR(1 / normal, 1 / (1 - std::log(2.0)), 1e-7);
}

TEST(KnownViolations, SingleScatteringLosesSixtyNinePercent) {
  EXPECT_NEAR(1 - albedo(cook_torrance{}, {0, 1, 1}, {1, 1}, 0), std::log(2.0), 1e-8);
}

TEST(KnownViolations, CookTorrance1982ReflectsFourOverPi) {
  EXPECT_NEAR(albedo(cook_torrance_1982{}, {0, 1, 1}, {1e-4, 1e-4}, 0), 4 / kPi, 1e-6);
  EXPECT_NEAR(value(cook_torrance_1982{}, {0, 1, 1}, {0.3, 0.3}, direction(radians(0.4), {}),
                    direction(radians(0.7), radians(2))) *
                  kPi / 4,
              value(cook_torrance_vcavity{}, {0, 1}, {0.3, 0.3, 1e9}, direction(radians(0.4), {}),
                    direction(radians(0.7), radians(2))),
              1e-6);
}

TEST(KnownViolations, WithoutMaskingBeckmannGainsEnergy) {
  const Roughness<double> alpha{0.25, 0.25};
  const double e =
      half_vector_albedo(0.25, direction(degrees(85), {}), [&](const auto& wi, const auto& wo, const auto&) {
        const auto d = d_beckmann(alpha, geometry(wi, wo));
        return d.num / d.den / (4 * wi.z * wo.z);
      });
  EXPECT_NEAR(e, 1.37785, 2e-4);
}

double smith_g1(double alpha, double mu) {
  const Roughness<double> a{alpha, alpha};
  const Vec3<double> w = direction(radians(std::acos(mu)), {});
  return 2 * mu / (mu + stretched_length(a, w));
}
double schlick_g1(double k, double mu) {
  return mu / (mu * (1 - k) + k);
}

TEST(KnownViolations, SchlickGgxIsNotSmithsMasking) {
  const auto k = [](double a) { return (a + 1) * (a + 1) / 8; };
  EXPECT_NEAR(smith_g1(0.05, 0.1), 0.945, 5e-4);
  EXPECT_NEAR(schlick_g1(k(0.05), 0.1), 0.446, 5e-4);
  EXPECT_NEAR(schlick_g1(k(std::sqrt(0.05)), 0.1), 0.373, 5e-4);
  EXPECT_NEAR(1 - schlick_g1(k(0.0036), 0.01) / smith_g1(0.0036, 0.01), 0.923, 5e-4);
  EXPECT_NEAR(1 - schlick_g1(k(0.06), 0.01) / smith_g1(0.0036, 0.01), 0.931, 5e-4);
  EXPECT_EQ(k_schlick_ggx(Roughness<double>{0, 0}), 0.125);
}

// The integral of G1 D/(4 cos_o) over wi is 1 for Smith's G1, and G1 divided by Smith's G1 for another G1.
TEST(KnownViolations, SchlickGgxFailsTheWeakWhiteFurnace) {
  const double alpha = 0.25, mu = 0.3;
  const Roughness<double> a{alpha, alpha};
  const Vec3<double> wo = direction(radians(std::acos(mu)), {});
  const double furnace = integral_over_half_vectors(alpha, [&](const Vec3<double>& h) {
    const auto d = d_ggx(a, geometry(h, h));
    return std::max(dot(wo, h), 0.0) * d.num / d.den / mu;
  });
  EXPECT_NEAR(furnace * smith_g1(alpha, mu), 1, 1e-4);
  const double k = square(alpha + 1) / 8;
  EXPECT_NEAR(furnace * schlick_g1(k, mu), schlick_g1(k, mu) / smith_g1(alpha, mu), 1e-4);
  EXPECT_LT(furnace * schlick_g1(k, mu), 0.8);
}

TEST(KnownViolations, TextbookMicrofacetFormulasHaveHoles) {
  const double alpha = 0, cos_h = 1, mu = 0;
  EXPECT_TRUE(std::isnan(alpha * alpha / (kPi * square(cos_h * cos_h * (alpha * alpha - 1) + 1))));
  EXPECT_TRUE(std::isnan(mu * mu / (4 * mu * mu)));
  const Vec3<double> wi{1, 0, 0}, wo{-1, 0, 0}, h = wi + wo;
  EXPECT_TRUE(std::isnan(h.x / std::sqrt(dot(h, h))));
  EXPECT_TRUE(std::isfinite(value(cook_torrance{}, {0, 1, 1}, {1e-4, 1e-4}, wi, wo)));
}

// --- Ward -------------------------------------------------------------------------------------------------

TEST(KnownViolations, WardLosesThreeQuartersAndThenGains) {
  BRDF_LONG_UNDER_SANITIZERS();
  EXPECT_NEAR(1 - albedo(ward{}, {0, 1}, {0.1, 0.1}, 75), 0.74, 0.002);
  EXPECT_NEAR(1 - albedo(ward{}, {0, 1}, {0.01, 0.01}, 75), 0.74, 0.002);
  const std::vector<std::pair<double, double>> crossings{{0.3, 89.892}, {0.4, 89.826}, {0.5, 89.776},
                                                         {0.7, 89.737}, {1, 89.771},   {0.2, 89.956}};
  for (const auto& [alpha, theta] : crossings) {
    EXPECT_LT(albedo(ward{}, {0, 1}, {alpha, alpha}, theta - 0.001), 1) << alpha;
    EXPECT_GT(albedo(ward{}, {0, 1}, {alpha, alpha}, theta + 0.001), 1) << alpha;
  }
  for (double alpha : {0.6, 0.8})
    EXPECT_LT(albedo(ward{}, {0, 1}, {alpha, alpha}, 89.737), 1) << "earliest at .7";
  EXPECT_LT(albedo(ward{}, {0, 1}, {0.1, 0.1}, 89.992), 1);
  EXPECT_GT(albedo(ward{}, {0, 1}, {0.1, 0.1}, 89.994), 1);
  EXPECT_LT(albedo(ward{}, {0, 1}, {1, 1e-4}, 89.41, Fixed::light, 1e-5), 1);
  EXPECT_GT(albedo(ward{}, {0, 1}, {1, 1e-4}, 89.43, Fixed::light, 1e-5), 1);
  EXPECT_NEAR(albedo(ward{}, {0, 1}, {1, 1e-4}, 89.5, Fixed::light, 1e-5), 1.072, 1e-3);
  const double mu = 0;
  EXPECT_TRUE(std::isinf(1 / std::sqrt(mu)));
  EXPECT_TRUE(std::isnan(std::exp(-1 / mu) * (1 / std::sqrt(mu))));
}

TEST(KnownViolations, WardDuerGainsEnergyFromEightyTwoDegrees) {
  BRDF_LONG_UNDER_SANITIZERS();
  const std::vector<std::array<double, 3>> rows{
      {0.05, 87.600, 2.138}, {0.1, 85.591, 3.647}, {0.2, 83.103, 6.261}, {0.5, 82.144, 9.932}};
  for (const auto& [alpha, theta, at_limit] : rows) {
    expect_albedo_crosses_one_at(ward_duer{}, {0, 1}, {alpha, alpha}, theta);
    EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {alpha, alpha}, 89.5), at_limit, 1e-3);
  }
  expect_albedo_crosses_one_at(ward_duer{}, {0, 1}, {0.3, 0.3}, 82.110);
  expect_albedo_crosses_one_at(ward_duer{}, {0, 1}, {0.4, 0.4}, 81.927);
  expect_albedo_crosses_one_at(ward_duer{}, {0, 1}, {0.384, 0.384}, 81.922);
  for (double alpha : {0.36, 0.41})
    EXPECT_LT(albedo(ward_duer{}, {0, 1}, {alpha, alpha}, 81.922), 1) << "earliest at .384";
  EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {0.617, 0.617}, 89.5), 10.138, 1e-3);
  for (double alpha : {0.59, 0.645}) EXPECT_LT(albedo(ward_duer{}, {0, 1}, {alpha, alpha}, 89.5), 10.138);
  EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {1, 1}, 89.5), 9.047, 1e-3);
  EXPECT_LT(albedo(ward_duer{}, {0, 1}, {0.55, 1e-4}, 78.88, Fixed::light, 1e-5), 1);
  EXPECT_GT(albedo(ward_duer{}, {0, 1}, {0.55, 1e-4}, 78.90, Fixed::light, 1e-5), 1);
  EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {0.92, 1e-4}, 89.5, Fixed::light, 1e-5), 13.39, 5e-3);
  for (double alpha : {0.85, 1.0})
    EXPECT_LT(albedo(ward_duer{}, {0, 1}, {alpha, 1e-4}, 89.5, Fixed::light, 1e-5), 13.39);
  for (double alpha : {0.5, 0.6})
    EXPECT_LT(albedo(ward_duer{}, {0, 1}, {alpha, 1e-4}, 78.89, Fixed::light, 1e-5), 1);
}

TEST(KnownViolations, WardBoundedHasNone) {
  double largest = 0;
  for (double alpha : {0.02, 0.05, 0.1, 0.2, 0.4, 0.7, 1.0})
    for (double theta : {0.0, 30.0, 60.0, 75.0, 85.0, 88.0, 89.5})
      largest = std::max(largest, albedo(ward_bounded{}, {0, 1}, {alpha, alpha}, theta, Fixed::light, 1e-6));
  EXPECT_LE(largest, 1);
  EXPECT_GT(largest, 0.999);
}

TEST(KnownViolations, WardAsCodedGrowsAtGrazingLight) {
  EXPECT_NEAR(albedo(ward_as_coded{}, {1}, {0, 1, 1}, 89.5, Fixed::light, 1e-6), 108.105, 0.01);
}

// --- Oren-Nayar -------------------------------------------------------------------------------------------

TEST(KnownViolations, OrenNayarGainsEnergyAtSmallRoughness) {
  EXPECT_NEAR(albedo(oren_nayar{}, {1}, {0.198533}, 90), 1.015179, 1e-6);
  EXPECT_LT(albedo(oren_nayar{}, {1}, {0.19}, 90), 1.015179);
  EXPECT_LT(albedo(oren_nayar{}, {1}, {0.21}, 90), 1.015179);
  expect_albedo_crosses_one_at(oren_nayar{}, {1}, {0.1}, 64.11);
  expect_albedo_crosses_one_at(oren_nayar{}, {1}, {0.2}, 73.09);
  expect_albedo_crosses_one_at(oren_nayar{}, {1}, {0.3}, 85.93);
  EXPECT_LT(albedo(oren_nayar{}, {1}, {0.3262}, 90), 1);
  EXPECT_GT(albedo(oren_nayar{}, {1}, {0.3260}, 90), 1);
  const double s = 0, t = 0;
  EXPECT_TRUE(std::isnan(s / t)) << "the published form at double grazing";
}

TEST(KnownViolations, OrenNayarFullGainsEnergyAndTurnsNegative) {
  EXPECT_NEAR(albedo(oren_nayar_full{}, {1}, {0.304}, 89.9, Fixed::light, 1e-6), 1.050, 1e-4);
  EXPECT_NEAR(albedo(oren_nayar_full{}, {1}, {0.304}, 89.9999, Fixed::light, 1e-6), 1.0510, 1e-4);
  for (double sigma : {0.25, 0.36})
    EXPECT_LT(albedo(oren_nayar_full{}, {1}, {sigma}, 89.9999, Fixed::light, 1e-6), 1.0509);
  // The direct term: f/rho as rho tends to 0, at double grazing opposite the light, in units of 1/pi.
  const auto direct = [](double sigma) {
    return value(oren_nayar_full{}, {1e-9}, {sigma}, {1, 0, 0}, {-1, 0, 0}) / 1e-9 * kPi;
  };
  EXPECT_NEAR(direct(1), -0.164, 5e-4);
  EXPECT_NEAR(direct(1.4025), -0.25, 5e-4);
  EXPECT_NEAR(direct(1.5), -0.262, 5e-4);
  EXPECT_NEAR(direct(kPi / 2), -0.270, 5e-4);
  EXPECT_GT(direct(0.663), 0);
  EXPECT_LT(direct(0.665), 0);
  EXPECT_NEAR(std::tan(std::acos(0.0f)), -2.3e7f, 0.05e7f) << "the published form in float";
}

TEST(KnownViolations, OrenNayarEnergyReflectsExactlyAll) {
  for (double roughness : {0.05, 0.5, 1.0})
    for (double theta : {0.0, 45.0, 80.0, 89.5}) {
      EXPECT_NEAR(albedo(oren_nayar_energy{}, {1}, {roughness}, theta, Fixed::light, 1e-9), 1, 1e-8);
      EXPECT_LT(albedo(oren_nayar_energy{}, {0.9}, {roughness}, theta), 0.9 + 1e-7);
    }
  const double s = 1, mu = 0;
  EXPECT_TRUE(std::isnan(s / mu * (1 - s * s * s))) << "its published albedo at grazing";
}

TEST(KnownViolations, OrenNayarAsCodedIsTooBright) {
  EXPECT_NEAR(albedo(oren_nayar_as_coded{}, {1}, {0.2}, 0), 1.10, 0.003);
  EXPECT_NEAR(albedo(oren_nayar_as_coded{}, {1}, {0.5}, 0), 1.15, 0.001);
  EXPECT_NEAR(albedo(oren_nayar_as_coded{}, {1}, {0.5}, 89), 1.2155, 1e-4);
}

// --- Declarations -----------------------------------------------------------------------------------------

// Returns the witness, such as "kd=0 ks=1 exponent=0", as a term of one channel.
Term witness_term(const Reflectance& form, std::string_view witness) {
  Term term = make_term(form, 1);
  std::istringstream words{std::string(witness)};
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const double v = std::stod(word.substr(equals + 1));
    bool is_known = false;
    for (const std::string& part : {name, name + "_x", name + "_y"}) {  // as --set: alpha means both widths
      const int w = info(form).weight_index(part), s = info(form).shape_index(part);
      if (w >= 0) term.weights[0][std::size_t(w)] = v;
      if (s >= 0) term.shape[0][std::size_t(s)] = v;
      is_known = is_known || w >= 0 || s >= 0;
    }
    EXPECT_TRUE(is_known) << info(form).name << ' ' << word;
  }
  return term;
}

std::vector<Reflectance> forms_and_targets() {
  std::vector<Reflectance> all;
  for_each_form([&](auto form) { all.push_back(form); });
  all.insert(all.end(), targets().begin(), targets().end());
  return all;
}

TEST(KnownViolations, EveryDeclaredEnergyWitnessReproducesItsValue) {
  BRDF_LONG_UNDER_SANITIZERS();
  int witnesses = 0;
  for (const Reflectance& form : forms_and_targets())
    for (const Violation& v : info(form).violations) {
      if (v.check != "energy") continue;
      ++witnesses;
      const Term term = witness_term(form, v.witness);
      const AlbedoResult r = directional_albedo(term, 0, degrees(v.theta), {}, {.tolerance = 1e-6});
      EXPECT_NEAR(r.value, v.value, 1e-3 * v.value) << info(form).name << ": " << v.witness;
      EXPECT_GT(r.value, 1) << info(form).name;
    }
  EXPECT_GE(witnesses, 20);
}

// The largest difference at the parameters and the angle of a declaration is within 2 % of the declared
// value.
TEST(KnownViolations, EveryDeclaredReciprocityWitnessReproducesItsValue) {
  BRDF_LONG_UNDER_SANITIZERS();
  int witnesses = 0;
  for (const Reflectance& form : forms_and_targets())
    for (const Violation& v : info(form).violations) {
      if (v.check != "reciprocity") continue;
      ++witnesses;
      const Material m{{"y"}, {witness_term(form, v.witness)}};
      const Vec3<double> fixed = direction(degrees(v.theta), {});
      double worst = 0;
      const auto compare = [&](double theta) {
        for (double phi : {0.0, 1.0, 2.0, kPi}) {
          const Vec3<double> other = direction(degrees(theta), radians(phi));
          double there = 0, back = 0;
          eval(m, fixed, other, {&there, 1});
          eval(m, other, fixed, {&back, 1});
          worst = std::max(worst, std::abs(there - back) / std::max(there, back));
        }
      };
      for (double theta = 0; theta <= 89.5; theta += 0.5) compare(theta);
      if (catalogue_index(form) < 0) compare(90);  // the compensation of targets changes up to the horizon
      EXPECT_NEAR(worst, v.value, 0.02 * v.value) << info(form).name;
    }
  EXPECT_EQ(witnesses, 13);
}

}  // namespace
}  // namespace brdf
