// Tests parameters that are fixed, bounded or started by the user: which constraints are refused, and that
// the others are obeyed.
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "samples.h"

namespace brdf::fit {
namespace {

using testing::HasSubstr;

FitOptions fixing(std::vector<NamedValues> fix, bool anisotropic = false) {
  FitOptions options;
  options.fix = std::move(fix);
  options.anisotropic = anisotropic;
  return options;
}
FitOptions starting(std::vector<NamedValues> start) {
  FitOptions options;
  options.start = std::move(start);
  return options;
}
FitOptions bounding(std::vector<NamedRange> bounds) {
  FitOptions options;
  options.bounds = std::move(bounds);
  return options;
}

TEST(Constraints, OfTheWidthAcrossNeedTwoWidths) {
  EXPECT_THAT(refusal({"ward"}, fixing({{"alpha_y", {0.3}}})),
              HasSubstr("--fix alpha_y: has an effect only with --anisotropic"));
  EXPECT_THAT(refusal({"ward"}, fixing({{"alpha_x", {0.1}}, {"alpha_y", {0.3}}})),
              HasSubstr("--fix alpha_y"));
  EXPECT_THAT(refusal({"ward"}, bounding({{"alpha_y", 0.3, 0.4}})), HasSubstr("--bounds alpha_y"));
  EXPECT_THAT(refusal({"ward"}, starting({{"alpha_y", {0.3}}})), HasSubstr("--start alpha_y"));
  EXPECT_EQ(refusal({"ward"}, fixing({{"alpha_x", {0.1}}, {"alpha_y", {0.3}}}, true)), "");
  EXPECT_EQ(refusal({"ward"}, fixing({{"alpha", {0.1}}})), "");
}

TEST(Constraints, MayComeFromATableOfRefractiveIndices) {
  const auto glass = std::make_shared<io::OpticalConstants>(
      io::OpticalConstants{"glass.yml", {400, 600, 700}, {{1.5, 0}, {1.7, 0}, {2, 1}}});
  const std::vector<std::string> bands{"400nm", "500nm", "700nm"};
  const Model lobe(forms({"cook_torrance"}), bands, starting({{"f0", {}, glass}}));
  const std::vector<double>& start = lobe.constraints().terms[0].weights[2].start;
  ASSERT_EQ(start.size(), 3u);
  EXPECT_NEAR(start[0], .04, 1e-15);
  EXPECT_NEAR(start[1], .36 / 6.76, 1e-15);
  EXPECT_NEAR(start[2], .2, 1e-15);
  const Model dielectric(forms({"cook_torrance_dielectric"}), bands, fixing({{"eta", {}, glass}}));
  const int eta = parameter_index(dielectric.terms()[0].info->shape, Role::index);
  ASSERT_GE(eta, 0);
  EXPECT_NEAR(dielectric.constraints().terms[0].shape[std::size_t(eta)].fixed[0], (1.5 + 1.6 + 2) / 3, 1e-15);
  EXPECT_THAT(refusal({"ward"}, starting({{"kd", {}, glass}})),
              HasSubstr("--start kd: a table of refractive indices gives values of f0, n and k only"));
  EXPECT_THAT(refusal({"cook_torrance_dielectric"}, starting({{"eta", {}, glass}})),
              HasSubstr("glass.yml: channel 'r' is not named by a wavelength"));
}

TEST(Constraints, OfTheAzimuthNeedTwoWidths) {
  EXPECT_THAT(refusal({"ward"}, fixing({{"tangent_phi", {30}}})),
              HasSubstr("--fix tangent_phi: has an effect only with --anisotropic"));
  EXPECT_EQ(refusal({"ward"}, fixing({{"tangent_phi", {30}}}, true)), "");
  EXPECT_THAT(refusal({"ward"}, fixing({{"tangent_phi", {181}}}, true)),
              HasSubstr("181 is outside -180 to 180"));
  EXPECT_THAT(refusal({"ward"}, fixing({{"tangent_phi", {10, 20, 30}}}, true)), HasSubstr("takes one value"));
  EXPECT_THAT(refusal({"lambert"}, fixing({{"tangent_phi", {30}}}, true)),
              HasSubstr("no parameter of this name"));
  FitOptions bounded = bounding({{"tangent_phi", 0, 30}});
  bounded.anisotropic = true;
  EXPECT_THAT(refusal({"ward"}, bounded), HasSubstr("--bounds tangent_phi: has no effect"));
}

TEST(Constraints, OfAShapePerChannelNeedShapesPerChannel) {
  for (FitOptions options : {fixing({{"alpha", {0.1, 0.2, 0.3}}}), starting({{"alpha", {0.1, 0.2, 0.3}}})}) {
    EXPECT_THAT(refusal({"ward"}, options), HasSubstr("only with --per-channel"));
    options.per_channel = true;
    EXPECT_EQ(refusal({"ward"}, options), "");
  }
  EXPECT_EQ(refusal({"ward"}, fixing({{"ks", {0.1, 0.2, 0.3}}})), "");
  EXPECT_THAT(refusal({"ward"}, fixing({{"ks", {0.1, 0.2}}})), HasSubstr("2 values for 3 channels"));
  EXPECT_THAT(refusal({"ward"}, starting({{"ks", {0.1, 0.2}}})), HasSubstr("2 values for 3 channels"));
}

TEST(Constraints, EveryValueMustLieInRange) {
  FitOptions options = starting({{"alpha", {0.1, 0.2, 7}}});
  options.per_channel = true;
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("--start alpha: 7 is outside 1e-04 to 1"));
  EXPECT_THAT(refusal({"ward"}, starting({{"ks", {0.1, -2, 0.1}}})), HasSubstr("-2 is outside"));
  EXPECT_THAT(refusal({"ward"}, bounding({{"alpha", 0.1, 2}})), HasSubstr("--bounds alpha: 2 is outside"));
  EXPECT_THAT(refusal({"ward"}, bounding({{"ks", 0.4, 0.2}})), HasSubstr("0.2 is outside 0.4"));
  options = bounding({{"alpha", 0.1, 0.2}});
  options.start = {{"alpha", {0.5}}};
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("--start alpha: 0.5 is outside 0.1 to 0.2"));
}

