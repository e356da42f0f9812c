// Tests the formats of numbers for people.
#include "io/files/numbers.h"

#include <gtest/gtest.h>

namespace brdf::io {
namespace {

TEST(Numbers, APercentageKeepsTheDigitsBeforeThePoint) {
  EXPECT_EQ(percent(0.123), "12.3 %");
  EXPECT_EQ(percent(1.3, 2), "130 %");
  EXPECT_EQ(percent(0.996, 2), "100 %");
  EXPECT_EQ(percent(712.312), "71231 %");
  EXPECT_EQ(percent(2e4), "2e+06 %");
  EXPECT_EQ(percent(1e-9), "1e-07 %");
  EXPECT_EQ(percent(0), "0 %");
}

TEST(Numbers, ACountHasItsNoun) {
  EXPECT_EQ(plural(1, "row"), "1 row");
  EXPECT_EQ(plural(0, "row"), "0 rows");
  EXPECT_EQ(plural(2, "entry"), "2 entries");
}

}  // namespace
}  // namespace brdf::io
