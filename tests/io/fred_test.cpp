// Tests FRED's tabulated BSDF.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string kFred = "type bsdf_data\nformat angles=deg bsdf=value scale=1\n";

TEST(Fred, HeadOfABlockIsTheMirrorDirection) {
  const SampleTable t = read(kFred + "30 10\n30 10 2\n30 100 .5\n-20 10 .25\n40 0\n0 0 .3\n");
  EXPECT_EQ(t.format, "fred");
  ASSERT_EQ(t.rows(), 4u);
  EXPECT_EQ(value_at(t, 30, 0, 30, 180), 2);
  EXPECT_EQ(value_at(t, 30, 0, 30, 270), .5);
  EXPECT_EQ(value_at(t, 30, 0, 20, 0), .25) << "a negative angle is on the side of the light";
  EXPECT_EQ(value_at(t, 40, 0, 0, 0), .3);
  EXPECT_THAT(t.warnings, Contains(HasSubstr("the head of each block is the mirror direction")));
  EXPECT_EQ(t.lines[3], 8u);
}

TEST(Fred, AppliesScaleAndRadians) {
  const SampleTable t = read(
      "TYPE bsdf_data\r\nformat scale=.5 bsdf=value angles=rad\r\n! a comment\r\n\r\n0.523599\t0\r\n"
      "0.523599\t3.141593\t3\r\n");
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.theta_i[0], 30);
  EXPECT_EQ(value_at(t, 30, 0, 30, 0), 1.5);
  EXPECT_THAT(t.warnings, Contains(HasSubstr("the values times scale=0.5")));
}

TEST(Fred, KeepsRepeatedDirectionsOnceAndCountsGrazingRows) {
  const SampleTable t = read(kFred + "30 0\n0 0 1\n0 90 1\n10 0 2\n10 360 2\n90 0 5\n120 0 6\n");
  EXPECT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.skipped, 2u);
  EXPECT_THAT(t.warnings, Contains(HasSubstr("1 row left out: a polar angle is 90 degrees")));
  EXPECT_THAT(t.warnings, Contains(HasSubstr("above 90 degrees (transmission)")));
}

TEST(Fred, AnnouncesAHighlightOnTheSideOfTheLight) {
  const std::string retro = kFred + "30 0\n30 180 2\n30 0 .5\n0 0 .6\n45 0\n45 180 3\n45 0 .5\n";
  EXPECT_THAT(read(retro).assumptions,
              ElementsAre(HasSubstr("on the side of the incident light for 2 incident")));
  EXPECT_THAT(read(kFred + "30 0\n30 180 .5\n30 0 2\n").assumptions, testing::IsEmpty());
}

TEST(Fred, RefusesWhatItDoesNotUnderstand) {
  const std::pair<std::string, const char*> cases[] = {
      {kFred + "30 0\n30 0 x\n", "line 4: column 3: 'x' is not a finite number"},
      {kFred + "30 0\n30 0 nan\n", "line 4: column 3: 'nan' is not a finite number"},
      {kFred + "30 0 1\n", "line 3: a row of three numbers has no block"},
      {kFred + "30 0\n30 0 1 2\n", "line 4: 4 words: expected are two angles"},
      {kFred + "30 0\n200 0 1\n", "line 4: column 1: 200 must be between -180 and 180 degrees"},
      {kFred + "30 0\n120 0 1\n", "holds no rows of reflected light (1 row left out: a polar angle is above"},
      {kFred, "holds no rows of reflected light"},
      {"type bsdf_data\n30 0\n", "line 2: a line 'format angles=deg bsdf=value scale=1' expected"},
      {"type bsdf_data\nformat angles=deg bsdf=log\n", "'bsdf=log' is not read (known: angles=deg"},
      {"type bsdf_data\nformat angles=deg\n", "must have angles=deg or angles=rad, and bsdf=value"},
      {"type bsdf_data\nformat angles=deg bsdf=value scale=0\n", "the scale must be a number above 0"},
      {"type bsdf_data\nformat angles=deg bsdf=value scale=1e300\n30 0\n30 0 1e300\n",
       "line 4: 1e+300: f_r, times 9.999999999999999e+299, exceeds the range of numbers"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

TEST(Fred, AgreesWithTheExamples) {
  BRDF_SKIP_WITHOUT(expect_example("fred_tiny.txt", "fred_tiny.expect.csv"));
  EXPECT_TRUE(expect_example("fred_in_plane.txt", "two_angle.expect.csv"));
}

TEST(Fred, ReadsAMeasuredFile) {
  const auto file = example("formats", "fred_anoblack_ec1.txt");
  BRDF_SKIP_WITHOUT(file);
  const SampleTable t = read_samples(*file);
  EXPECT_EQ(t.rows(), 2175u);
  EXPECT_NEAR(mean_of(t), .021861933, 1e-9);
  EXPECT_EQ(value_at(t, 10, 180, 15, 0), .033233);
  EXPECT_EQ(value_at(t, 70, 180, 80, 0), 1.823496);
}

}  // namespace
}  // namespace brdf::io
