// The reasons for Ward's lobes: the reflection by slopes equals the form, opposite slopes together reflect
// at most 1, and the growth towards grazing agrees with the integrals.
#include <gtest/gtest.h>

#include <random>

#include "brdf/integrals.h"
#include "prove/energy/energy.h"
#include "prove/energy/growth.h"
#include "prove/proof.h"
#include "prove/scalar/ward_energy.h"

namespace brdf::prove {
namespace {

using Engine = std::mt19937_64;
double uniform(Engine& e, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(e);
}
Vec3<double> direction(double cosine, double phi) {
  const double s = std::sqrt((1 - cosine) * (1 + cosine));
  return {s * std::cos(phi), s * std::sin(phi), cosine};
}

// Compares f cos_o of a lobe over d omega_o with P22 times the reflection of the slope.
template <WardKind kind>
void expect_identity() {
  Engine e(5);
  for (int k = 0; k < 4000; ++k) {
    const Roughness<double> a{uniform(e, 0.1, 1), uniform(e, 0.1, 1)};
    const double c = uniform(e, 0.01, 1), phi = uniform(e, 0, 6.28);
    const auto g = geometry(direction(c, phi), direction(uniform(e, 0.01, 1), uniform(e, 0, 6.28)));
    const double p = g.h.x / g.h.z, q = g.h.y / g.h.z;
    const double density =
        std::exp(-square(p / a.alpha_x) - square(q / a.alpha_y)) / (kPi * a.alpha_x * a.alpha_y);
    const double measure = 2 * g.h.z * g.h.z * g.h.z / g.h2;
    const double s = 1 + p * p + q * q, along = p * std::cos(phi) + q * std::sin(phi),
                 sine = std::sqrt(1 - c * c);
    const double u = along * sine / c, height = c + sine * along;
    const double reflected = kind == WardKind::bounded ? 2 - s / (1 + u)
                             : kind == WardKind::root
                                 ? height * std::sqrt(2 * height / s - c) / (s * s * std::sqrt(c))
                                 : height / (s * s * c);
    const double lobe = ward_lobe<kind>(a, g) * g.cos_o * measure;
    EXPECT_NEAR(lobe, density * reflected, 1e-11 * lobe + 1e-300) << k;
  }
}

TEST(Ward, WhatSlopesReflectIsTheForm) {
  expect_identity<WardKind::root>();
  expect_identity<WardKind::product>();
  expect_identity<WardKind::bounded>();
}

TEST(Ward, OppositeSlopesReflectAtMostOneBetweenThem) {
  Engine e(6);
  double largest = 0;
  for (int k = 0; k < 1000000; ++k) {
    const double s = 1 + std::pow(10, uniform(e, -9, 6)), u = std::pow(10, uniform(e, -9, 9));
    const auto lit = [&](double tilt) { return tilt > -1 ? std::max(0.0, 2 - s / (1 + tilt)) : 0.0; };
    const double mean = 0.5 * (lit(u) + lit(-u));
    const double bound = ward_bounded_mean(1 / s, std::min(u, 1.0), std::min(1 / u, 1.0));
    ASSERT_LE(mean, bound * (1 + 1e-12)) << s << ' ' << u;
    ASSERT_LE(bound, 1 + 1e-15);
    largest = std::max(largest, mean);
  }
  EXPECT_GT(largest, 0.999);
}

std::vector<Proof> energy_of(const std::string& form) {
  Options options;
  options.properties = {Property::energy};
  return prove(*find_form(form), options);
}

TEST(Ward, TheBoundedLobeIsProved) {
  const Proof p = energy_of("ward_bounded").front();
  EXPECT_EQ(p.verdict, Verdict::proved);
  EXPECT_LE(p.high, 1 + 1e-15);
  for (const char* other : {"ward", "ward_duer", "cook_torrance", "blinn_phong"}) {
    const EnergyMethod* method = energy_method(catalogue_index(*find_form(other)));
    const bool its = method != nullptr && !method->domain.variables.empty() &&
                     method->domain.variables.back().name == "facet_tilt";
    EXPECT_FALSE(its) << other;
  }
}

TEST(Ward, TheGrowthTowardsGrazingHoldsWhatIntegralsFind) {
  Engine e(7);
  for (const auto& [name, power] : {std::pair{"ward", 0.5}, std::pair{"ward_duer", 1.0}}) {
    const Proof p = energy_of(name).front();
    ASSERT_TRUE(p.growth.has_value()) << name;
    EXPECT_EQ(p.growth->power, power);
    EXPECT_LT(p.growth->high, 1.13 * p.growth->low);
    for (const double theta : {89.0001, 89.5, 89.9, 89.99}) {
      const double scale = std::pow(std::cos(theta * kPi / 180), power);
      double largest = 0;
      for (int k = 0; k < 12; ++k) {
        const double shape[] = {k < 6 ? 0.8 + 0.04 * k : std::pow(10, uniform(e, -3, 0)),
                                k < 6 ? 1e-4 : uniform(e, 1e-3, 1)};
        const auto found = lobe_albedos(*find_form(name), shape, degrees(theta), degrees(0)).at(1);
        EXPECT_LE((found.value - found.error_bound) * scale, p.growth->high) << name << theta;
        largest = std::max(largest, (found.value + found.error_bound) * scale);
      }
      EXPECT_GE(largest, p.growth->low) << name << ' ' << theta;
    }
  }
  EXPECT_FALSE(energy_of("phong_classic").front().growth.has_value());
}

}  // namespace
}  // namespace brdf::prove
