// The matt basis and the retroreflective lobe against their definitions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "brdf/integrals.h"
#include "brdf/least_of_matt.h"
#include "brdf/material.h"

namespace brdf {
namespace {

Material basis(const char* name, std::vector<double> weights) {
  Material m = make_material(*find_form(name), {"f"});
  m.terms[0].weights = {std::move(weights)};
  return m;
}

double value(const Material& m, const Vec3<double>& wi, const Vec3<double>& wo) {
  double f = 0;
  eval(m, wi, wo, {&f, 1});
  return f;
}

Vec3<double> any_direction(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  return direction(radians(std::acos(unit(random))), radians(2 * kPi * unit(random)));
}

const std::vector<double> kWhite{0.93, 0.08, 0.15, -0.2, 0.16};  // a white tile
const std::vector<double> kDark{0.3, -0.45, 0.28, -0.15, 0.25};  // negative near grazing

TEST(Matt, TheLeastValueIsReachedAndNoPairOfDirectionsIsBelowTheBound) {
  for (const std::vector<double>& weights : {kWhite, kDark}) {
    const Material m = basis("matt_5", weights);
    const LeastOfMatt least = least_of_matt(*info(m.terms[0].form).basis, weights, 1e9);
    EXPECT_NEAR(value(m, least.wi, least.wo), least.value, 1e-12);
    EXPECT_LE(least.bound, least.value);
    EXPECT_NEAR(least.bound, least.value, 1e-6);
    std::mt19937_64 random(5);
    for (int k = 0; k < 20000; ++k)
      ASSERT_GE(value(m, any_direction(random), any_direction(random)), least.bound - 1e-12);
  }
}

TEST(Matt, WeightsOfEitherSignDecideWhetherFIsNegative) {
  const MattBasis& order_2 = *info(*find_form("matt_5")).basis;
  EXPECT_GT(least_of_matt(order_2, kWhite, 0).bound, 0);
  EXPECT_EQ(least_of_matt(order_2, kWhite, 0).boxes, 1);
  EXPECT_LT(least_of_matt(order_2, kDark, 0).value, -0.01);
}

TEST(Matt, TheClosedAlbedoIsTheIntegral) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> some(-0.3, 0.3);
  for (const char* name : {"matt_2", "matt_5", "matt_8", "matt_14", "matt_20"}) {
    const ReflectanceInfo& form = info(*find_form(name));
    std::vector<double> weights(form.weights.size()), albedos(weights.size());
    for (double& w : weights) w = some(random);
    weights[0] = 1;
    const Material m = basis(name, weights);
    for (const double theta : {0.0, 35.0, 60.0, 82.0, 90.0}) {
      // The integral at 90 degrees is that at a cosine of 1e-12.
      matt_albedos(*form.basis, std::max(std::cos(degrees(theta).radians()), 1e-12), albedos);
      double closed = 0;
      for (std::size_t k = 0; k < weights.size(); ++k) closed += weights[k] * albedos[k];
      const AlbedoResult r = directional_albedo(m.terms[0], 0, degrees(theta), {}, {.tolerance = 1e-13});
      EXPECT_NEAR(r.value, closed, 1e-12) << name << " at " << theta;
    }
  }
}

TEST(Matt, ValuesOfTheFunctionsAreTheLobes) {
  std::mt19937_64 random(9);
  const Reflectance form = *find_form("matt_20");
  std::vector<double> lobes(20), values(20);
  for (int k = 0; k < 200; ++k) {
    const Vec3<double> wi = any_direction(random), wo = any_direction(random);
    form->lobes({}, Partial::none, one_pair(wi, wo), {lobes.data(), 1});
    matt_values(*form.info().basis, wi, wo, values);
    for (std::size_t j = 0; j < lobes.size(); ++j) ASSERT_NEAR(lobes[j], values[j], 2e-15);
  }
}

TEST(Retro, TheLobePeaksTowardsTheLightAndReflectsAsMuchAsTheMirrorLobe) {
  Material back = make_material(*find_form("retro"), {"f"}),
           mirror = make_material(*find_form("cook_torrance"), {"f"});
  back.terms[0].shape = mirror.terms[0].shape = {{0.1, 0.25}};
  back.terms[0].weights = {{0.8}};
  mirror.terms[0].weights = {{0, 0.8, 1}};
  const Vec3<double> wi = direction(40_deg, 30_deg);
  const double peak = value(back, wi, wi);
  EXPECT_GT(peak, value(back, wi, direction(50_deg, 30_deg)));
  EXPECT_GT(peak, 3 * value(back, wi, direction(40_deg, 210_deg)));
  for (const Angle theta : {0_deg, 30_deg, 60_deg, 85_deg})
    for (const Angle phi : {0_deg, 50_deg}) {
      const AlbedoResult a = directional_albedo(back.terms[0], 0, theta, phi, {.tolerance = 1e-9}),
                         b = directional_albedo(mirror.terms[0], 0, theta, phi, {.tolerance = 1e-9});
      EXPECT_TRUE(a.converged);
      EXPECT_NEAR(a.value, b.value, a.error_bound + b.error_bound);
    }
}

TEST(Retro, ItIsTheLobeOfTheViewAfterHalfATurn) {
  std::mt19937_64 random(11);
  Material back = make_material(*find_form("retro_beckmann"), {"f"}),
           mirror = make_material(*find_form("cook_torrance_beckmann"), {"f"});
  back.terms[0].weights = {{0.6}};
  mirror.terms[0].weights = {{0, 0.6, 1}};
  for (int k = 0; k < 200; ++k) {
    const Vec3<double> wi = any_direction(random), wo = any_direction(random);
    const double here = value(back, wi, wo);
    EXPECT_NEAR(here, value(back, wo, wi), 1e-12 * here);
    EXPECT_NEAR(here, value(mirror, wi, {-wo.x, -wo.y, wo.z}), 1e-14 * here);
  }
}

}  // namespace
}  // namespace brdf
