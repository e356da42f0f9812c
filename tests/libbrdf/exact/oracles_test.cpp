// Independent reference values: distributions, masking functions, Fresnel factors, albedos in closed form,
// and published tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/forms.h"
#include "brdf/fresnel.h"
#include "brdf/integrals.h"
#include "brdf/material.h"
#include "tests/libbrdf/half_vector_quadrature.h"
#include "validate/numerics/exact.h"

namespace brdf {
namespace {

constexpr double kDegree = kPi / 180;

double albedo(const Reflectance& form, const std::vector<double>& weights, const std::vector<double>& shape,
              double theta, double phi = 0) {
  Term term = make_term(form, 1);
  term.weights[0] = weights;
  term.shape[0] = shape;
  const AlbedoResult r = directional_albedo(term, 0, radians(theta), radians(phi), {.tolerance = 1e-11});
  EXPECT_TRUE(r.converged) << info(form).name;
  return r.value;
}

double d(const Fraction<double>& fraction) {
  return fraction.num / fraction.den;
}
// The distributions at a half vector, with wi = wo = h.
double ggx(const Roughness<double>& a, const Vec3<double>& h) {
  return d(d_ggx(a, geometry(h, h)));
}
double beckmann(const Roughness<double>& a, const Vec3<double>& h) {
  return d(d_beckmann(a, geometry(h, h)));
}

// --- Distributions and masking ----------------------------------------------------------------------------

TEST(Distributions, AreNormalised) {
  for (const Roughness<double>& a : {Roughness<double>{0.1, 0.1}, {0.5, 0.5}, {0.4, 0.2}, {1, 1}})
    for (auto* distribution : {&ggx, &beckmann})
      EXPECT_NEAR(integral_over_half_vectors(a.alpha_x,
                                             [&](const Vec3<double>& h) { return distribution(a, h) * h.z; }),
                  1, 3e-5);
}

TEST(Distributions, OfGgxHaveTheirEndValues) {
  const double alpha = 0.2;
  EXPECT_NEAR(ggx({alpha, alpha}, {0, 0, 1}), 1 / (kPi * alpha * alpha), 1e-13);
  EXPECT_NEAR(ggx({alpha, alpha}, {1, 0, 0}), alpha * alpha / kPi, 1e-13);
}

// The integral of D (wo.h)+ over h is cos_o/G1(wo), which is the normalisation of the visible area.
TEST(Masking, OfSmithShowsTheProjectedArea) {
  for (double mu : {0.15, 0.5, 0.9}) {
    const Vec3<double> wo = direction(radians(std::acos(mu)), radians(0.7));
    const Roughness<double> a{0.5, 0.3};
    const auto visible = [&](auto* distribution) {
      return integral_over_half_vectors(
          0.4, [&](const Vec3<double>& h) { return distribution(a, h) * std::max(dot(wo, h), 0.0); });
    };
    EXPECT_NEAR(visible(&ggx), 0.5 * (mu + stretched_length(a, wo)), 1e-4);
    EXPECT_NEAR(visible(&beckmann), mu + cos_lambda_beckmann(a, wo), 1e-5);
  }
}

TEST(Masking, CorrelatedAndSeparableSmithDifferByUpToTwoLogTwoMinusOne) {
  const Vec3<double> wo = direction(degrees(85), {});
  const Roughness<double> a{1, 1};
  const double separable = half_vector_albedo(1, wo, [&](const auto& wi, const auto&, const auto& h) {
    const auto g1 = [&](const Vec3<double>& w) { return 2 * w.z / (w.z + stretched_length(a, w)); };
    return ggx(a, h) * g1(wi) * g1(wo) / (4 * wi.z * wo.z);
  });
  EXPECT_NEAR(albedo(cook_torrance{}, {0, 1, 1}, {1, 1}, 85 * kDegree) - separable, 0.216, 1e-3);
}

// --- Fresnel ----------------------------------------------------------------------------------------------

TEST(Fresnel, OfADielectricMatchesThePublishedValues) {
  const auto f = [](double degrees) { return fresnel_dielectric(1.5, std::cos(degrees * kDegree)); };
  EXPECT_NEAR(f(0), 0.04, 1e-15);
  EXPECT_NEAR(f(45), 0.050239911012, 1e-12);
  EXPECT_NEAR(f(60), 0.089186712802, 1e-12);
  EXPECT_NEAR(f(80), 0.387704354691, 1e-12);
}

TEST(Fresnel, OfAConductorMatchesThePublishedValues) {
  const auto f = [](double degrees) { return fresnel_conductor(2.0, 4.0, std::cos(degrees * kDegree)); };
  EXPECT_NEAR(f(0), 0.68, 1e-15);
  EXPECT_NEAR(f(45), 0.672878863372, 1e-12);
  EXPECT_NEAR(f(60), 0.656532850067, 1e-12);
  EXPECT_NEAR(f(80), 0.658842645827, 1e-12);
}

TEST(Fresnel, HasItsLimits) {
  EXPECT_EQ(fresnel_dielectric(1.0, 0.0), 0.0);
  EXPECT_EQ(fresnel_dielectric(1.0, 0.7), 0.0);
  EXPECT_EQ(fresnel_dielectric(1.5, 0.0), 1.0);
  EXPECT_EQ(fresnel_dielectric(1 / 1.5, 0.1), 1.0) << "total reflection";
  EXPECT_EQ(fresnel_conductor(0.0, 0.0, 1.0), 1.0);
  EXPECT_EQ(fresnel_conductor(0.0, 0.0, 0.3), 1.0);
  EXPECT_EQ(fresnel_conductor(1.0, 0.0, 0.0), 0.0);
  EXPECT_EQ(fresnel_conductor(1.0, 0.0, 1.0), 0.0);
  EXPECT_EQ(fresnel_conductor(0.2, 3.0, 0.0), 1.0);
  for (double c : {0.0, 1e-3, 0.3, 0.8, 1.0})
    EXPECT_NEAR(fresnel_conductor(1.5, 0.0, c), fresnel_dielectric(1.5, c), 1e-15);
}

// The code of the article, (g-c)(g-c)/(g+c)*(g+c), evaluates to (g-c)^2.
TEST(Fresnel, OfTheArticlesCodeIsWrongByItsNumbers) {
  EXPECT_NEAR(fresnel_dielectric_as_coded(1.5, 1.0), 0.25, 1e-15);
  EXPECT_NEAR(fresnel_dielectric_as_coded(1.5, 0.5), 0.2653, 5e-5);
  EXPECT_NEAR(fresnel_dielectric_as_coded(1.5, 0.0), 1.25, 1e-15);
}

// Returns the largest relative errors of T against 50 digits over indices and angles, including grazing
// angles.
template <class T>
std::pair<double, double> fresnel_errors() {
  using validate::Exact;
  double dielectric = 0, conductor = 0;
  const auto note = [](double& worst, T value, const Exact& truth) {
    ASSERT_TRUE(value >= 0 && value <= 1 && std::isfinite(value));
    if (truth != 0) worst = std::max(worst, double(Exact(abs(Exact(value) / truth - 1))));
  };
  for (T c : {T(1e-6), T(1e-3), T(0.1), T(0.37), T(0.71), T(0.95), T(1)}) {
    for (T eta : {T(1.0001), T(1.01), T(1.5), T(2.4), T(5)})
      note(dielectric, fresnel_dielectric(eta, c), fresnel_dielectric(Exact(eta), Exact(c)));
    for (T n : {T(0.05), T(0.9), T(1.5), T(10)})
      for (T k : {T(0), T(1e-3), T(1), T(5), T(20)})
        note(conductor, fresnel_conductor(n, k, c), fresnel_conductor(Exact(n), Exact(k), Exact(c)));
  }
  return {dielectric, conductor};
}
TEST(Fresnel, IsAccurateInBothScalars) {
  const auto expect_close_below = [](double error, double bound) {
    EXPECT_LE(error, bound);
    EXPECT_GE(error, bound / 2);
  };
  const auto [dielectric, conductor] = fresnel_errors<double>();
  expect_close_below(dielectric, 1.2e-15);
  expect_close_below(conductor, 2.2e-15);
  const auto [dielectric_float, conductor_float] = fresnel_errors<float>();
  expect_close_below(dielectric_float, 5e-7);
  expect_close_below(conductor_float, 2.6e-6);
}

// Compares with the complex formula in 50 digits: cos_t = sqrt(1 - sin^2/index^2).
TEST(Fresnel, OfAConductorIsTheComplexFormula) {
  using validate::Exact;
  struct Complex {
    Exact re, im;
  };
  const auto times = [](Complex a, Complex b) {
    return Complex{a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  };
  const auto root = [](Complex z) {
    const Exact length = sqrt(z.re * z.re + z.im * z.im);
    const Exact re = sqrt((length + z.re) / 2), im = sqrt((length - z.re) / 2);
    return Complex{re, z.im < 0 ? Exact(-im) : im};
  };
  const auto norm_ratio = [](Complex a, Complex b) {
    return Exact((a.re * a.re + a.im * a.im) / (b.re * b.re + b.im * b.im));
  };
  for (double n : {0.2, 1.5, 3.0})
    for (double k : {0.1, 3.9})
      for (double c : {0.05, 0.5, 0.9}) {
        const Complex index{n, k};
        const Complex squared = times(index, index);
        const Complex u = root({squared.re - (1 - Exact(c) * c), squared.im});  // index cos_t
        const Complex index2_c = {squared.re * c, squared.im * c};
        const Exact s = norm_ratio({c - u.re, -u.im}, {c + u.re, u.im});
        const Exact p =
            norm_ratio({index2_c.re - u.re, index2_c.im - u.im}, {index2_c.re + u.re, index2_c.im + u.im});
        EXPECT_NEAR(fresnel_conductor(n, k, c), double(Exact((s + p) / 2)), 2e-15)
            << n << ' ' << k << ' ' << c;
      }
}

TEST(Fresnel, OfSchlickHasItsHemisphericalAverage) {
  const double f0 = 0.3;
  double sum = 0;
  constexpr int kSteps = 20000;
  for (int k = 0; k < kSteps; ++k) {
    const double c = (k + 0.5) / kSteps;
    sum += (f0 + (1 - f0) * std::pow(1 - c, 5)) * 2 * c / kSteps;
  }
  EXPECT_NEAR(sum, (1 + 20 * f0) / 21, 1e-8);
}

TEST(Fresnel, OfSchlickIsOffByTheKnownAmounts) {
  double dielectric = 0, relative_at_55 = 0;
  for (double degrees = 0; degrees <= 90; degrees += 0.5) {
    const double c = std::cos(degrees * kDegree), exact = fresnel_dielectric(1.5, c);
    const double schlick_value = 0.04 + 0.96 * std::pow(1 - c, 5);
    dielectric = std::max(dielectric, std::abs(schlick_value - exact));
    if (degrees == 55) relative_at_55 = schlick_value / exact - 1;
  }
  EXPECT_NEAR(dielectric, 0.036, 1e-3);
  EXPECT_NEAR(relative_at_55, -0.23, 0.01);
}

// --- Albedos ----------------------------------------------------------------------------------------------

TEST(AlbedoOracles, OfBeckmannAtNormalIncidence) {
  EXPECT_NEAR(albedo(cook_torrance_beckmann{}, {0, 1, 1}, {0.25, 0.25}, 0), 0.999991012221851, 1e-12);
  EXPECT_NEAR(albedo(cook_torrance_beckmann{}, {0, 1, 1}, {0.5, 0.5}, 0), 0.942998374631463, 1e-12);
  EXPECT_NEAR(albedo(cook_torrance_beckmann{}, {0, 1, 1}, {1, 1}, 0), 0.461588090570296, 1e-12);
}

TEST(AlbedoOracles, OfWardDuerAtNormalIncidence) {
  EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {0.1, 0.1}, 0), 0.980577132669816, 1e-11);
  EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {0.5, 0.5}, 0), 0.694741897039630, 1e-11);
  EXPECT_NEAR(albedo(ward_duer{}, {0, 1}, {1, 1}, 0), 0.352638286751174, 1e-11);
}

