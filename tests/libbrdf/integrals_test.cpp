// Directional albedos against closed forms and published values, and with two quadrature rules if both
// apply.
#include "brdf/integrals.h"
#include "brdf/forms.h"
#include "tests/thorough.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brdf {
namespace {

Term term_of(const Reflectance& form, std::vector<double> shape, std::vector<double> weights) {
  return {form, {std::move(shape)}, {std::move(weights)}};
}
Term mirror_like_ggx(double alpha_x, double alpha_y) {  // F = 1
  return term_of(cook_torrance{}, {alpha_x, alpha_y}, {0, 1, 1});
}

AlbedoResult albedo(const Term& term, double theta, double phi = 0, double tolerance = 1e-10,
                    Rule rule = Rule::automatic) {
  AlbedoOptions options;
  options.tolerance = tolerance;
  options.rule = rule;
  return directional_albedo(term, 0, degrees(theta), degrees(phi), options);
}

// The albedo must agree with `expected` within the printed digits of that value (or 1e-10), and within the
// integral's own error bound plus these digits.
void expect_albedo(const Term& term, double degrees, double expected, double digits = 1e-10, double phi = 0) {
  const AlbedoResult r = albedo(term, degrees, phi);
  EXPECT_TRUE(r.converged) << r.error_bound << " after " << r.evaluations;
  EXPECT_NEAR(r.value, expected, digits)
      << "at " << degrees << " degrees, " << r.evaluations << " evaluations";
  EXPECT_LE(std::abs(r.value - expected), r.error_bound + digits);
}

TEST(Albedo, OfLambertIsRho) {
  for (const double theta : {0.0, 30.0, 89.0, 90.0})
    expect_albedo(term_of(lambert{}, {}, {0.75}), theta, 0.75, 1e-13);
}

TEST(Albedo, OfPhongMatchesTheClosedForms) {
  const auto phong_of = [](double n) { return term_of(phong{}, {n}, {0, 1}); };
  expect_albedo(phong_of(10), 0, 1);
  expect_albedo(phong_of(10), 30, .86602853, 5e-9);
  expect_albedo(phong_of(10), 60, .50473595, 5e-9);
  expect_albedo(phong_of(10), 90, .12304688, 5e-9);
  for (const double n : {0.3, 1.0, 4.5, 30.0, 1e4})
    expect_albedo(
        phong_of(n), 90,
        (n + 2) * std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2 + 2)) / (4 * std::sqrt(kPi)));
  for (const double theta : {0.0, 20.0, 70.0, 89.0})
    expect_albedo(phong_of(0), theta, (1 + std::cos(degrees(theta).radians())) / 2);
}

TEST(Albedo, OfBlinnPhongMatchesThePublishedValues) {
  const auto blinn_of = [](double n) { return term_of(blinn_phong{}, {n}, {0, 1}); };
  for (const double n : {0.0, 1.0, 8.764, 1000.0, 1e6}) expect_albedo(blinn_of(n), 0, 1);
  expect_albedo(blinn_of(10), 30, .804640070110);
  expect_albedo(blinn_of(10), 60, .400323695483);
  expect_albedo(blinn_of(50), 30, .760003008300);
  expect_albedo(blinn_of(50), 60, .280649183625);
}

TEST(Albedo, OfGgxMatchesTheClosedFormAtNormalIncidence) {
  expect_albedo(mirror_like_ggx(1, 1), 0, 1 - std::log(2.0));
  expect_albedo(mirror_like_ggx(.1, .1), 0, .988304056520612);
  expect_albedo(mirror_like_ggx(.25, .25), 0, .915812430249750);
  expect_albedo(mirror_like_ggx(.5, .5), 0, .687848515110236);
}

TEST(Albedo, OfGgxMatchesThePublishedValuesAtAnAngle) {
  expect_albedo(mirror_like_ggx(.1, .1), 30, .98608694349477);
  expect_albedo(mirror_like_ggx(.1, .1), 60, .96920498441169);
  expect_albedo(mirror_like_ggx(.1, .1), 85, .88638129863219);
  expect_albedo(mirror_like_ggx(.01, .01), 60, .99974212259913);
  expect_albedo(mirror_like_ggx(.01, .01), 89, .90483783976559);
  expect_albedo(mirror_like_ggx(.5, .5), 60, .69825069692755);
  expect_albedo(mirror_like_ggx(1, 1), 60, .45069385566595);
}

TEST(Albedo, OfAnisotropicGgxMatchesTheClosedForm) {
  expect_albedo(mirror_like_ggx(.1, .3), 0, .929819878192003);
  expect_albedo(mirror_like_ggx(.3, .1), 0, .929819878192003);
  expect_albedo(mirror_like_ggx(.05, .5), 0, .821825242883966);
}

