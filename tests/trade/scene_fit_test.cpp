#include "trade/recommend/scene_fit.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include "io/error.h"
#include "io/material_file.h"
#include "trade/questions/ball.h"
#include "trade/questions/variants.h"
#include "trade/recommend/recommend.h"

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
  const FittedVariant fitted = fit_variant("no Fresnel", table);
  EXPECT_NEAR(fitted.alpha, 0.2, 0.02);
  EXPECT_EQ(fitted.weights[0][2], 0);
  EXPECT_LT(image_error(view, fitted.reflectance, rgb_function(glossy(0.2))), 0.05);
}

TEST(SceneFit, ChannelsOtherThanOneOrThreeAreRefused) {
  EXPECT_THROW(rgb_function(make_material(lambert{}, {"a", "b"})), InputError);
}

std::filesystem::path data(const std::string& name) {
  return std::filesystem::path(BRDF_SOURCE_DIR) / "data" / name;
}

TEST(Recommend, ACloseUpOfPaperNeedsNoAnisotropyAndNoGrazingAccuracy) {
  RecommendOptions options;
  options.scene = data("scenes/recommend_close_up.json");
  options.reference = data("materials/glossy_grey_paper.json");
  options.tolerance = 0.05;
  const Recommendation r = recommend(options);
  ASSERT_TRUE(r.chosen.has_value());
  EXPECT_LE(*shown(r).rendered_error, options.tolerance);
  EXPECT_EQ(r.candidates[*r.chosen].form.substr(0, 4), "ward");
  bool grazing = false, anisotropy = false;
  for (const std::string& s : r.unneeded) {
    grazing |= s.find("grazing accuracy is not needed") != std::string::npos;
    anisotropy |= s.find("anisotropy is not needed") != std::string::npos;
  }
  EXPECT_TRUE(grazing);
  EXPECT_TRUE(anisotropy);
  for (std::size_t k = 1; k < r.candidates.size(); ++k)
    EXPECT_LE(r.candidates[k - 1].cost_ns, r.candidates[k].cost_ns);
  for (const Candidate& c : r.candidates) EXPECT_FALSE(c.reason.empty()) << c.label();
}

TEST(Recommend, SaysNoneAndNamesTheBest) {
  RecommendOptions options;
  options.scene = data("scenes/recommend_close_up.json");
  options.reference = data("materials/glossy_grey_paper.json");
  options.tolerance = 0.05;
  options.max_cost_ns = 1e-3;  // nothing is that cheap
  const Recommendation r = recommend(options);
  EXPECT_FALSE(r.chosen.has_value());
  for (const Candidate& c : r.candidates) EXPECT_GE(c.image_error, r.candidates[r.best].image_error);
  EXPECT_TRUE(to_json(r).at("chosen").is_null());
}

}  // namespace
}  // namespace brdf::trade
