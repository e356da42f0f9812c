// Tests that a reflectance outside of all lists, made from a lambda, works in every folder of the project.
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/integrals.h"
#include "brdf/microfacet.h"
#include "brdf/reflectance_of.h"
#include "fit/fit.h"
#include "io/material/glsl.h"
#include "synth/instrument.h"
#include "validate/form/checks.h"
#ifdef BRDF_HAS_RENDER
#include "render/picture/picture.h"
#include "render/reference/reference.h"
#endif

namespace brdf {
namespace {

// Returns a cosine lobe about the half vector with Schlick's Fresnel term. No form of the catalogue has
// this combination.
Reflectance glimmer() {
  return reflectance_from<"glimmer", SchlickWeights, Exponent>([](const auto& shape, const auto& g) {
    using S = std::remove_cvref_t<decltype(shape.exponent)>;
    const auto cos_h2 = g.h.z * g.h.z / g.h2;
    const S lobe = (shape.exponent + S(8)) * S(1 / (8 * kPi)) * math::pow(S(cos_h2), S(0.5) * shape.exponent);
    return std::array<S, 3>{S(1 / kPi), lobe, lobe * schlick(g)};
  });
}

constexpr double kDiffuse = 0.3, kGloss = 0.4, kNormal = 0.06, kExponent = 35;

Material glossy(std::vector<std::string> channels) {
  Material m = make_material(glimmer(), std::move(channels));
  for (std::vector<double>& weights : m.terms[0].weights) weights = {kDiffuse, kGloss, kNormal};
  m.terms[0].shape[0] = {kExponent};
  return m;
}

TEST(OutsideTheCatalogue, IsInNoList) {
  EXPECT_EQ(catalogue_index(glimmer()), -1);
  EXPECT_FALSE(find_form("glimmer").has_value());
}

TEST(OutsideTheCatalogue, IsEvaluated) {
  const Vec3<double> wi = direction(40_deg, 0_deg), wo = direction(20_deg, 180_deg);
  double f = 0;
  eval(glossy({"fr"}), wi, wo, std::span(&f, 1));
  const Vec3<double> h{wi.x + wo.x, wi.y + wo.y, wi.z + wo.z};
  const double length = std::sqrt(h.x * h.x + h.y * h.y + h.z * h.z), cos_h = h.z / length,
               cos_d = length / 2;
  const double fresnel = kNormal + (1 - kNormal) * std::pow(1 - cos_d, 5);
  EXPECT_NEAR(f, kDiffuse / kPi + kGloss * fresnel * (kExponent + 8) / (8 * kPi) * std::pow(cos_h, kExponent),
              1e-14);
}

TEST(OutsideTheCatalogue, HasAnAlbedoWithinItsBound) {
  const Term term = glossy({"fr"}).terms[0];
  const AlbedoResult one = directional_albedo(term, 0, 50_deg, 0_deg);
  const AlbedoResult other =
      directional_albedo(term, 0, 50_deg, 0_deg, {.tolerance = 1e-8, .rule = Rule::adaptive});
  EXPECT_TRUE(one.converged);
  EXPECT_LE(std::abs(one.value - other.value), one.error_bound + other.error_bound);
  EXPECT_GT(one.value, kDiffuse);
}

TEST(OutsideTheCatalogue, IsJudgedByEveryCheck) {
  std::size_t passed = 0;
  for (const validate::Finding& f : validate::run_checks({validate::Subject::form(glimmer())}, {})) {
    passed += f.outcome == validate::Outcome::pass;
    EXPECT_TRUE(f.outcome != validate::Outcome::fail || f.check == "energy")
        << f.check << ": " << f.statement;
  }
  EXPECT_GE(passed, 6u);
}

TEST(OutsideTheCatalogue, IsMeasuredAndFittedBackToSixDigits) {
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere"};
  const io::SampleTable table = synth::measure(glossy({"fr"}), instrument);
  const fit::FitResult result = fit::fit(table, {{glimmer()}}, {});
  const fit::FormFit& best = result.ranking.front();
  EXPECT_EQ(best.verdict, fit::Verdict::converged);
  const Term& term = best.material.terms[0];
  const double truth[] = {kDiffuse, kGloss, kNormal};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(term.weights[0][k] / truth[k], 1, 1e-6);
  EXPECT_NEAR(term.shape[0][0] / kExponent, 1, 1e-6);
}

TEST(OutsideTheCatalogue, IsWrittenAsGlsl) {
  const std::string text = io::glsl_source(glossy({"r", "g", "b"}));
  EXPECT_NE(text.find("vec3 brdf_eval_glimmer(vec3 wi, vec3 wo, float exponent"), std::string::npos);
  EXPECT_NE(text.find("vec3 brdf_material(vec3 wi, vec3 wo)"), std::string::npos);
}

#ifdef BRDF_HAS_RENDER
// The deferred renderer draws it, too: tests/render/driver/strangers_driver.cpp.
TEST(OutsideTheCatalogue, IsRendered) {
  render::Scene scene = render::material_scene({{"m", glossy({"r", "g", "b"})}});
  scene.camera.width = scene.camera.height = 64;
  const render::Picture picture = render::render_reference(render::prepare(scene));
  EXPECT_GT(picture.at(32, 32).r, 0.03f);
}
#endif

}  // namespace
}  // namespace brdf
