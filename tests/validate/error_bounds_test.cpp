// Two integrals of the same quantity never lie further apart than their error bounds allow.
#include "validate/numerics/error_bounds.h"

#include <gtest/gtest.h>

namespace brdf::validate {
namespace {

TEST(ErrorBounds, HoldInFourThousandPairs) {
  std::size_t pairs = 0;
  const std::vector<IntegratorRow> rows = check_bounds(1, 4000);
  for (const IntegratorRow& row : rows) {
    EXPECT_EQ(row.wrong, 0u) << row.set << ": " << row.worst_case << ", " << row.worst << " times the bounds";
    EXPECT_GE(row.cases, 4000 * 2 / (3 * rows.size())) << row.set;  // the sets are drawn at random
    pairs += row.cases;
  }
  EXPECT_GE(pairs, 4000u);
}

}  // namespace
}  // namespace brdf::validate
