// Compares the errors in the ledger with published and re-derived figures of each approximation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "trade/approximations/fresnel.h"
#include "trade/questions/claims.h"
#include "trade/questions/frames.h"
#include "trade/questions/questions.h"
#include "trade/questions/variants.h"

namespace brdf::trade {
namespace {

LedgerRow row_of(const std::vector<Question>& questions, const std::string& question,
                 const std::string& choice, std::size_t points = 4096) {
  MeasureOptions options;
  options.points = points;
  options.rounds = 1;
  for (Question q : questions) {
    if (q.name != question) continue;
    // Keeps only this choice and the exact one, and drops the extremes, to save time.
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

// A printed figure of an approximation, as a range.
enum class Of { max, mean };
struct Printed {
  const char *question, *choice;
  Of of;
  double low, high;
};
constexpr Printed within(double relative, const char* question, const char* choice, Of of, double figure) {
  return {question, choice, of, figure * (1 - relative), figure * (1 + relative)};
}
constexpr Printed near(const char* question, const char* choice, Of of, double figure) {
  return within(0.1, question, choice, of, figure);
}
constexpr Printed monte_carlo(const char* question, const char* choice, double figure) {  // within a factor 2
  return {question, choice, Of::max, figure / 2, figure * 2};
}

// Largest and mean errors against the exact term, as published or measured elsewhere.
constexpr Printed kPrinted[] = {
    near("Fresnel of glass", "Schlick", Of::max, 0.036),
    {"Fresnel of aluminium", "Schlick", Of::max, 0.07, 0.12},
    {"Fresnel of iron", "Schlick", Of::max, 0.15, 0.18},
    {"Fresnel of chromium", "Schlick", Of::max, 0.19, 0.20},
    // (g-c)^2 without its denominator is wrong by 0.25 and 0.21 at the ends, and by more in between.
    near("Fresnel of glass", "the article's slip", Of::max, 0.283),
    near("masking of one direction, GGX", "Schlick-GGX, k = alpha/2", Of::max, 0.20),
    // At roughness 0.06 and cosine 0.01.
    within(0.01, "masking of one direction, GGX", "Schlick-GGX, k = (roughness+1)^2/8", Of::max, 0.931),
    within(0.01, "masking of one direction, GGX", "Schlick-GGX, k = (alpha+1)^2/8", Of::max, 0.923),
    near("masking of one direction, Beckmann", "rational", Of::max, 0.0031),
    near("masking for GGX, by the albedo it gives", "Smith, separable", Of::max, 0.216),
    near("power of a cosine, n = 8", "spherical Gaussian", Of::max, 0.035),
    near("power of a cosine, n = 32", "spherical Gaussian", Of::max, 0.0085),
    // These figures depend on the grid.
    {"albedo of GGX at a table's nodes", "rational fit", Of::max, 0.05, 0.14},
    {"albedo of GGX", "rational fit", Of::max, 0.05, 0.14},
    near("albedo of GGX at a table's nodes", "rational fit", Of::mean, 0.008),
    monte_carlo("albedo of GGX", "64 visible normals", 0.0135),
    monte_carlo("albedo of GGX", "1024 half vectors", 0.0091),
};

std::string described(const Printed& p) {
  return std::string(p.question) + ": " + p.choice + (p.of == Of::max ? ", largest" : ", mean");
}
void expect_printed(const LedgerRow& row, const Printed& p) {
  const double measured = p.of == Of::max ? row.error.max : row.error.mean;
  EXPECT_GE(measured, p.low) << described(p);
  EXPECT_LE(measured, p.high) << described(p);
}

TEST(Figures, ErrorsAreThePrintedOnes) {
  std::vector<Question> questions;
  for (const auto list :
       {fresnel_questions, masking_questions, lobe_questions, albedo_questions, integral_questions})
    for (Question& q : list()) questions.push_back(std::move(q));
  for (const Printed& p : kPrinted) expect_printed(row_of(questions, p.question, p.choice), p);
}

TEST(Figures, TheShippedLedgerHasThePrintedErrors) {
  const Ledger ledger = read_ledger(std::filesystem::path(BRDF_SOURCE_DIR) / "data/ledger.json");
  for (const Printed& p : kPrinted) {
    const LedgerRow* const row = ledger.find(p.question, p.choice);
    ASSERT_NE(row, nullptr) << described(p);
    expect_printed(*row, p);
  }
}

TEST(Figures, EveryRowOfTheShippedLedgerIsComplete) {
  const Ledger ledger = read_ledger(std::filesystem::path(BRDF_SOURCE_DIR) / "data/ledger.json");
  EXPECT_EQ(ledger.left_out, "");
  for (const LedgerRow& row : ledger.rows) {
    const std::string name = row.question + ": " + row.choice;
    EXPECT_GE(row.cost.rounds, 21) << name;
    EXPECT_GT(row.cost_ratio, 0) << name;
    EXPECT_GE(row.error.max, row.error.p99) << name;
    EXPECT_GE(1.000001 * row.error.max, row.error.mean) << name;  // a sum rounds
    EXPECT_FALSE(row.error.where.empty()) << name;
    EXPECT_FALSE(row.domain.empty()) << name;
    EXPECT_FALSE(row.extremes.empty()) << name;
    EXPECT_TRUE(row.image_error.has_value()) << name;
  }
}

// Tests that the ledger has the rows that the questions and claims of the documents need.
TEST(Figures, TheShippedLedgerHasEveryApproximation) {
  const Ledger ledger = read_ledger(std::filesystem::path(BRDF_SOURCE_DIR) / "data/ledger.json");
  const auto expect_row = [&](const std::string& question, const std::string& choice) {
    EXPECT_NE(ledger.find(question, choice), nullptr) << question << ": " << choice;
  };
  for (const char* form :
       {"cook_torrance", "cook_torrance_beckmann", "ward", "blinn_phong", "phong", "oren_nayar"})
    for (const char* choice : {"double", "double, C library", "float", "float, C library", "half storage"})
      expect_row(std::string(form) + ": precision and kernels", choice);
  for (const char* choice : {"Smith, correlated", "Smith, separable", "Schlick-GGX, k = alpha/2",
                             "Schlick-GGX, k = (roughness+1)^2/8", "V-cavities", "G dropped"})
    expect_row("masking for GGX", choice);
  expect_row("D of GGX in float", "through (n.h)^2 - 1");
  for (const char* choice : {"half vector, equal n", "half vector, 4 n"})
    expect_row("mirror direction or half vector", choice);
  for (int size = 32; size <= 1024; size *= 2)
    for (const char* bits : {"8 bit", "16 bit", "32 bit"})
      for (const char* filter : {"nearest", "bilinear"}) {
        const std::string name = std::to_string(size) + "^2, " + bits + ", " + filter;
        expect_row("lookup texture, alpha 0.3", name);
        for (const char* at : {", per vertex", ", per pixel"})
          if (!ledger.quick || size == 32 || size == 128 || size == 512)
            expect_row("lookup texture in a frame", name + at);
        if (size <= 128) expect_row("lookup texture, alpha 0.3", name + ", scaled");
      }
  for (const char* choice : {"table 32^2", "rational fit", "exponential fit"})
    expect_row("albedo of GGX", choice);
  for (const char* choice : {"pole-adapted, order 8", "product Gauss, 32^2", "1000 cosine samples"})
    expect_row("integrating an albedo", choice);
  for (const char* choice : {"1e2 samples", "1e3 samples", "1e4 samples", "1e5 samples"})
    expect_row("samples for a fit", choice);
  if (!ledger.quick) expect_row("samples for a fit", "1e6 samples");
  for (const char* triangles : {"320", "5120"}) {
    for (const char* choice : {"vertex colours", "flat", "Gouraud", "Phong as coded", "Phong"})
      expect_row("where to shade: diffuse", std::string(triangles) + " triangles, " + choice);
    for (const char* choice : {"highlight as coded", "highlight per vertex", "highlight per pixel"})
      expect_row("where to shade: highlight", std::string(triangles) + " triangles, " + choice);
  }
  for (const char* bits : {"8 bits", "16 bits", "32 bits"})
    expect_row("bits of the G-buffer, alpha 0.05", bits);
  for (const char* lights : {"1 light", "4 lights", "16 lights", "64 lights"})
    for (const char* path : {"forward", "deferred, 16 bits", "deferred, 32 bits"})
      expect_row(std::string("forward or deferred, ") + lights, path);
  for (const char* choice :
       {"a material, pair by pair", "batch, double", "batch, float", "shader on the driver"})
    expect_row("one by one or in batches", choice);
  for (const char* truth : {"lambert", "oren_nayar", "phong", "blinn_phong", "ward", "cook_torrance"})
    for (const char* form : {"lambert", "oren_nayar", "phong", "blinn_phong", "ward", "cook_torrance"})
      expect_row(std::string("families for a material of ") + truth, form);
}

// A claim is omitted if the ledger lacks its row. A row that no question produces would therefore hide its
// claim permanently.
TEST(Claims, AreJudgedByRowsThatThereAre) {
  const Ledger ledger = read_ledger(std::filesystem::path(BRDF_SOURCE_DIR) / "data/ledger.json");
  for (const auto& rows : claim_rows())
    for (const RowName& row : rows)
      EXPECT_NE(ledger.find(row.question, row.choice), nullptr) << row.question << ": " << row.choice;
  const std::vector<Claim> judged = judge_claims(ledger);
  ASSERT_EQ(judged.size(), claim_rows().size());
  ASSERT_EQ(judged.size(), ledger.claims.size());
  for (std::size_t k = 0; k < judged.size(); ++k) {
    EXPECT_EQ(judged[k].claim, ledger.claims[k].claim);
    EXPECT_EQ(judged[k].verdict, ledger.claims[k].verdict) << judged[k].claim;
    EXPECT_EQ(judged[k].standing, ledger.claims[k].standing) << judged[k].claim;
    EXPECT_EQ(judged[k].evidence, ledger.claims[k].evidence) << judged[k].claim;
  }
}

TEST(Claims, NameChoicesThatTheQuestionsHave) {
  std::map<std::string, std::set<std::string>> choices;
  for (const auto list : {fresnel_questions, masking_questions, lobe_questions, lookup_questions,
                          variant_questions, integral_questions})
    for (const Question& q : list())
      for (const Choice& c : q.choices) choices[q.name].insert(c.name);
  for (const FrameQuestion& q : frame_questions(FrameDetail::full))
    for (const Way& way : q.ways) choices[q.name].insert(way.name);
  for (const auto& rows : claim_rows())
    for (const RowName& row : rows) {
      if (row.question == names::kSampleCounts || row.question.starts_with(names::families(""))) continue;
      EXPECT_TRUE(choices[row.question].contains(row.choice)) << row.question << ": " << row.choice;
    }
}

TEST(Figures, SchlickIsALittleUnderAQuarterTooLowForGlassAt55Degrees) {
  const FresnelRow<double> row{.cosine = std::cos(degrees(55).radians()), .n = 1.5, .f0 = 0.04};
  const double exact = exact_dielectric(row);
  EXPECT_NEAR((schlick_fresnel(row) - exact) / exact, -0.23, 0.01);
}

TEST(Figures, TheNaiveDistributionLosesItsDigitsInFloat) {
  const std::vector<Question> questions = lobe_questions();
  EXPECT_LT(row_of(questions, "D of GGX in float", "half vector not normalised").error.max, 1e-6);
  // The median error is 3.5e-8/alpha^2, which is 3.5e-4 at the smallest alpha of the domain.
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
  const double without =
      row_of(questions, names::kVariants, std::string(name_of(Variant::no_fresnel))).error.max;
  EXPECT_GT(without, 0.05);
  EXPECT_LT(row_of(questions, names::kVariants, std::string(name_of(Variant::hammon))).error.mean, without);
}

}  // namespace
}  // namespace brdf::trade
