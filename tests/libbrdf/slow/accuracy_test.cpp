// A search of a million evaluations for each form and scalar finds no error larger than the error stated in
// the form's header.
#include <gtest/gtest.h>

#include "validate/numerics/numerics.h"

namespace brdf::validate {
namespace {

class StatedAccuracy : public ::testing::TestWithParam<Reflectance> {};

TEST_P(StatedAccuracy, HoldsInAMillionEvaluations) {
  for (const NumericsRow& row : measure_numerics(GetParam(), {.evaluations = 1'000'000, .seed = 2})) {
    EXPECT_TRUE(meets_statement(row))
        << row.form << ' ' << row.scalar << ": " << row.errors.body << ", " << row.errors.faint << ", "
        << row.errors.tail << ", the body at " << row.where.parameters;
    // Near gamma = 10 Student's t in float exceeds the budget that all other forms meet by 1.5 %.
    const bool student = row.form == "cook_torrance_student" && row.scalar == "float";
    EXPECT_EQ(meets_budget(row), !student) << row.form << ' ' << row.scalar;
    EXPECT_LT(row.errors.body, 1.05 * numerics_budget(row.scalar).body);
    EXPECT_GT(row.count, 2'000'000u);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryForm, StatedAccuracy,
                         ::testing::ValuesIn(catalogue().begin(), catalogue().end()),
                         [](const auto& param) { return std::string(param.param.info().name); });

}  // namespace
}  // namespace brdf::validate
