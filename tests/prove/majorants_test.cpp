// The hand-written reasons for energy conservation match the forms: f cos_o = p R in 50 digits, p
// integrates to 1, and closed integrals agree with quadrature. No planted form is accepted as a form that
// has a reason.
#include <gtest/gtest.h>

#include <random>

#include "brdf/integrals.h"
#include "brdf/quadrature.h"
#include "prove/energy/energy.h"
#include "prove/energy/majorants.h"
#include "validate/numerics/exact.h"

namespace brdf::prove {
namespace {

using validate::Exact;

template <class T>
Vec3<T> direction_at(double cosine, double phi) {
  using std::cos, std::sin, std::sqrt;
  const T z(cosine), s = sqrt((T(1) - z) * (T(1) + z)), p(phi);
  return {s * cos(p), s * sin(p), z};
}

// D and G1 for one direction, as a textbook prints them.
template <class Majorant>
struct Textbook;
template <>
struct Textbook<GgxSmith> {
  template <class T>
  static T d(const Roughness<T>& a, const Geometry<T>& g) {
    const auto f = d_ggx(a, g);
    return f.num / f.den;
  }
  template <class T>
  static T g1(const Roughness<T>& a, const Geometry<T>&, const Vec3<T>& w) {
    return T(1) / (T(1) + GgxSmith::lambda(a, w));
  }
};
template <>
struct Textbook<BeckmannSmith> {
  template <class T>
  static T d(const Roughness<T>& a, const Geometry<T>& g) {
    const auto f = d_beckmann(a, g);
    return f.num / f.den;
  }
  template <class T>
  static T g1(const Roughness<T>& a, const Geometry<T>&, const Vec3<T>& w) {
    return T(1) / (T(1) + BeckmannSmith::lambda(a, w));
  }
};
template <>
struct Textbook<BeckmannCavities> : Textbook<BeckmannSmith> {
  template <class T>
  static T g1(const Roughness<T>&, const Geometry<T>& g, const Vec3<T>& w) {
    return smaller(T(1), T(2) * (g.h.z / (T(2) * g.cos_d)) * w.z / g.cos_d);
  }
};

// The identity is lobe cos_o = D G1(wi)/(4 cos_i) (G2/G1).
template <class Majorant>
void identity() {
  std::mt19937_64 e(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 200; ++k) {
    const Roughness<Exact> a{Exact(0.05 + unit(e)), Exact(0.05 + unit(e))};
    const Geometry<Exact> g = geometry(direction_at<Exact>(0.02 + 0.97 * unit(e), 6 * unit(e)),
                                       direction_at<Exact>(0.02 + 0.97 * unit(e), 6 * unit(e)));
    using T = Textbook<Majorant>;
    const Exact p = T::d(a, g) * T::g1(a, g, g.wi) / (Exact(4) * g.cos_i);
    const Exact lobe = Majorant::lobe(a, g) * g.cos_o, by_ratio = p * Majorant::ratio(a, g);
    EXPECT_LT(double(abs(lobe - by_ratio)), 1e-30 * double(lobe) + 1e-40) << k;
  }
}

TEST(Majorants, AreTheFormsInFiftyDigits) {
  identity<GgxSmith>();
  identity<BeckmannCavities>();
}

// Beckmann's Lambda contains erfcx, and pi as a double, so the identity is tested to the accuracy of
// double.
TEST(Majorants, OfBeckmannIsTheFormInDouble) {
  std::mt19937_64 e(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 2000; ++k) {
    const Roughness<double> a{0.05 + 0.95 * unit(e), 0.05 + 0.95 * unit(e)};
    const auto g = geometry(direction_at<double>(0.02 + 0.97 * unit(e), 6 * unit(e)),
                            direction_at<double>(0.02 + 0.97 * unit(e), 6 * unit(e)));
    using T = Textbook<BeckmannSmith>;
    const double p = T::d(a, g) * T::g1(a, g, g.wi) / (4 * g.cos_i);
    const double lobe = BeckmannSmith::lobe(a, g) * g.cos_o;
    EXPECT_NEAR(lobe, p * BeckmannSmith::ratio(a, g), 1e-12 * lobe) << k;
  }
}

// The bound for the ratio of Schlick's masking is above the ratio itself and at most 1.
TEST(Majorants, OfSchlicksMaskingIsAboveTheRatio) {
  std::mt19937_64 e(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 20000; ++k) {
    const double alpha = std::pow(10, -4 * unit(e));
    const Roughness<double> a{alpha, alpha};
    const auto g =
        geometry(direction_at<double>(std::pow(10, -6 * unit(e)), 1), direction_at<double>(unit(e), 3));
    const double d = Textbook<GgxSmith>::d(a, g), p = d * Textbook<GgxSmith>::g1(a, g, g.wi) / (4 * g.cos_i);
    const double ratio = GgxSchlick::lobe(a, g) * g.cos_o / p;
    EXPECT_LE(ratio, GgxSchlick::ratio(a, g) * (1 + 1e-12)) << alpha << ' ' << g.cos_i << ' ' << g.cos_o;
    EXPECT_LE(GgxSchlick::ratio(a, g), 1);
  }
}

// Returns the integral of the density of visible normals over slopes (p, q), projected on the direction.
// The exact value is 1.
template <class Majorant>
double visible(const Roughness<double>& a, const Vec3<double>& w) {
  // The midpoint rule in the azimuth and in the radius r = x/(1 - x) of the stretched slope.
  constexpr int kRadii = 4000, kAzimuths = 400;
  double sum = 0;
  for (int i = 0; i < kRadii; ++i)
    for (int j = 0; j < kAzimuths; ++j) {
      const double x = (i + 0.5) / kRadii, r = x / (1 - x), phi = 2 * kPi * (j + 0.5) / kAzimuths;
      const double p = a.alpha_x * r * std::cos(phi), q = a.alpha_y * r * std::sin(phi);
      Geometry<double> g{};
      g.h = {p, q, 1};
      g.h2 = dot(g.h, g.h);
      const double facing = dot(w, g.h);
      if (facing <= 0) continue;
      const double p22 = Textbook<Majorant>::d(a, g) / square(g.h2);
      double g1 = 0;
      if constexpr (std::is_same_v<Majorant, BeckmannCavities>)
        g1 = std::min(1.0, 2 * w.z / facing);
      else
        g1 = Textbook<Majorant>::g1(a, g, w);
      sum += p22 * g1 * facing / w.z * a.alpha_x * a.alpha_y * r / square(1 - x) * (1.0 / kRadii) *
             (2 * kPi / kAzimuths);
    }
  return sum;
}

TEST(Majorants, DensitiesOfVisibleNormalsIntegrateToOne) {
  for (const double cosine : {0.95, 0.4}) {
    const Roughness<double> a{0.3, 0.7};
    const auto w = direction_at<double>(cosine, 0.4);
    EXPECT_NEAR(visible<GgxSmith>(a, w), 1, 2e-3);
    EXPECT_NEAR(visible<BeckmannSmith>(a, w), 1, 1e-4);
    EXPECT_NEAR(visible<BeckmannCavities>(a, w), 1, 1e-4);
  }
}

TEST(Majorants, ClosedIntegralIsWhatQuadratureFinds) {
  int compared = 0;
  for (int k = 0; k < int(catalogue().size()); ++k) {
    const EnergyMethod* method = energy_method(k);
    if (method == nullptr || method->domain.variables.size() != 2 || method->albedo == nullptr ||
        method->stretch != nullptr)
      continue;
    Term term = make_term(catalogue()[std::size_t(k)], 1);
    term.weights[0][0] = 1;
    for (const double sigma : {0.05, 0.1985, 0.8, 1.5})
      for (const double theta : {0.0, 20.0, 60.0, 85.0, 89.9}) {
        term.shape[0][0] = sigma;
        const AlbedoResult numeric =
            directional_albedo(term, 0, degrees(theta), degrees(0), {.tolerance = 1e-9});
        const double t = theta * kPi / 180;
        EXPECT_NEAR(oren_nayar_albedo_of(sigma, std::sin(t), std::cos(t)), numeric.value, 1e-8)
            << sigma << ' ' << theta;
        ++compared;
      }
  }
  EXPECT_EQ(compared, 20);
}

// Phong's lobe lies between the cosine and the mean of the cosine and 1, and Blinn's lobe is at most 1.
// Both are 1 at normal incidence. No other form of the two families has this reason.
TEST(Majorants, CosineLobesStayWithinTheirReasons) {
  int known = 0;
  for (int k = 0; k < int(catalogue().size()); ++k) {
    const Reflectance& form = catalogue()[std::size_t(k)];
    const bool phong = form.info().name == "phong", blinn = form.info().name == "blinn_phong";
    if (form.info().family != "phong" && form.info().family != "blinn_phong") continue;
    EXPECT_EQ(energy_method(k) != nullptr, phong || blinn) << form.info().name;
    if (!phong && !blinn) continue;
    ++known;
    Term term = make_term(form, 1);
    term.weights[0] = {0, 1};
    for (const double n : {0.0, 0.3, 1.0, 4.0, 30.0, 1000.0, 1e5})
      for (const double theta : {0.0, 20.0, 45.0, 70.0, 85.0, 89.9}) {
        term.shape[0][0] = n;
        const double found =
            directional_albedo(term, 0, degrees(theta), degrees(0), {.tolerance = 1e-9}).value;
        const double cosine = std::cos(theta * kPi / 180);
        EXPECT_LE(found, (phong ? 0.5 * (1 + cosine) : 1) + 1e-8) << form.info().name << n << ' ' << theta;
        EXPECT_GE(found, (phong ? cosine : 0) - 1e-8) << form.info().name << n << ' ' << theta;
        EXPECT_GE(found, theta == 0 ? 1 - 1e-8 : 0);
      }
  }
  EXPECT_EQ(known, 2);
}

TEST(Majorants, WhatIsGivenBackIsWhatQuadratureFinds) {
  int compared = 0;
  for (int k = 0; k < int(catalogue().size()); ++k) {
    const EnergyMethod* method = energy_method(k);
    if (method == nullptr || method->domain.variables.size() != 3) continue;
    Term term = make_term(catalogue()[std::size_t(k)], 1);
    for (const double rho : {0.3, 0.9, 1.0})
      for (const double roughness : {0.1, 1.0})
        for (const double theta : {0.0, 50.0, 85.0}) {
          term.weights[0][0] = rho;
          term.shape[0][0] = roughness;
          const AlbedoResult numeric =
              directional_albedo(term, 0, degrees(theta), degrees(0), {.tolerance = 1e-9});
          const double t = theta * kPi / 180;
          EXPECT_NEAR(given_back_albedo(rho, roughness, std::sin(t), std::cos(t)), numeric.value, 1e-8)
              << rho << ' ' << roughness << ' ' << theta;
          ++compared;
        }
  }
  EXPECT_EQ(compared, 18);
}

}  // namespace
}  // namespace brdf::prove