TEST(AlbedoOracles, OfWardBoundedAtNormalIncidence) {
  for (double a : {0.1, 0.5, 1.0})
    EXPECT_NEAR(albedo(ward_bounded{}, {0, 1}, {a, a}, 0), 1 - a * a * (1 - std::exp(-1 / (a * a))), 1e-11);
}

TEST(AlbedoOracles, OfAProductionTablesCells) {
  const std::vector<std::array<double, 3>> cells{
      {16, 8, 0.834154}, {22, 16, 0.693982}, {31, 1, 0.888202}, {31, 31, 0.306853}};
  for (const auto& [x, y, expected] : cells) {
    const double alpha = square(x / 31), mu = y / 31;
    EXPECT_NEAR(albedo(cook_torrance{}, {0, 1, 1}, {alpha, alpha}, std::acos(mu)), expected, 1e-6)
        << x << ' ' << y;
  }
}

// Fujii's form is the first term of the energy-preserving form. Its average albedo is the value to which
// the second term is added.
TEST(AlbedoOracles, OfFujiisFormOnAverage) {
  const double a = 1 / (1 + oren_nayar_energy::kC1);
  EXPECT_NEAR(a * (1 + oren_nayar_energy::kC2), 0.832810763579, 1e-12);
}

// The microfacet material of a teaching renderer: Beckmann with alpha 0.1, the rational fit of separable
// masking, and the exact Fresnel factor.
TEST(AlbedoOracles, OfATeachingRenderersMaterial) {
  const double alpha = 0.1, eta = 1.5 / 1.000277;
  const double diffuse = 0.212671 * 0.1 + 0.715160 * 0.2 + 0.072169 * 0.15;  // luminance of kd
  const auto g1 = [&](const Vec3<double>& w) {
    const double b = w.z / (alpha * std::sqrt(1 - w.z * w.z + 1e-30));
    return b >= 1.6 ? 1.0 : (3.535 * b + 2.181 * b * b) / (1 + 2.276 * b + 2.577 * b * b);
  };
  const std::vector<std::pair<double, double>> rows{
      {0, 0.207084}, {45, 0.215892}, {60, 0.247774}, {80, 0.430824}, {85, 0.519005}};
  for (const auto& [theta, expected] : rows) {
    const double e =
        diffuse + 0.8 * half_vector_albedo(alpha, direction(degrees(theta), {}),
                                           [&](const auto& wi, const auto& wo, const auto& h) {
                                             return beckmann({alpha, alpha}, h) * g1(wi) * g1(wo) *
                                                    fresnel_dielectric(eta, dot(wo, h)) / (4 * wi.z * wo.z);
                                           });
    EXPECT_NEAR(e, expected, 2e-5) << theta;
  }
}

// Inside a closed sphere of albedo a the light is 1 + a + a^2 + ...
TEST(AlbedoOracles, OfAClosedSphereIsTheGeometricSeries) {
  const double a = albedo(lambert{}, {0.8}, {}, 0.3);
  double light = 0;
  for (int bounce = 0; bounce < 400; ++bounce) light = 1 + a * light;
  EXPECT_NEAR(light, 1 / (1 - 0.8), 1e-10);
}

}  // namespace
}  // namespace brdf