TEST(Albedo, OfWardMatchesTheClosedForm) {
  const auto ward_of = [](double a) { return term_of(ward{}, {a, a}, {0, 1}); };
  expect_albedo(ward_of(.1), 0, .971051675567060);
  expect_albedo(ward_of(.5), 0, .585490376444347);
  expect_albedo(ward_of(1), 0, .256445212511538);
}

TEST(Albedo, OfOrenNayarMatchesTheClosedForm) {
  for (const double sigma : {0.05, 0.198533, 0.5, 1.5}) {
    const double s2 = sigma * sigma, a = 1 - .5 * s2 / (s2 + .33), b = .45 * s2 / (s2 + .09);
    const Term term = term_of(oren_nayar{}, {sigma}, {1});
    for (const double theta : {0.0, 1.0, 45.0, 80.0, 89.9}) {
      const double t = degrees(theta).radians(), s = std::sin(t), c = std::cos(t);
      expect_albedo(term, theta,
                    a + b / kPi * (s * (t - s * c) + 2.0 / 3 * s * c * (1 + s + s * s) / (1 + s)));
    }
    expect_albedo(term, 90, a + b / 2);
  }
}

// The rules share only the form. Their variables and panels differ, so a common error is unlikely.
TEST(Albedo, AgreesBetweenIndependentRules) {
  BRDF_LONG_UNDER_SANITIZERS();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 20; ++k) {
    const double alpha = std::pow(10, -3 * unit(random)), theta = 88 * unit(random);
    const Term term = k % 2 ? mirror_like_ggx(alpha, alpha) : term_of(ward{}, {alpha, alpha}, {0, 1});
    const AlbedoResult pole = albedo(term, theta, 0, 1e-9), slope = albedo(term, theta, 0, 1e-9, Rule::slope),
                       adaptive = albedo(term, theta, 0, 1e-6, Rule::adaptive);
    EXPECT_NEAR(pole.value, slope.value, 2e-9 * pole.value) << "alpha " << alpha << " theta " << theta;
    EXPECT_NEAR(pole.value, adaptive.value, adaptive.error_bound + 1e-9)
        << "alpha " << alpha << " theta " << theta;
  }
}

TEST(Albedo, OfAnisotropicLobesAgreesBetweenIndependentRules) {
  BRDF_LONG_UNDER_SANITIZERS();
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int k = 0; k < 20; ++k) {
    const double ax = std::pow(10, -2 * unit(random)), ay = std::pow(10, -2 * unit(random));
    const double theta = 89 * unit(random), phi = 360 * unit(random);
    const Term term = k % 2 ? mirror_like_ggx(ax, ay) : term_of(ward{}, {ax, ay}, {0, 1});
    const AlbedoResult slope = albedo(term, theta, phi, 1e-8),
                       adaptive = albedo(term, theta, phi, 1e-6, Rule::adaptive);
    EXPECT_TRUE(slope.converged) << ax << " " << ay << " " << theta << " " << phi << " " << slope.evaluations;
    EXPECT_NEAR(slope.value, adaptive.value, adaptive.error_bound + 1e-8 * slope.value)
        << ax << " " << ay << " " << theta << " " << phi;
  }
}

// A column of cells with a constant integrand is counted once, not once per cell.
TEST(Albedo, ByBisectionCountsADiffuseTermOnce) {
  BRDF_LONG_UNDER_SANITIZERS();
  for (const double theta : {0.0, 30.0, 75.0})
    EXPECT_NEAR(albedo(term_of(lambert{}, {}, {0.5}), theta, 0, 1e-10, Rule::adaptive).value, 0.5, 1e-14);
  const Term term = make_term(cook_torrance{}, 1);  // kd 0.5
  const AlbedoResult slope = albedo(term, 30, 0, 1e-10, Rule::slope),
                     adaptive = albedo(term, 30, 0, 1e-10, Rule::adaptive);
  EXPECT_NEAR(slope.value, 0.51758933786028, 1e-13);
  EXPECT_NEAR(adaptive.value, slope.value, adaptive.error_bound + slope.error_bound);
}

