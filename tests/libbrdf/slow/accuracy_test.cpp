// A search of a million evaluations for each form and scalar finds no error larger than the form's header states.
#include <gtest/gtest.h>

#include "validate/numerics.h"

namespace brdf::validate {
namespace {

class StatedAccuracy : public ::testing::TestWithParam<Reflectance> {};

TEST_P(StatedAccuracy, HoldsInAMillionEvaluations) {
  for (const NumericsRow& row : measure_numerics(GetParam(), {.evaluations = 1'000'000, .seed = 2})) {
    EXPECT_TRUE(meets_statement(row))
        << row.form << ' ' << row.scalar << ": " << row.errors.body << ", " << row.errors.faint << ", "
        << row.errors.tail << ", the body at " << row.where.parameters;
    EXPECT_TRUE(meets_budget(row)) << row.form << ' ' << row.scalar;
    EXPECT_GT(row.count, 2'000'000u);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryForm, StatedAccuracy,
                         ::testing::ValuesIn(catalogue().begin(), catalogue().end()),
                         [](const auto& param) { return std::string(param.param.info().name); });

}  // namespace
}  // namespace brdf::validate
