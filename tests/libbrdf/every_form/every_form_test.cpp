// Properties that hold for every form of the catalogue. A new form is tested as soon as it is in the
// catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>

#include "brdf/dual.h"
#include "brdf/material.h"
#include "tests/typed.h"

namespace brdf {
namespace {

template <class Form>
struct EveryForm : ::testing::Test {};

TYPED_TEST_SUITE(EveryForm, CatalogueTypes, FormName);

template <class Form, class T>
T value(const Vec3<T>& wi, const Vec3<T>& wo, std::span<const double> shape,
        std::span<const double> weights) {
  const auto convert = [](std::span<const double> v) { return std::vector<T>(v.begin(), v.end()); };
  const auto s = from_values<typename Form::template Shape<T>>(std::span<const T>(convert(shape)));
  const auto w = from_values<typename Form::template Weights<T>>(std::span<const T>(convert(weights)));
  return eval(Form{}, w, w, s, geometry(wi, wo));
}

// Visits the parameters at the corners of their tables and at the defaults; of a long table some of them.
template <class Visit>
void for_each_corner(std::span<const ParameterInfo> table, Visit&& visit) {
  constexpr std::size_t kMost = 729, kStep = 2654435761;
  std::vector<double> values;
  const std::size_t all = std::size_t(std::pow(3, table.size()) + 0.5);
  for (std::size_t code = 0; code < std::min(all, kMost); ++code) {
    values.clear();
    std::size_t rest = all > kMost ? code * kStep % all : code;
    for (const ParameterInfo& p : table) {
      values.push_back(rest % 3 == 0 ? p.min : rest % 3 == 1 ? p.usual_max : p.initial);
      rest /= 3;
    }
    visit(values);
  }
}

template <class T>
std::vector<Vec3<T>> extreme_directions() {
  std::vector<Vec3<T>> directions;
  for (double theta : {0.0, 0.5, 1.2, 1.57, 1.5707963, kPi / 2})
    for (double phi : {0.0, 0.7, kPi, 4.0}) {
      const Vec3<double> w = direction(radians(theta), radians(phi));
      directions.push_back({T(w.x), T(w.y), theta == kPi / 2 ? T(0) : T(w.z)});
    }
  return directions;
}

template <class Form, class T>
void expect_finite_at_the_extremes() {
  const ReflectanceInfo& form = info(Form{});
  for_each_corner(form.shape, [&](const std::vector<double>& shape) {
    for_each_corner(form.weights, [&](const std::vector<double>& weights) {
      for (const auto& wi : extreme_directions<T>())
        for (const auto& wo : extreme_directions<T>()) {
          const T f = value<Form, T>(wi, wo, shape, weights);
          ASSERT_TRUE(std::isfinite(f)) << Form::name << " at wi.z " << wi.z << " wo.z " << wo.z;
        }
    });
  });
}

TYPED_TEST(EveryForm, IsFiniteAtTheExtremesInFloat) {
  expect_finite_at_the_extremes<TypeParam, float>();
}
TYPED_TEST(EveryForm, IsFiniteAtTheExtremesInDouble) {
  expect_finite_at_the_extremes<TypeParam, double>();
}

TYPED_TEST(EveryForm, IsFiniteAndNotNegativeUpToTheLargestWeights) {
  const ReflectanceInfo& form = info(TypeParam{});
  for (const double share : {0.003, 0.01, 0.3, 1.0}) {
    std::vector<double> weights;
    for (const ParameterInfo& p : form.weights) weights.push_back(std::max(p.min, share * p.max));
    for_each_corner(form.shape, [&](const std::vector<double>& shape) {
      for (const auto& wi : extreme_directions<double>())
        for (const auto& wo : extreme_directions<double>()) {
          const double f = value<TypeParam, double>(wi, wo, shape, weights);
          ASSERT_TRUE(std::isfinite(f) && (f >= 0 || form.violates("non_negative")))
              << f << " at " << share << " of the weights' ranges";
        }
    });
  }
}

TYPED_TEST(EveryForm, IsZeroBelowTheHorizonAndNotAbove) {
  const Material m = make_material(TypeParam{}, {"y"});
  const Vec3<double> up = direction(radians(0.4), radians(0.2)), down{up.x, up.y, -1e-9}, level{1, 0, 0};
  double f = -1;
  eval(m, down, up, {&f, 1});
  EXPECT_EQ(f, 0.0);
  eval(m, up, down, {&f, 1});
  EXPECT_EQ(f, 0.0);
  eval(m, up, up, {&f, 1});
  EXPECT_GT(f, 0.0);
  eval_cos(m, level, up, {&f, 1});
  EXPECT_TRUE(std::isfinite(f));
}

TYPED_TEST(EveryForm, EvalCosIsEvalTimesTheCosine) {
  const Material m = make_material(TypeParam{}, {"y"});
  const Vec3<double> wi = direction(radians(0.7), radians(0.2)), wo = direction(radians(0.9), radians(2.8));
  double f = 0, f_cos = 0;
  eval(m, wi, wo, {&f, 1});
  eval_cos(m, wi, wo, {&f_cos, 1});
  EXPECT_NEAR(f_cos, f * wi.z, 4e-16 * f_cos);
}

// A form is reciprocal unless it declares otherwise. Exchanging the directions may change only the last bit
// of a sum, hence the bound 1e-14; a form with a declared violation must differ by more than 1e-3.
TYPED_TEST(EveryForm, IsReciprocalUnlessDeclaredOtherwise) {
  bool declared = false;
  for (const Violation& v : info(TypeParam{}).violations) declared |= v.check == "reciprocity";
  const Material m = make_material(TypeParam{}, {"y"});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3<double> wi =
        direction(radians(std::acos(std::pow(10, -6 * unit(random)))), radians(2 * kPi * unit(random)));
    const Vec3<double> wo = direction(radians(std::acos(unit(random))), radians(2 * kPi * unit(random)));
    double there = 0, back = 0;
    eval(m, wi, wo, {&there, 1});
    eval(m, wo, wi, {&back, 1});
    if (there != 0 || back != 0) worst = std::max(worst, std::abs(there - back) / std::max(there, back));
  }
  if (declared)
    EXPECT_GT(worst, 1e-3);
  else
    EXPECT_LT(worst, 1e-14);
}

// The catalogue is derived from the variant alone.
TEST(Catalogue, NamesAreUniqueAndFoundAgain) {
  std::set<std::string_view> names, families, series;
  std::size_t canonical = 0;
  for_each_form([&](auto form) {
    names.insert(form.name);
    // The orders of a basis, and lobes that complete other terms, have no main form.
    const ReflectanceInfo& about = info(form);
    (about.basis || about.about_light ? series : families).insert(form.family);
    canonical += info(form).canonical;
    ASSERT_TRUE(find_form(form.name).has_value());
    EXPECT_EQ(info(*find_form(form.name)).name, form.name);
  });
  EXPECT_EQ(names.size(), kFormCount);
  EXPECT_EQ(canonical, families.size()) << "every family has its own form";
  EXPECT_EQ(series, (std::set<std::string_view>{"matt", "retroreflective"}));
  EXPECT_FALSE(find_form("no_such_form").has_value());
}

TEST(Weights, SchlickIsLinearAndInverts) {
  const SchlickWeights<double> w{0.2, 0.7, 0.3};
  const auto back = SchlickWeights<double>::from_linear(w.linear());
  EXPECT_NEAR(back.ks, w.ks, 1e-16);
  EXPECT_NEAR(back.f0, w.f0, 1e-16);
  const auto none = SchlickWeights<double>::from_linear({0.2, 0, 0});
  EXPECT_EQ(none.f0, 0.04) << "f0 of a lobe without weight is the table's default";
}

TEST(Materials, SumTheirTermsAndTurnWithTheTangent) {
  Material m = make_material(ward{}, {"y"});
  m.terms[0].shape[0] = {0.1, 0.4};
  const Vec3<double> wi = direction(radians(0.5), radians(0.3)), wo = direction(radians(0.6), radians(3.0));
  double plain = 0, turned = 0, twice = 0;
  eval(m, wi, wo, {&plain, 1});
  m.terms[0].tangent_phi = radians(0.8);
  eval(m, direction(radians(0.5), radians(0.3 + 0.8)), direction(radians(0.6), radians(3.0 + 0.8)),
       {&turned, 1});
  EXPECT_NEAR(turned, plain, 1e-14 * plain);
  m.terms[0].tangent_phi = {};
  m.terms.push_back(m.terms[0]);
  eval(m, wi, wo, {&twice, 1});
  EXPECT_EQ(twice, 2 * plain);
}

}  // namespace
}  // namespace brdf