// Near the normal the kink of the V-cavities turns back at the ridge of the lobe.
TEST(Albedo, OfAnisotropicVCavitiesLiesWithinItsBound) {
  BRDF_LONG_UNDER_SANITIZERS();
  struct {
    double alpha_x, alpha_y, theta, phi;
  } const cases[] = {
      {.10009, .3, 0, 0}, {.153, .413, 0, 270.2}, {.105, .261, 3.23, 0}, {.1185, .1337, 0, 286.7}};
  for (const auto& c : cases)
    for (const double tolerance : {1e-4, 1e-6}) {
      const Term term = term_of(cook_torrance_1982{}, {c.alpha_x, c.alpha_y}, {0.5, 0.5, 0.04});
      const AlbedoResult rough = albedo(term, c.theta, c.phi, tolerance),
                         fine = albedo(term, c.theta, c.phi, 1e-12);
      EXPECT_LE(std::abs(rough.value - fine.value), rough.error_bound) << c.alpha_x << ' ' << c.theta;
      EXPECT_LE(rough.error_bound, tolerance * rough.value);
      EXPECT_LE(rough.evaluations, 20000);
    }
}

// The lobe of phong lies about the mirror direction, so the pole rule integrates it even if the slope rule
// is requested. Bisection (the adaptive rule) is used for a form that no other rule knows.
TEST(Albedo, IsIntegratedByARuleThatKnowsTheLobe) {
  BRDF_LONG_UNDER_SANITIZERS();
  EXPECT_EQ(albedo(make_term(phong{}, 1), 80, 0, 1e-6, Rule::slope).rule, Rule::pole);
  EXPECT_EQ(albedo(make_term(oren_nayar{}, 1), 80, 0, 1e-6, Rule::slope).rule, Rule::pole);
  EXPECT_EQ(albedo(make_term(cook_torrance{}, 1), 90).rule, Rule::slope);
  EXPECT_EQ(albedo(make_term(cook_torrance_as_coded{}, 1), 30).rule, Rule::adaptive);
}

TEST(Albedo, OfAMaterialIsTheSumOfItsTerms) {
  Material material = make_material(lambert{});
  material.terms.push_back(make_term(cook_torrance{}, 3));
  const auto whole = directional_albedo(material, radians(0.5), {});
  ASSERT_EQ(whole.size(), 3u);
  const double parts = directional_albedo(material.terms[0], 0, radians(0.5), {}).value +
                       directional_albedo(material.terms[1], 0, radians(0.5), {}).value;
  EXPECT_NEAR(whole[0].value, parts, 1e-12);
}

TEST(Albedo, TurnsWithTheTangent) {
  Term term = mirror_like_ggx(.05, .4);
  const double straight = albedo(term, 60, 25).value;
  term.tangent_phi = degrees(40);
  EXPECT_NEAR(albedo(term, 60, 65).value, straight, 1e-11);
  EXPECT_GT(std::abs(albedo(term, 60, 25).value - straight), 1e-3);
}

TEST(Albedo, SaysWhenItDidNotConverge) {
  AlbedoOptions options;
  options.tolerance = 1e-10;
  options.max_evaluations = 2000;
  const AlbedoResult r = directional_albedo(mirror_like_ggx(.001, .001), 0, degrees(89.9), {}, options);
  EXPECT_FALSE(r.converged);
  EXPECT_GT(r.error_bound, 1e-10);
}

TEST(Albedo, BisectionOverlooksNeitherAKinkInACornerNorAGrazingPeak) {
  BRDF_LONG_UNDER_SANITIZERS();
  struct {
    Reflectance form;
    double alpha_x, alpha_y, theta, phi;
  } const cases[] = {{cook_torrance_vcavity{}, 0.06824427988, 0.0158948521, 88.06148022, 171.9173179},
                     {cook_torrance_vcavity{}, 0.002896076052, 0.005656746074, 89.65571271, 213.6625411},
                     {ward{}, 0.7213000297, 0.3206005208, 89.78940869, 104.6609792},
                     {cook_torrance{}, 0.9983091946, 0.7759487069, 88.051867, 218.9049179}};
  for (const auto& c : cases) {
    Term term = make_term(c.form, 1);
    term.shape[0][0] = c.alpha_x;
    term.shape[0][1] = c.alpha_y;
    term.weights[0][0] = 0;  // kd
    const double slope = albedo(term, c.theta, c.phi, 1e-9).value;
    const AlbedoResult other = albedo(term, c.theta, c.phi, 1e-7, Rule::adaptive);
    EXPECT_NEAR(other.value / slope, 1, 1e-7) << info(c.form).name << " at " << c.theta;
    EXPECT_TRUE(other.converged);
    EXPECT_EQ(other.rule, Rule::adaptive);
  }
}

TEST(AverageAlbedo, OfLambertIsRho) {
  const AlbedoResult r = average_albedo(term_of(lambert{}, {}, {0.3}), 0);
  EXPECT_NEAR(r.value, 0.3, 1e-7);
  EXPECT_TRUE(r.converged);
}

}  // namespace
}  // namespace brdf