TEST(Constraints, OfWhatIsHeldOrTwiceNamedAreRefused) {
  FitOptions options = fixing({{"alpha", {0.1}}});
  options.bounds = {{"alpha", 0.1, 0.2}};
  EXPECT_THAT(refusal({"ward"}, options),
              HasSubstr("--bounds alpha: has no effect, because --fix holds this parameter"));
  options.bounds.clear();
  options.start = {{"alpha", {0.1}}};
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("--start alpha: has no effect"));
  EXPECT_THAT(refusal({"ward"}, fixing({{"alpha", {0.1}}, {"alpha_x", {0.2}}})), HasSubstr("is given twice"));
  EXPECT_THAT(refusal({"ward", "ward"}, fixing({{"ks", {0.1}}, {"terms[1].ks", {0.2}}})),
              HasSubstr("--fix terms[1].ks: is given twice"));
}

TEST(Constraints, OfASecondDiffusePartAreRefused) {
  EXPECT_THAT(refusal({"oren_nayar", "ward"}, bounding({{"kd", 0.1, 0.2}})),
              HasSubstr("--bounds kd: is held at 0, because another term of the sum has the diffuse part"));
  EXPECT_THAT(refusal({"ward", "ward"}, starting({{"terms[1].kd", {0.2}}})), HasSubstr("is held at 0"));
  EXPECT_EQ(refusal({"ward", "ward"}, bounding({{"kd", 0.1, 0.2}})), "");
  EXPECT_EQ(refusal({"oren_nayar", "ward"}, fixing({{"kd", {0.1}}})), "");
}

TEST(Constraints, OfUnknownNamesAreRefused) {
  EXPECT_THAT(refusal({"lambert"}, fixing({{"alpha", {0.1}}})),
              HasSubstr("--fix alpha: lambert has no parameter of this name"));
  EXPECT_THAT(refusal({"oren_nayar", "ward"}, starting({{"terms[0].alpha", {0.1}}})),
              HasSubstr("oren_nayar+ward has no parameter of this name"));
  EXPECT_THAT(refusal({"ward"}, bounding({{"exponent", 1, 2}})), HasSubstr("no parameter of this name"));
}

// The two widths can be exchanged if the tangent turns by 90 degrees. The fit must not exchange them here,
// because their bounds differ.
TEST(Constraints, AreObeyedByEquivalentParametersToo) {
  Material truth = make_material(*find_form("ward"), {"f"});
  truth.terms[0].shape[0] = {0.05, 0.16};
  truth.terms[0].tangent_phi = degrees(80);
  synth::Instrument instrument;
  instrument.grid.azimuths = {0, 30, 60, 90, 120, 150};
  instrument.grid.theta_i = {20, 50};
  instrument.grid.step = 10;
  FitOptions options = bounding({{"alpha_x", 0.01, 0.1}, {"alpha_y", 0.1, 0.3}});
  options.anisotropic = true;
  options.cross_validation = false;
  const FormFit f = fit_one(synth::measure(truth, instrument), {"ward"}, options);
  EXPECT_NEAR(f.material.terms[0].shape[0][0], 0.05, 1e-7);
  EXPECT_NEAR(f.material.terms[0].shape[0][1], 0.16, 1e-7);
  EXPECT_NEAR(f.material.terms[0].tangent_phi.degrees(), 80, 1e-5);
}

}  // namespace
}  // namespace brdf::fit
