// Forms with one planted fault each. No such form is proved.
#include <gtest/gtest.h>

#include "brdf/fresnel.h"
#include "brdf/reflectance_of.h"
#include "prove/scalar/on_box.h"
#include "prove/scalar/on_graph.h"
#include "prove/search.h"

namespace brdf::prove {
namespace {

template <FixedName kName, template <class> class WeightsOf, template <class> class ShapeOf, class Lobes>
auto planted(Lobes) {
  return brdf::detail::LobesForm<kName, WeightsOf, ShapeOf, Lobes>{};
}

template <class F>
Domain domain_for() {
  Domain domain;
  for (const auto& field : F::template Shape<double>::fields())
    domain.variables.push_back(
        {std::string(field.info.name), field.info.min, field.info.max, Variable::Cut::middle});
  for (const auto& field : F::template Weights<double>::fields())
    domain.variables.push_back(
        {std::string(field.info.name), field.info.min, field.info.max, Variable::Cut::middle, true});
  for (int k = 0; k < 2; ++k) {
    domain.variables.push_back({"cos", 0, 1, Variable::Cut::cosine});
    domain.variables.push_back({"turn", -2, 2, Variable::Cut::middle});
  }
  return domain;
}

enum class What { finite, non_negative };

template <class F>
bool is_proved(F, What what) {
  const Cover found = cover(
      domain_for<F>(), [](const Box& box) { return enclose<F, double>(box); },
      [&](Bounds b) { return std::isfinite(b.lo) && (what == What::finite || b.lo >= 0); }, {500, 5});
  return found.open == 0;
}
template <class F>
bool is_reciprocal(F form) {
  return record(form, Rules::exact, 1000).same;
}

#define LOBES(expression)                                         \
  [](const auto& a, const auto& g) {                              \
    using S = std::remove_cvref_t<decltype(a.alpha_x + g.cos_i)>; \
    (void)a;                                                      \
    return std::array<S, 2>{S(1 / kPi), expression};              \
  }

TEST(Planted, TheFormWithoutFaultIsProved) {
  const auto form =
      planted<"right", LobeWeights, Roughness>(LOBES(quotient(d_ggx(a, g), v_smith_ggx(a, g)) * schlick(g)));
  EXPECT_TRUE(is_proved(form, What::finite));
  EXPECT_TRUE(is_proved(form, What::non_negative));
  EXPECT_TRUE(is_reciprocal(form));
}

TEST(Planted, FaultsOfSign) {
  EXPECT_FALSE(
      is_proved(planted<"missing_clamp", LobeWeights, Roughness>(LOBES(S(1) - g.cos_d)), What::non_negative));
  EXPECT_FALSE(is_proved(planted<"fresnel_sign", LobeWeights, Roughness>(LOBES(a.alpha_x - S(0.5))),
                         What::non_negative));
  EXPECT_FALSE(is_proved(planted<"azimuth", LobeWeights, Roughness>(
                             LOBES(S(1) + tangential_product(g) / larger(g.cos_i, g.cos_o))),
                         What::non_negative));
  EXPECT_FALSE(is_proved(planted<"power_of_fresnel", LobeWeights, Roughness>(
                             LOBES(quotient(d_ggx(a, g), v_smith_ggx(a, g)) * (S(0.9) - g.cos_d))),
                         What::non_negative));
}

TEST(Planted, FaultsOfRange) {
  EXPECT_FALSE(is_proved(
      planted<"sign_in_g", LobeWeights, Roughness>(
          LOBES(S(0.5) / (g.cos_o * stretched_length(a, g.wi) - g.cos_i * stretched_length(a, g.wo)))),
      What::finite));
  EXPECT_FALSE(
      is_proved(planted<"no_grazing_guard", LobeWeights, Roughness>(LOBES(S(1) / g.lowest)), What::finite));
  EXPECT_FALSE(is_proved(planted<"sign_of_exponent", LobeWeights, Roughness>(
                             LOBES(math::exp(scaled_tangent2(a, g) / square(g.h.z)))),
                         What::finite));
  EXPECT_FALSE(
      is_proved(planted<"pole", LobeWeights, Roughness>(LOBES(S(1) / (a.alpha_x - S(0.3)))), What::finite));
  EXPECT_FALSE(
      is_proved(planted<"logarithm", LobeWeights, Roughness>(LOBES(math::log(g.lowest))), What::finite));
  EXPECT_FALSE(is_proved(planted<"root", LobeWeights, Roughness>(LOBES(math::sqrt(S(1) - g.cos_d * g.cos_d))),
                         What::finite));
}

TEST(Planted, FaultsOfSymmetry) {
  EXPECT_FALSE(is_reciprocal(planted<"cos_i_for_cos_o", LobeWeights, Roughness>(LOBES(quotient(
      d_ggx(a, g),
      Fraction<S>{S(0.5), g.cos_i * stretched_length(a, g.wi) + g.cos_i * stretched_length(a, g.wo)})))));
  EXPECT_FALSE(is_reciprocal(planted<"fresnel_at_the_viewer", LobeWeights, Roughness>(
      LOBES(quotient(d_ggx(a, g), v_smith_ggx(a, g)) * square(S(1) - g.cos_o)))));
  EXPECT_FALSE(is_reciprocal(planted<"one_masking", LobeWeights, Roughness>(
      LOBES(g.cos_i / (g.cos_i + stretched_length(a, g.wi))))));
}

}  // namespace
}  // namespace brdf::prove
