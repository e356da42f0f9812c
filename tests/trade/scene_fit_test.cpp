// Tests fits to the directions that a scene shows.
#include "trade/recommend/scene_fit.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include "io/files/error.h"
#include "trade/questions/ball.h"
#include "trade/questions/materials.h"
#include "trade/questions/variants.h"

namespace brdf::trade {
namespace {

Material glossy(double alpha) {
  Material m = make_material(cook_torrance{}, {"r", "g", "b"});
  m.terms[0].shape[0] = {alpha, alpha};
  for (auto& w : m.terms[0].weights) w = {0.2, 0.7, 0.1};
  return m;
}

TEST(SceneFit, LitPointsLieAboveBothHorizons) {
  const SceneView view = view_of(material_ball(48));
  ASSERT_GT(view.points.size(), 400u);
  for (const render::LitPoint& p : view.points) {
    EXPECT_GT(p.wi.z, 0);
    EXPECT_GT(p.wo.z, 0);
  }
  const Coverage coverage = coverage_of(view);
  EXPECT_EQ(coverage.pixels, view.points.size());  // one light
  EXPECT_GT(coverage.most_theta_o, 60);
  EXPECT_LT(coverage.most_theta_o, 90);
}

TEST(SceneFit, KnowsWhetherTurningTheReferenceChangesIt) {
  Material brushed = glossy(0.2);
  EXPECT_TRUE(is_isotropic(rgb_function(brushed)));
  brushed.terms[0].shape[0] = {0.2, 0.21};
  EXPECT_FALSE(is_isotropic(rgb_function(brushed)));
  // A table is interpolated without regard to azimuth.
  const io::SampleTable table = hemisphere_samples(rgb_function(glossy(0.2)), 3000);
  EXPECT_TRUE(is_isotropic(rgb_function(table)));
}

TEST(SceneFit, RenderingBothGivesTheErrorOfTheDirections) {
  const SceneView view = view_of(material_ball(48));
  const RgbFunction a = rgb_function(glossy(0.2)), b = rgb_function(glossy(0.3));
  EXPECT_EQ(image_error(view, a, a), 0);
  const double error = image_error(view, a, b);
  EXPECT_GT(error, 0.01);
  EXPECT_NEAR(render_both(view, a, b).image_error, error, 1e-4 * error + 1e-6);
}

TEST(SceneFit, RecoversTheMaterialThatTheSceneShows) {
  const SceneView view = view_of(material_ball(64));
  const io::SampleTable table = scene_samples(view, rgb_function(glossy(0.2)), 1500);
  const Material fitted = fit_to_picture(cook_torrance{}, table, false);
  EXPECT_NEAR(fitted.terms[0].shape[0][0], 0.2, 1e-4);
  EXPECT_LT(image_error(view, rgb_function(fitted), rgb_function(glossy(0.2))), 1e-3);
}

TEST(SceneFit, AVariantWithoutFresnelFindsTheWidth) {
  const SceneView view = view_of(material_ball(64));
  const io::SampleTable table = scene_samples(view, rgb_function(glossy(0.2)), 1500);
  const Material fitted = fit_to_picture(variant_form(Variant::no_fresnel), table, false);
  EXPECT_NEAR(fitted.terms[0].shape[0][0], 0.2, 0.02);
  EXPECT_LT(image_error(view, rgb_function(fitted), rgb_function(glossy(0.2))), 0.05);
  // The variant has no Fresnel term. In the reference form its f0 is therefore 1.
  const Material whole = in_reference_form(fitted);
  EXPECT_EQ(whole.terms[0].shape[0][1], fitted.terms[0].shape[0][0]);
  EXPECT_EQ(whole.terms[0].weights[0],
            (std::vector<double>{fitted.terms[0].weights[0][0], fitted.terms[0].weights[0][1], 1}));
}

TEST(SceneFit, AVariantThatMasksAlikeHasTheReferencesValues) {
  // Hammon's masking is exact at alpha 1.
  const auto value = [](const Reflectance& form) {
    Material m = make_material(form, {"fr"});
    set_parameter(m, Role::width, 1);
    double f = 0;
    eval(m, direction(degrees(40), {}), direction(degrees(60), degrees(120)), std::span(&f, 1));
    return f;
  };
  EXPECT_NEAR(value(variant_form(Variant::hammon)), value(reference_form()), 1e-14);
  EXPECT_GT(value(variant_form(Variant::no_masking)), 1.01 * value(reference_form()));
  for (std::size_t k = 0; k < kNames<Variant>.size(); ++k) {
    EXPECT_EQ(find_variant(variant_form(Variant(k))), Variant(k));
    EXPECT_EQ(info(variant_form(Variant(k))).name, kNames<Variant>[k]);
  }
  EXPECT_FALSE(find_variant(reference_form()).has_value());
}

TEST(SceneFit, ChannelsOtherThanOneOrThreeAreRefused) {
  EXPECT_THROW(rgb_function(make_material(lambert{}, {"a", "b"})), InputError);
}

}  // namespace
}  // namespace brdf::trade
