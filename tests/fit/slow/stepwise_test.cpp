// Tests how often --form auto finds the right number of lobes: 50 tables of one lobe, 50 tables of two.

#include <gtest/gtest.h>

#include <iostream>
#include <vector>

#include "../samples.h"
#include "brdf/random.h"

namespace brdf::fit {
namespace {

constexpr int kTables = 50;

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * uniform01(random);
}

std::size_t lobes_of(const FitResult& result) {
  std::size_t n = 0;
  for (const Term& term : result.ranking.front().material.terms)
    n += info(term.form).weight_index(Role::specular) >= 0;
  return n;
}

TEST(StepwiseInFifty, NoSecondLobeWhereThereIsOne) {
  std::mt19937_64 random(11);
  const std::vector<Reflectance> families =
      forms({"cook_torrance", "cook_torrance_student", "ward", "blinn_phong", "phong"});
  int wrong = 0;
  for (int k = 0; k < kTables; ++k) {
    const Material truth = random_material(families[std::size_t(k) % families.size()], random);
    const FitResult found =
        fit(fine_hemisphere(truth, between(random, 0.01, 0.05), std::uint64_t(k + 1)), {}, {});
    if (lobes_of(found) < 2) continue;
    ++wrong;
    std::cout << "table " << k << ", " << info(truth.terms[0].form).name << ": " << found.ranking.front().form
              << ", p " << found.steps.back().p << '\n';
  }
  EXPECT_EQ(wrong, 0);
}

// The widths differ by a factor of at least three and both lobes have a considerable weight, with or
// without a diffuse term.
TEST(StepwiseInFifty, TheSecondOfTwoIsFound) {
  std::mt19937_64 random(12);
  const Reflectance form = forms({"cook_torrance"})[0];
  int found = 0;
  for (int k = 0; k < kTables; ++k) {
    const double narrow = between(random, 0.05, 0.15), wide = narrow * between(random, 3, 5);
    Material truth = make_material(form, {"f"});
    truth.terms[0].shape[0] = {narrow, narrow};
    truth.terms[0].weights = {{between(random, 0, 0.5), between(random, 0.1, 0.4), 0.3}};
    truth.terms.push_back(truth.terms[0]);
    truth.terms[1].shape[0] = {wide, wide};
    truth.terms[1].weights = {{0, between(random, 0.3, 0.6), 0.3}};
    const FitResult result =
        fit(fine_hemisphere(truth, between(random, 0.01, 0.03), std::uint64_t(k + 1)), {}, {});
    found += lobes_of(result) == 2;
    if (lobes_of(result) != 2)
      std::cout << "table " << k << ": widths " << narrow << ", " << wide << ": "
                << result.ranking.front().form << ", p " << result.steps.back().p << '\n';
  }
  EXPECT_GE(found, 48);
}

}  // namespace
}  // namespace brdf::fit
