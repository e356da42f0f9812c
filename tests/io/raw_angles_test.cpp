// Tests that the angles of a file are kept in their original form, as evidence for their unit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/temporary.h"
#include "io/formats/exr_table.h"
#include "io/formats/read.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(RawAngles, AreTheCellsBeforeUnitsSignsAndConventions) {
  const SampleTable t =
      read("Theta_i (rad);elevation_o;Relative azimuth;fr\n0.5;70;3.125;1\n0.25;70;3.125;2\n0.5;65;-1.5;3\n");
  EXPECT_EQ(t.raw_angles[0].name, "Theta_i (rad)");
  EXPECT_TRUE(t.raw_angles[0].has_unit);
  EXPECT_THAT(t.raw_angles[0].magnitudes, ElementsAre(0.5, 0.25));
  EXPECT_THAT(t.raw_angles[1].name, IsEmpty());  // the single azimuth is the viewer's
  EXPECT_THAT(t.raw_angles[1].magnitudes, IsEmpty());
  EXPECT_EQ(t.raw_angles[2].name, "elevation_o");
  EXPECT_FALSE(t.raw_angles[2].has_unit);
  EXPECT_THAT(t.raw_angles[2].magnitudes, ElementsAre(70, 65));
  EXPECT_EQ(t.raw_angles[2].largest, 70);
  EXPECT_THAT(t.raw_angles[3].magnitudes, ElementsAre(3.125, 1.5));
}

TEST(RawAngles, OfANegativePolarAngleHoldNoHalfTurn) {
  const SampleTable t = read("theta_i,phi_i,theta_o,phi_o,fr\n0.3,0,-1.2,3.14,1\n0.3,0,1.2,3.14,1\n");
  EXPECT_THAT(t.raw_angles[2].magnitudes, ElementsAre(1.2));
  EXPECT_THAT(t.raw_angles[3].magnitudes, ElementsAre(3.14));
}

TEST(RawAngles, AreAThousandAtMostAndTheLargestOfAll) {
  std::string text = "theta_i,phi_i,theta_o,phi_o,fr\n";
  for (int k = 0; k < 3000; ++k) text += "10,0,20," + std::to_string(k % 1500) + ".5,1\n";
  const SampleTable t = read(text);
  EXPECT_EQ(t.raw_angles[3].magnitudes.size(), kMostRawMagnitudes);
  EXPECT_EQ(t.raw_angles[3].largest, 1499.5);
  EXPECT_THAT(t.raw_angles[0].magnitudes, ElementsAre(10));
}

TEST(RawAngles, AreKeptOfTheLongFormatAstmAndOpenExr) {
  const SampleTable wide =
      read("theta_i,phi_i,theta_o,phi_o,wavelength,fr\n10,0,20,180,500,1\n10,0,20,180,600,2\n");
  EXPECT_THAT(wide.raw_angles[2].magnitudes, ElementsAre(20));
  const SampleTable astm = read("VARS theta_i,phi_i,theta_s,phi_s,Y\n.25,3.125,-.5,0,1\n");
  EXPECT_THAT(astm.raw_angles[2].magnitudes, ElementsAre(.5));
  EXPECT_FALSE(astm.raw_angles[2].has_unit);
  EXPECT_TRUE(
      read("ANGLE_UNIT degrees\nVARS theta_i,phi_i,theta_s,phi_s,Y\n1,2,3,4,5\n").raw_angles[0].has_unit);
  const TemporaryFolder folder;
  write_exr_table(folder.path() / "t.exr", wide);
  const SampleTable exr = read_samples(folder.path() / "t.exr");
  EXPECT_THAT(exr.raw_angles[3].magnitudes, ElementsAre(180));
}

// An azimuth beyond a whole turn must be in degrees, however small the polar angles are.
TEST(Astm, ScansNearTheNormalAreInDegrees) {
  const SampleTable t =
      read("VARS theta_i,phi_i,theta_s,phi_s,Y\n0,0,.3,180,60\n0,0,.9,180,20\n0,0,1.3,180,9\n");
  EXPECT_THAT(t.theta_o, ElementsAre(.3, .9, 1.3));
  EXPECT_THAT(t.warnings, ElementsAre("angles are assumed to be in degrees"));
}

TEST(SmallAngles, WithoutAUnitAreAnnounced) {
  const auto words = [](const std::string& text) { return testing::PrintToString(read(text).assumptions); };
  const std::string rows = "0.5236,0,0.5236,3.1416,.5\n0.5236,0,0.2,3.1416,.4\n";
  const char* const sentence =
      "the polar angles reach only 0.5236, and the header gives no unit: read as degrees";
  EXPECT_THAT(words("theta_i,phi_i,theta_r,phi_r,brdf\n" + rows), testing::HasSubstr(sentence));
  EXPECT_THAT(words("theta_i,phi_i,theta_o,phi_o,fr\n" + rows), testing::HasSubstr(sentence));
  // A stated unit, whole numbers, and larger angles are read without this message.
  for (const std::string& text : {"theta_i (deg),phi_i,theta_r (deg),phi_r,brdf\n" + rows,
                                  "theta_i (rad),phi_i,theta_r,phi_r,brdf\n" + rows,
                                  std::string("theta_i,phi_i,theta_r,phi_r,brdf\n1,0,1,180,.5\n"),
                                  "theta_i,phi_i,theta_r,phi_r,brdf\n" + rows + "30,0,20.5,180,.5\n"})
    EXPECT_THAT(words(text), testing::Not(testing::HasSubstr("reach only"))) << text;
}

}  // namespace
}  // namespace brdf::io
