// Rows that a format repeats because of its coordinates count once. Rows that were measured again, or
// written twice, are kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string kNames = "theta_i,phi_i,theta_o,phi_o,fr\n";

TEST(Repetition, OfAWholeTurnCountsOnce) {
  const SampleTable t =
      read(kNames + "30,0,20,0,1\n30,0,20,90,2\n30,0,20,180,3\n30,0,20,360,1\n30,0,20,-180,3\n");
  EXPECT_THAT(t.values[0], ElementsAre(1, 2, 3));
  EXPECT_THAT(t.lines, ElementsAre(2u, 3u, 4u));
  EXPECT_THAT(t.warnings, Contains(HasSubstr("2 rows repeat a direction with the same values")));
  EXPECT_THAT(read(kNames + "30,180,20,0,1\n30,-180,20,0,1\n").values[0], ElementsAre(1));
}

TEST(Repetition, AlongTheNormalCountsOnce) {
  EXPECT_THAT(read(kNames + "30,0,0,0,1\n30,0,0,45,1\n30,0,0,90,1\n").values[0], ElementsAre(1));
  EXPECT_THAT(read(kNames + "0,0,40,10,1\n0,90,40,10,1\n0,0,40,100,1\n").values[0], ElementsAre(1, 1));
  const std::string two = "theta_i,phi_i,theta_o,phi_o,r,g\n";
  EXPECT_THAT(read(two + "30,0,0,0,1,2\n30,0,0,45,1,3\n").values[0], ElementsAre(1, 1));
}

TEST(Repetition, OfOtherValuesOrTheSameNumbersStays) {
  const SampleTable t = read(kNames + "30,0,20,0,1\n30,0,20,360,1.5\n30,0,0,0,1\n30,0,0,90,2\n30,0,20,0,1\n");
  EXPECT_THAT(t.values[0], ElementsAre(1, 1.5, 1, 2, 1));
  EXPECT_THAT(t.warnings, Not(Contains(HasSubstr("repeat"))));
  // A rotated sample is a different configuration.
  EXPECT_EQ(read(kNames + "30,0,20,180,1\n30,90,20,270,1\n").rows(), 2u);
}

TEST(Repetition, IsLeftOutOfTheLongFormatAstmAndAlta) {
  const SampleTable wide = read(
      "theta_i,phi_i,theta_o,phi_o,wavelength,fr\n30,0,0,0,500,1\n30,0,0,0,600,2\n30,0,0,90,500,1\n30,0,0,90,"
      "600,2\n");
  EXPECT_EQ(wide.rows(), 1u);
  EXPECT_EQ(read("VARS theta_i,phi_i,theta_s,phi_s,Y\n30,180,60,0,1\n30,180,60,360,1\n").rows(), 1u);
  const std::string alta = "#DIM 4 1\n#PARAM_IN SPHERICAL_TL_PL_TV_PV\n#PARAM_OUT INV_STERADIAN\n";
  EXPECT_EQ(read(alta + "0.5 0 0 0 1\n0.5 0 0 1 1\n0.5 0 0 2 1\n").rows(), 1u);
  EXPECT_EQ(read(alta + "0.5 0 0.2 0 1\n0.5 0 0.2 0 1\n").rows(), 2u);
}

TEST(Repetition, OfLensDesignTextCountsOnce) {
  const std::string head =
      "Source Measured\nSymmetry ASymmetrical\nSpectralContent Monochrome\nScatterType BRDF\nSampleRotation "
      "1\n0\n"
      "AngleOfIncidence 2\n0 25\nScatterAzimuth 5\n0 90 180 270 360\nScatterRadial 3\n0 15 "
      "35\nMonochrome\nDataBegin\n";
  const std::string block = "TIS 0.1\n5 4 3\n5 2 1\n5 6 7\n5 8 9\n5 4 3\n";
  const SampleTable t = read(head + block + block + "DataEnd\n");
  EXPECT_EQ(t.rows(), 18u);  // of 30: the mirror direction counts once, the azimuth 360 is dropped
  EXPECT_EQ(t.skipped, 0u);
  EXPECT_THAT(t.warnings, Contains(HasSubstr("12 rows repeat a direction")));
  // If the values at 360 degrees or at the mirror direction differ, they are measurements of their own.
  EXPECT_EQ(read(head + block + "TIS 0.1\n5 4 3\n5 2 1\n5 6 7\n5 8 9\n5 4.5 3\n" + "DataEnd\n").rows(), 19u);
}

}  // namespace
}  // namespace brdf::io
