// The ledger's errors against published and re-derived figures of each approximation.
#include <gtest/gtest.h>

#include <algorithm>

#include "trade/questions.h"
#include "trade/variants.h"

namespace brdf::trade {
namespace {

LedgerRow row_of(const std::vector<Question>& questions, const std::string& question,
                 const std::string& choice, std::size_t points = 4096) {
  MeasureOptions options;
  options.points = points;
  options.rounds = 1;
  for (Question q : questions) {
    if (q.name != question) continue;
    // The one choice beside the exact one; fewer extremes to wait for.
    std::erase_if(q.choices, [&, first = q.choices.front().name](const Choice& c) {
      return c.name != choice && c.name != first;
    });
    q.extremes.clear();
    q.timed_points = 4;
    for (LedgerRow& row : measure(q, options))
      if (row.choice == choice) return row;
  }
  ADD_FAILURE() << "no row " << question << ": " << choice;
  return {};
}

void expect_near_relative(double value, double figure, double relative) {
  EXPECT_GT(value, figure * (1 - relative));
  EXPECT_LT(value, figure * (1 + relative));
}

TEST(Figures, SchlickIsOffByPoint036ForGlass) {
  expect_near_relative(row_of(fresnel_questions(), "Fresnel of glass", "Schlick").error.max, 0.036, 0.1);
}

TEST(Figures, SchlickForMetalsIsWithinThePrintedRanges) {
  const std::vector<Question> questions = fresnel_questions();
  const auto schlick = [&](const char* metal) {
    return row_of(questions, std::string("Fresnel of ") + metal, "Schlick").error.max;
  };
  EXPECT_GT(schlick("aluminium"), 0.07);
  EXPECT_LT(schlick("aluminium"), 0.12);
  EXPECT_GT(schlick("iron"), 0.15);
  EXPECT_LT(schlick("iron"), 0.18);
  EXPECT_GT(schlick("chromium"), 0.19);
  EXPECT_LT(schlick("chromium"), 0.20);
}

TEST(Figures, TheSlipIsTheSquareWithoutItsDenominator) {
  // 1.25 at grazing against 1, and .25 against .04 at normal incidence: .25 and .21 off, with a maximum
  // between.
  expect_near_relative(row_of(fresnel_questions(), "Fresnel of glass", "the article's slip").error.max, 0.283,
                       0.02);
}

TEST(Figures, SchlickGgxIsOffByAFifthOrByNearlyAll) {
  const std::vector<Question> questions = masking_questions();
  const auto g1 = [&](const char* k) {
    return row_of(questions, "masking of one direction, GGX", k).error.max;
  };
  expect_near_relative(g1("Schlick-GGX, k = alpha/2"), 0.20, 0.1);
  expect_near_relative(g1("Schlick-GGX, k = (roughness+1)^2/8"), 0.931, 0.01);
  expect_near_relative(g1("Schlick-GGX, k = (alpha+1)^2/8"), 0.923, 0.01);
}

TEST(Figures, RationalBeckmannMaskingIsOffByAThirdOfAPercent) {
  expect_near_relative(
      row_of(masking_questions(), "masking of one direction, Beckmann", "rational").error.max, 0.0031, 0.1);
}

TEST(Figures, SeparableMaskingLosesPoint216OfAlbedo) {
  expect_near_relative(
      row_of(integral_questions(), "masking for GGX, by the albedo it gives", "Smith, separable", 16)
          .error.max,
      0.216, 0.02);
}

TEST(Figures, SphericalGaussiansForCosinePowers) {
  const std::vector<Question> questions = lobe_questions();
  expect_near_relative(row_of(questions, "power of a cosine, n = 8", "spherical Gaussian").error.max, 0.035,
                       0.1);
  expect_near_relative(row_of(questions, "power of a cosine, n = 32", "spherical Gaussian").error.max, 0.0085,
                       0.1);
}

TEST(Figures, RationalAlbedoFit) {
  const LedgerRow row = row_of(albedo_questions(), "albedo of GGX at a table's nodes", "rational fit", 1024);
  EXPECT_GT(row.error.max, 0.05);
  EXPECT_LT(row.error.max, 0.14);
  expect_near_relative(row.error.mean, 0.008, 0.12);
}

TEST(Figures, MonteCarloAlbedosAreWithinAFactorOfTwo) {
  const std::vector<Question> questions = albedo_questions();
  const double few = row_of(questions, "albedo of GGX", "64 visible normals", 1024).error.max;
  EXPECT_GT(few, 0.0135 / 2);
  EXPECT_LT(few, 0.0135 * 2);
  const double many = row_of(questions, "albedo of GGX", "1024 half vectors", 512).error.max;
  EXPECT_GT(many, 0.0091 / 2);
  EXPECT_LT(many, 0.0091 * 2);
}

TEST(Figures, TheNaiveDistributionLosesItsDigitsInFloat) {
  const std::vector<Question> questions = lobe_questions();
  EXPECT_LT(row_of(questions, "D of GGX in float", "half vector not normalised").error.max, 1e-6);
  // 3.5e-8/alpha^2 in the median: 3.5e-4 at the domain's smallest alpha.
  EXPECT_GT(row_of(questions, "D of GGX in float", "through (n.h)^2 - 1").error.max, 1e-3);
}

TEST(Figures, ABetterParameterisationNeedsFewerTexels) {
  const std::vector<Question> questions = lookup_questions();
  const auto mean = [&](const char* choice) {
    return row_of(questions, "lookup texture, alpha 0.05", choice).error.mean;
  };
  EXPECT_LT(mean("64^2, 16 bit, bilinear, scaled"), mean("1024^2, 16 bit, bilinear") / 100);
}

TEST(Figures, OwnKernelsAreWithinTwoUlp) {
  const std::vector<Question> questions = precision_questions();
  for (const char* name : {"exp", "log", "angle"}) {
    const std::string question = std::string(name) + ": own kernel or C library";
    EXPECT_LT(row_of(questions, question, "own, double").error.max, 4.5e-16) << name;
    EXPECT_GT(row_of(questions, question, "own, double").error.max, 1e-17) << name;
    EXPECT_LT(row_of(questions, question, "own, float").error.max, 2.4e-7) << name;
  }
}

TEST(Figures, VariantsDifferFromTheModelByWhatTheyLeaveOut) {
  const std::vector<Question> questions = variant_questions();
  const double without = row_of(questions, kVariantQuestion, "no Fresnel").error.max;
  EXPECT_GT(without, 0.05);
  EXPECT_LT(row_of(questions, kVariantQuestion, "masking by Hammon").error.mean, without);
}

}  // namespace
}  // namespace brdf::trade
