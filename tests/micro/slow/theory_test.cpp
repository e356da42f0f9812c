// All comparisons of simulation and theory at their full length.
#include "micro/theory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brdf::micro {
namespace {

void expect_exact_rows_agree(const std::vector<TheoryRow>& rows) {
  int exact = 0;
  for (const TheoryRow& row : rows) {
    if (!row.exact) continue;
    ++exact;
    const double z = std::isnan(row.z) ? 0 : row.z;
    EXPECT_LT(std::abs(z), kExactZ) << row.surface << ' ' << row.quantity;
  }
  EXPECT_GT(exact, 0);
}

double find(const std::vector<TheoryRow>& rows, const std::string& part) {
  for (const TheoryRow& row : rows) {
    if (row.quantity.find(part) != std::string::npos) return row.simulated;
  }
  ADD_FAILURE() << "no row " << part;
  return kNone;
}

TEST(Theory, ExactStatementsHold) {
  expect_exact_rows_agree(compare_slopes({}));
  expect_exact_rows_agree(compare_masking({}));
  expect_exact_rows_agree(compare_mirror_grooves({}, 30_deg));
  expect_exact_rows_agree(compare_mirror_grooves({}, 60_deg));
  expect_exact_rows_agree(compare_reciprocity({}));
  expect_exact_rows_agree(compare_energy({}));
}

TEST(Theory, SingleReflectionIsCookTorranceWithSmith) {
  for (const double alpha : {0.1, 0.3, 0.5}) {
    for (const double theta : {30.0, 60.0}) {
      const auto rows = compare_single_bounce({}, alpha, degrees(theta));
      EXPECT_GE(find(rows, "share of cells not significantly beyond 5 %"), 0.98) << alpha << ' ' << theta;
      EXPECT_GE(find(rows, "cells judged"), 100);
      EXPECT_LT(find(rows, "mean relative standard error"), 0.05);
    }
  }
}

TEST(Theory, FullOrenNayarIsCloserToItsGroovesThanTheQualitativeForm) {
  for (const double sigma : {10.0, 20.0, 30.0}) {
    const auto rows = compare_lambert_grooves({}, degrees(sigma));
    expect_exact_rows_agree(rows);
    EXPECT_LT(find(rows, "difference to oren_nayar_full"), 0.6 * find(rows, "difference to oren_nayar over"));
  }
}

}  // namespace
}  // namespace brdf::micro
