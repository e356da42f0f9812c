// Tests that models of other programs can be fitted like forms: the fit recovers their values.
#include "brdf/targets.h"

#include <gtest/gtest.h>

#include "fit/choice.h"
#include "io/files/error.h"
#include "samples.h"

namespace brdf::fit {
namespace {

// Returns a material with weights and shape inside the ranges of the tables and with colours that differ.
Material truth_of(const Reflectance& target) {
  Material truth = make_material(target, {"r", "g", "b"});
  const auto inside = [](const ParameterInfo& p, double share) {
    return p.min == p.max ? p.min : p.min + share * (p.usual_max - p.min);
  };
  const ReflectanceInfo& info = target.info();
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < info.weights.size(); ++k)
      truth.terms[0].weights[c][k] = inside(info.weights[k], 0.5 - 0.1 * double(c));
  for (std::size_t k = 0; k < info.shape.size(); ++k) truth.terms[0].shape[0][k] = inside(info.shape[k], 0.3);
  return truth;
}

TEST(TargetFit, TheirOwnValuesComeBack) {
  for (const Reflectance& target : targets()) {
    const Material truth = truth_of(target);
    FitOptions options;
    options.cross_validation = false;
    const FormFit f = fit(measured(truth, {"hemisphere"}, 0, 1, 20), {{target}}, options).ranking.front();
    ASSERT_TRUE(f.solved()) << target.info().name;
    for (const double theta : {10.0, 40.0, 70.0}) {
      const Vec3<double> wi = direction(degrees(theta), 0_deg), wo = direction(50_deg, 160_deg);
      std::vector<double> expected(3), found(3);
      eval(truth, wi, wo, expected);
      eval(f.material, wi, wo, found);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c] / expected[c], 1, 1e-5) << target.info().name << " at " << theta;
    }
  }
}

TEST(TargetFit, TheyTakeNoPartInAll) {
  for (const char* list : {"all", "every"})
    for (const auto& model : models_of(list)) EXPECT_GE(catalogue_index(model.front()), 0);
  EXPECT_EQ(models_of("blender_principled").size(), 1u);
}

TEST(Models, AListHasEachModelOnce) {
  EXPECT_EQ(models_of("phong,ward").size(), 2u);
  EXPECT_EQ(models_of("lambert+phong,ward").front().size(), 2u);
  EXPECT_EQ(models_of("all,blender_principled").size(), models_of("all").size() + 1);
  EXPECT_TRUE(models_of("auto").empty());
  for (const char* list : {"ward,lambert,ward", "all,ward", "auto,ward", "ward,", ",", "ward,no_form"})
    EXPECT_THROW(models_of(list), InputError) << list;
}

TEST(TargetFit, AWeightOfOneValueIsHeldAndCannotBeMoved) {
  const Material truth = truth_of(*find_form("gltf_metallic_roughness"));
  FitOptions options;
  options.cross_validation = false;
  const io::SampleTable table = measured(truth);
  const FormFit f = fit(table, {{truth.terms[0].form}}, options).ranking.front();
  for (const std::vector<double>& weights : f.material.terms[0].weights) EXPECT_EQ(weights[1], 1);
  options.bounds = {{"rest", 1, 1}};
  EXPECT_THROW(fit(table, {{truth.terms[0].form}}, options), InputError);
}

}  // namespace
}  // namespace brdf::fit
