// The batch functions return the same values as the scalar template, bit for bit, for every form of the
// catalogue.
#include "tests/typed.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "brdf/dual.h"

namespace brdf {
namespace {

template <class Form>
struct Batch : ::testing::Test {};
TYPED_TEST_SUITE(Batch, CatalogueTypes, FormName);

constexpr std::size_t kDirections = 1003;  // not a multiple of any vector length

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution(low, high)(random);
}

// Random pairs of directions. Every fifth is near the horizon, some lie below the horizon and some exactly
// on it.
template <class T>
DirectionArrays<T> random_directions(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto one = [&](std::size_t i) {
    const double theta = i % 5 == 0 ? kPi / 2 - 1e-3 * between(random, -0.2, 1) : between(random, 0, kPi / 2);
    const Vec3<double> w = direction(radians(theta), radians(between(random, 0, 2 * kPi)));
    return Vec3<T>{T(w.x), T(w.y), i % 50 == 0 ? T(0) : T(w.z)};
  };
  DirectionArrays<T> directions(kDirections);
  for (std::size_t i = 0; i < kDirections; ++i) {
    const Vec3<T> wi = one(i);
    directions.set(i, wi, i % 7 == 0 ? Vec3<T>{-wi.x, -wi.y, wi.z} : one(i + i / 5));
  }
  return directions;
}

template <class P>
P random_parameters(unsigned seed) {
  std::mt19937_64 random(seed);
  P p{};
  for (const auto& field : P::fields()) {
    const ParameterInfo& info = field.info;
    p.*(field.member) = scalar_of<P>(info.log_scale && info.min > 0
                                         ? std::exp(between(random, std::log(info.min), std::log(info.max)))
                                         : between(random, usual_min(info), info.usual_max));
  }
  return p;
}

// Two NaN count as equal here: the test is about bits, and the payload of a NaN is not promised.
template <class T>
void expect_same_bits(T batch, T scalar, std::size_t i) {
  using Bits = kernels::Precision<T>::Bits;
  if (std::isnan(batch) && std::isnan(scalar)) return;
  ASSERT_EQ(std::bit_cast<Bits>(batch), std::bit_cast<Bits>(scalar))
      << "pair " << i << ": " << batch << " and " << scalar;
}

template <class F, class T>
void expect_values_as_scalar() {
  using Weights = typename F::template Weights<T>;
  using Shape = typename F::template Shape<T>;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto arrays = random_directions<T>(seed);
    const Directions<T> d = arrays.view();
    const Weights w = random_parameters<Weights>(10 * seed);
    const Weights first = random_parameters<Weights>(10 * seed + 1);
    const Shape shape = random_parameters<Shape>(10 * seed + 2);
    std::vector<T> f(kDirections), f_cos(kDirections);
    const auto own = to_values<T>(w), of_first = to_values<T>(first);
    const auto of_shape = to_values<T>(shape);
    const ParameterValues<T> values{own, of_first, of_shape};
    const Reflectance form = F{};
    form->eval(values, d, f.data());
    form->eval_cos(values, d, f_cos.data());
    for (std::size_t i = 0; i < kDirections; ++i) {
      const Geometry<T> g = geometry(d.wi(i), d.wo(i));
      expect_same_bits(f[i], eval(F{}, w, first, shape, g), i);
      expect_same_bits(f_cos[i], eval_cos(F{}, w, first, shape, g), i);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TYPED_TEST(Batch, EqualsTheScalarTemplateInDouble) {
  expect_values_as_scalar<TypeParam, double>();
}
TYPED_TEST(Batch, EqualsTheScalarTemplateInFloat) {
  expect_values_as_scalar<TypeParam, float>();
}

template <class F>
void expect_lobes_as_scalar() {
  using Shape = typename F::template Shape<double>;
  constexpr std::size_t P = parameter_count<Shape>, K = lobe_count<F>, D = P + 1;
  using S = Dual<double, int(P)>;
  const auto arrays = random_directions<double>(7);
  const Directions<double> d = arrays.view();
  const Shape shape = random_parameters<Shape>(8);
  const std::size_t stride = kDirections + 13;
  const auto rows = [&](Partial partial, std::size_t partials) {
    std::vector<double> values(K * (1 + partials) * stride, -1.0);
    Reflectance(F{})->lobes(to_values<double>(shape), partial, d, {values.data(), stride});
    return values;
  };
  const auto plain = rows(Partial::none, 0), by_shape = rows(Partial::shape, P),
             by_all = rows(Partial::shape_and_phi, D);

  const auto values = to_values<double>(shape);
  std::array<S, P> variables;
  for (std::size_t j = 0; j < P; ++j) variables[j] = S::variable(values[j], j);
  const auto dual_shape = from_values<typename F::template Shape<S>>(std::span<const S>(variables));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const Geometry<double> g = geometry(d.wi(i), d.wo(i));
    const bool below = g.lowest < 0;
    const auto scalar = F::lobes(shape, g);
    const auto dual = F::lobes(dual_shape, g);
    for (std::size_t k = 0; k < K; ++k) {
      expect_same_bits(plain[k * stride + i], below ? 0.0 : scalar[k], i);
      expect_same_bits(by_shape[k * (1 + P) * stride + i], below ? 0.0 : dual[k].a, i);
      expect_same_bits(by_all[k * (1 + D) * stride + i], below ? 0.0 : dual[k].a, i);
      for (std::size_t j = 0; j < P; ++j)
        expect_same_bits(by_shape[(k * (1 + P) + 1 + j) * stride + i], below ? 0.0 : dual[k].v[j], i);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TYPED_TEST(Batch, LobesAndShapeDerivativesEqualTheScalarTemplate) {
  if constexpr (LinearForm<TypeParam>) {
    expect_lobes_as_scalar<TypeParam>();
  } else {
    EXPECT_TRUE(info(TypeParam{}).lobes.empty());
  }
}

TYPED_TEST(Batch, DerivativeByTangentPhiIsTheSlopeOfTurnedDirections) {
  if constexpr (LinearForm<TypeParam>) {
    using Shape = typename TypeParam::template Shape<double>;
    constexpr std::size_t K = lobe_count<TypeParam>, D = parameter_count<Shape> + 1;
    // Pairs well above the horizon and moderate widths, for which the difference quotient is accurate.
    std::mt19937_64 random(3);
    DirectionArrays<double> arrays(200), turned(200);
    for (std::size_t i = 0; i < arrays.size(); ++i)
      arrays.set(i, direction(radians(between(random, 0, 1.2)), radians(between(random, 0, 2 * kPi))),
                 direction(radians(between(random, 0, 1.2)), radians(between(random, 0, 2 * kPi))));
    Shape shape{};
    for (const auto& field : Shape::fields()) shape.*(field.member) = field.info.initial;
    if constexpr (requires { shape.alpha_y; }) shape.alpha_y = 0.2;

    std::vector<double> rows(K * (1 + D) * arrays.size());
    const Reflectance form = TypeParam{};
    const auto shape_values = to_values<double>(shape);
    form->lobes(shape_values, Partial::shape_and_phi, arrays.view(), {rows.data(), arrays.size()});
    const auto lobes_at = [&](double phi) {
      turn_batch(arrays.view(), radians(phi), turned);
      std::vector<double> values(K * arrays.size());
      form->lobes(shape_values, Partial::none, turned.view(), {values.data(), arrays.size()});
      return values;
    };
    const double step = 1e-5;
    const auto low = lobes_at(-step), high = lobes_at(step);
    for (std::size_t k = 0; k < K; ++k)
      for (std::size_t i = 0; i < arrays.size(); ++i) {
        const double slope = rows[(k * (1 + D) + D) * arrays.size() + i];
        const std::size_t at = k * arrays.size() + i;
        EXPECT_NEAR(slope, (high[at] - low[at]) / (2 * step), 1e-7 * (1 + std::abs(slope)));
      }
  }
}

TYPED_TEST(Batch, TermsAreSeenFromTheirTurnedFrame) {
  Material material = make_material(TypeParam{});
  Term& term = material.terms[0];
  for (std::size_t c = 0; c < 3; ++c)
    for (double& weight : term.weights[c]) weight *= 0.2 + 0.3 * double(c);
  term.tangent_phi = radians(0.4);
  const double cosine = std::cos(0.4), sine = std::sin(0.4);
  const auto arrays = random_directions<double>(5);
  const Directions<double> d = arrays.view();
  const auto first = typed_weights(TypeParam{}, term, 0);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto weights = typed_weights(TypeParam{}, term, c);
    const auto shape = typed_shape(TypeParam{}, term, c);
    std::vector<double> f(kDirections), f_cos(kDirections);
    eval_batch(term, c, d, f.data());
    eval_cos_batch(term, c, d, f_cos.data());
    for (std::size_t i = 0; i < kDirections; ++i) {
      const auto g = geometry(turn(d.wi(i), cosine, sine), turn(d.wo(i), cosine, sine));
      expect_same_bits(f[i], eval(TypeParam{}, weights, first, shape, g), i);
      expect_same_bits(f_cos[i], eval_cos(TypeParam{}, weights, first, shape, g), i);
      double of_material[3];
      eval(material, d.wi(i), d.wo(i), of_material);
      expect_same_bits(f[i] + 0.0, of_material[c], i);
      if (this->HasFatalFailure()) return;
    }
  }
}

TYPED_TEST(Batch, TermsInFloatAreTheirFormInFloat) {
  Term term = make_term(TypeParam{}, 2);
  for (double& weight : term.weights[1]) weight *= 0.3;
  term.tangent_phi = radians(0.4);
  const auto arrays = random_directions<float>(6);
  const Directions<float> d = arrays.view();
  DirectionArrays<float> turned(kDirections);
  const float cosine = float(std::cos(0.4)), sine = float(std::sin(0.4));
  for (std::size_t i = 0; i < kDirections; ++i)
    turned.set(i, turn(d.wi(i), cosine, sine), turn(d.wo(i), cosine, sine));
  const auto rounded = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  const std::vector<float> weights = rounded(term.weights[1]), first = rounded(term.weights[0]);
  const std::vector<float> shape = rounded(term.shape[0]);
  const ParameterValues<float> values{weights, first, shape, 1};
  std::vector<float> f(kDirections), f_cos(kDirections), own(kDirections), own_cos(kDirections);
  term.form->eval(values, turned.view(), own.data());
  term.form->eval_cos(values, turned.view(), own_cos.data());
  eval_batch(term, 1, d, f.data());
  eval_cos_batch(term, 1, d, f_cos.data());
  for (std::size_t i = 0; i < kDirections; ++i) {
    expect_same_bits(f[i], own[i], i);
    expect_same_bits(f_cos[i], own_cos[i], i);
    if (this->HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace brdf
