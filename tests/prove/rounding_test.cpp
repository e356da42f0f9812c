// No sampled rounding error exceeds the proved bound, and the proved bounds agree with docs/proofs.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

#include "prove/proof.h"
#include "prove/scalar/on_rounding.h"
#include "tests/prove/boxes.h"
#include "tests/thorough.h"
#include "tests/typed.h"
#include "validate/numerics/extended.h"

namespace brdf::prove {
namespace {

const int kRoundedBoxes = thorough() ? 20000 : 200;
const int kPointsOfABox = thorough() ? 500 : 20;
const double kGgxFactor = thorough() ? 3 : 3.5;
const long kGgxSamples = thorough() ? 100000000L : 200000L;

template <class B>
using Truth = std::conditional_t<std::is_same_v<B, float>, double, validate::Extended>;

// Numbers at one point, as B stores them and converted to another scalar.
template <class B>
struct Point {
  std::vector<B> shape, weights, first;
  Vec3<B> wi, wo;

  template <class P, class T>
  static P parameters(const std::vector<B>& values) {
    P p{};
    std::size_t k = 0;
    for (const auto& field : P::fields()) p.*(field.member) = number<T>(values[k++]);
    return p;
  }
  template <class T>
  static T number(B x) {
    if constexpr (std::is_same_v<T, Rounded<B>>)
      return T::of(double(x), double(x));
    else
      return T(x);
  }
  template <class T>
  static Vec3<T> vector(const Vec3<B>& w) {
    return {number<T>(w.x), number<T>(w.y), number<T>(w.z)};
  }
  template <class F, class T>
  auto lobes() const {
    using W = typename F::template Weights<T>;
    const double guard = double(B(kMinCosine<B>));
    const auto g = [&] {
      if constexpr (std::is_same_v<T, Rounded<B>>)
        return rounded_geometry(vector<T>(wi), vector<T>(wo));
      else
        return geometry(vector<T>(wi), vector<T>(wo), guard);
    }();
    return lobes_or_value<F>(parameters<W, T>(weights), parameters<W, T>(first),
                             parameters<typename F::template Shape<T>, T>(shape), g);
  }
};

template <class F, class B>
std::optional<Point<B>> point_in(Engine& e, const Domain& domain, const Box& box, const Parts& parts) {
  Point<B> p;
  std::vector<double> at;
  for (std::size_t j = 0; j < box.size(); ++j) {
    at.push_back(anywhere(e, domain.variables[j], box[j]));
    if (j >= parts.directions) continue;
    const B value = B(at.back());
    if (double(value) < box[j].lo || double(value) > box[j].hi) return std::nullopt;
    (j < parts.weights                                             ? p.shape
     : j < parts.weights + F::template Weights<B>::fields().size() ? p.weights
                                                                   : p.first)
        .push_back(value);
  }
  if (p.first.empty()) p.first = p.weights;
  const std::size_t d = parts.directions;
  p.wi = direction_of<B>(e, at[d], at[d + 1]);
  p.wo = direction_of<B>(e, at[d + 2], at[d + 3]);
  return p;
}

struct Found {
  long judged = 0, proved = 0, beyond = 0;
  std::string first;
  std::vector<double> largest;  // the largest error of each lobe, divided by its bound
};

// Draws random boxes and points inside them. Compares the error at the point with the bound of the box, and
// uses the peak at the point if the bound is relative to the peak.
template <class F, class B>
Found sample(int boxes, int points, unsigned seed) {
  const int form = catalogue_index(F{});
  const Domain domain = domain_of(form);
  const Parts parts = parts_of(catalogue()[std::size_t(form)].info(), domain);
  Engine e(seed + unsigned(form));
  Found found;
  for (int b = 0; b < boxes; ++b) {
    const Box box = b % 4 == 0 ? [&] {
      Box all;
      for (const Variable& v : domain.variables) all.push_back({v.low, v.high});
      return all;
    }()
                               : random_box(e, domain);
    const auto bounds =
        rounding_within(form, std::is_same_v<B, float> ? Precision::float_type : Precision::double_type, box);
    for (int k = 0; k < points; ++k) {
      const auto at = point_in<F, B>(e, domain, box, parts);
      if (!at) continue;
      const auto computed = at->template lobes<F, B>();
      const auto truth = at->template lobes<F, Truth<B>>();
      // The peak at the point is computed only if an error needs it. The peak is at least the value.
      std::optional<decltype(at->template lobes<F, Rounded<B>>())> model;
      const auto peak_of = [&](std::size_t lobe) {
        if (!model) model = at->template lobes<F, Rounded<B>>();
        return (*model)[lobe].envelope.hi;
      };
      found.largest.resize(computed.size());
      for (std::size_t j = 0; j < computed.size(); ++j) {
        ++found.judged;
        if (bounds[j].beside == LobeRounding::Beside::nothing) continue;
        ++found.proved;
        const double exact = double(truth[j]);
        const double error = std::fabs(double(Truth<B>(computed[j]) - truth[j]));
        double beside = std::fabs(exact);
        if (bounds[j].beside == LobeRounding::Beside::peak && error > bounds[j].error * beside)
          beside = std::max(beside, peak_of(j));
        // The truth itself is no more accurate than 2e-15 in double and 1e-18 in Extended. The allowance for
        // this error is 1e-13 and 4e-17, relative.
        const double own = beside * (std::is_same_v<B, float> ? 1e-13 : 4e-17);
        const double allowed = bounds[j].error * beside + bounds[j].underflow + own;
        if (beside > 0)
          found.largest[j] = std::max(found.largest[j], error / (bounds[j].error * beside + 1e-300));
        if (error <= allowed) continue;
        if (found.beyond++ > 0) continue;
        std::ostringstream text;
        text.precision(17);
        text << F::name << " lobe " << j << ": " << double(computed[j]) << " for " << exact << ", off by "
             << error / beside << " where " << bounds[j].error << " is proved";
        for (const B x : at->shape) text << ", " << x;
        for (const B x : at->weights) text << ", " << x;
        for (const Vec3<B>& w : {at->wi, at->wo}) text << " (" << w.x << " " << w.y << " " << w.z << ")";
        found.first = text.str();
      }
    }
  }
  return found;
}

template <class F>
class RoundingOf : public testing::Test {};
TYPED_TEST_SUITE(RoundingOf, CatalogueTypes, FormName);

TYPED_TEST(RoundingOf, NoSampleIsAboveTheBound) {
  const Found in_float = sample<TypeParam, float>(kRoundedBoxes / 2, kPointsOfABox, 3);
  const Found in_double = sample<TypeParam, double>(kRoundedBoxes / 2, kPointsOfABox, 4);
  EXPECT_EQ(in_float.beyond, 0) << in_float.beyond << " of " << in_float.proved << "\n" << in_float.first;
  EXPECT_EQ(in_double.beyond, 0) << in_double.beyond << " of " << in_double.proved << "\n" << in_double.first;
}

// The proved bound for V D of GGX is close to the worst sampled error.
template <class B>
double worst_of_ggx(long samples) {
  Engine e(9);
  double worst = 0;
  for (long k = 0; k < samples; ++k) {
    const auto cosine = [&] { return k % 2 == 0 ? uniform(e, 0, 1) : std::exp(uniform(e, -14, 0)); };
    const Roughness<B> a{B(std::exp(uniform(e, -9.2, 0))), B(std::exp(uniform(e, -9.2, 0)))};
    const Vec3<B> wi = direction_of<B>(e, cosine(), uniform(e, -2, 2)),
                  wo = direction_of<B>(e, cosine(), uniform(e, -2, 2));
    const auto lobe = [&]<class T>(T) {
      const auto g = geometry(Vec3<T>{T(wi.x), T(wi.y), T(wi.z)}, Vec3<T>{T(wo.x), T(wo.y), T(wo.z)},
                              double(B(kMinCosine<B>)));
      const Roughness<T> width{T(a.alpha_x), T(a.alpha_y)};
      return quotient(d_ggx(width, g), v_smith_ggx(width, g));
    };
    const Truth<B> truth = lobe(Truth<B>());
    worst = std::max(worst, std::fabs(double((Truth<B>(lobe(B())) - truth) / truth)));
  }
  return worst;
}

TEST(Rounding, OfGgxIsNearTheWorstSample) {
  for (const Precision precision : {Precision::float_type, Precision::double_type}) {
    const int form = catalogue_index(cook_torrance{});
    Box box;
    for (const Variable& v : rounding_domain(form).variables) box.push_back({v.low, v.high});
    const LobeRounding lobe = rounding_of(form, precision, box).at(1);
    const bool in_float = precision == Precision::float_type;
    const double worst = in_float ? worst_of_ggx<float>(kGgxSamples) : worst_of_ggx<double>(kGgxSamples);
    std::cout << name_of(precision) << ": worst of " << kGgxSamples << " samples " << worst << ", proved "
              << lobe.error << '\n';
    ASSERT_EQ(lobe.beside, LobeRounding::Beside::value);
    EXPECT_LE(lobe.error, in_float ? 2.8e-6 : 5e-15);
    EXPECT_LE(worst, lobe.error);
    EXPECT_GE(worst * kGgxFactor, lobe.error);
  }
}

// The bound is proved for all lobes of at least 18 forms in both precisions, and for at least six forms
// relative to the value.
TEST(Rounding, IsProvedOfMostForms) {
  Options options;
  options.properties = {Property::rounding};
  int proved = 0, relative = 0;
  for (const Reflectance& form : catalogue())
    for (const Proof& p : prove(form, options)) {
      if (p.verdict != Verdict::proved) {
        EXPECT_EQ(p.verdict, Verdict::no_method);
        continue;
      }
      ++proved;
      relative += std::ranges::all_of(
          p.lobes, [](const LobeRounding& l) { return l.beside == LobeRounding::Beside::value; });
      EXPECT_LT(p.high, p.claim.precision == Precision::float_type ? 2.5e-5 : 5e-14) << p.form;
    }
  EXPECT_GE(proved, 2 * 18);
  EXPECT_GE(relative, 2 * 6);
}

// The analysis accepts neither a formula with cancellation as free of cancellation nor a step as
// continuous.
TEST(Rounding, CancellationIsNotProved) {
  using R = Rounded<double>;
  const R x = R::of(0, 1), y = R::of(0, 1);
  EXPECT_FALSE((x * y - y * y).relative.known());
  EXPECT_FALSE((R(1) / (x * y + R(1) - R(1))).absolute < 1e300);
  EXPECT_FALSE(select(x * y < y * y, R(0), R(1)).absolute < 1e300);
  EXPECT_TRUE((x + y).relative.known());
  EXPECT_NEAR((x + y).relative.error, R::kUnit, 1e-25);
  EXPECT_GE((x * y).relative.underflow, 4e-324);
}

}  // namespace
}  // namespace brdf::prove
