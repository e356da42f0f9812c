// Parameters fitted to traced samples reproduce the parameters of the geometry.
#include <gtest/gtest.h>

#include <cmath>

#include "fit/fit.h"
#include "micro/samples.h"

namespace brdf::micro {
namespace {

// Returns the fitted shape parameter that the form calls `name`; expects a usable fit.
double fitted(const fit::FormFit& result, std::string_view name) {
  EXPECT_TRUE(fit::usable(result.verdict)) << name_of(result.verdict);
  const Term& term = result.material.terms.front();
  return term.shape_of(0)[info(term.form).shape_index(name)];
}

fit::FormFit fit_form(const SampleSettings& settings, std::string_view form, bool anisotropic = false) {
  fit::FitOptions options;
  options.cross_validation = false;
  options.anisotropic = anisotropic;
  return fit::fit(trace_samples(settings), {{*find_form(form)}}, options).ranking.front();
}

SampleSettings quick(std::string surface, std::vector<std::pair<std::string, double>> parameters) {
  SampleSettings s;
  s.surface = std::move(surface);
  s.parameters = std::move(parameters);
  s.theta_i = {15, 45, 65};
  s.bounces = 1;
  s.size = 256;
  s.surfaces = 8;
  s.rays = 10000;
  return s;
}

TEST(FitOfTracedSamples, FindsTheSlopeOfGaussianSurfaces) {
  for (const double alpha : {0.1, 0.3, 0.5}) {
    const fit::FormFit result = fit_form(quick("gaussian", {{"alpha", alpha}}), "cook_torrance_beckmann");
    EXPECT_NEAR(fitted(result, "alpha_x") / alpha, 1, 0.03) << alpha;
  }
}

TEST(FitOfTracedSamples, FindsBothSlopesOfAnAnisotropicSurface) {
  SampleSettings settings = quick("gaussian", {{"alpha_x", 0.2}, {"alpha_y", 0.4}});
  settings.azimuths = {0, 45, 90};
  const fit::FormFit result = fit_form(settings, "cook_torrance_beckmann", true);
  EXPECT_NEAR(fitted(result, "alpha_x") / 0.2, 1, 0.03);
  EXPECT_NEAR(fitted(result, "alpha_y") / 0.4, 1, 0.03);
}

TEST(FitOfTracedSamples, FindsSlopeAndIndexOfMirrorGrooves) {
  SampleSettings settings = quick("mirror_grooves", {{"alpha", 0.4}, {"eta", 1.5}});
  settings.surfaces = 128;
  settings.rays = 4096;
  const fit::FormFit result = fit_form(settings, "cook_torrance_vcavity");
  EXPECT_NEAR(fitted(result, "alpha_x") / 0.4, 1, 0.03);
  EXPECT_NEAR(fitted(result, "eta"), 1.5, 0.03);
}

// The qualitative form only approximates its own grooves: the fitted sigma is a fifth too small.
TEST(FitOfTracedSamples, OrenNayarUnderestimatesSigma) {
  SampleSettings settings = quick("lambert_grooves", {{"sigma", 0.35}, {"rho", 0.9}});
  settings.bounces = 16;
  settings.rays = 512;
  settings.theta_i = {15, 45, 60, 75};
  const double sigma = fitted(fit_form(settings, "oren_nayar"), "sigma");
  EXPECT_LT(sigma, 0.32);
  EXPECT_GT(sigma, 0.24);
}

}  // namespace
}  // namespace brdf::micro
