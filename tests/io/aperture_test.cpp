// Tests the width of the detector that a table states.
#include <gtest/gtest.h>

#include "io/samples/aperture.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

double stated(const std::string& comment) {
  return stated_aperture(read("# " + comment + "\n" + kHeader + kRow)).value_or(0);
}

TEST(Aperture, FollowsFromTheSolidAngle) {
  EXPECT_NEAR(aperture_of_solid_angle(.0038275), 4, .001);
  EXPECT_NEAR(aperture_of_solid_angle(.002194), 3.03, .005);
  EXPECT_NEAR(aperture_of_solid_angle(2 * 3.14159265358979), 180, 1e-6);
}

TEST(Aperture, IsStatedByComments) {
  EXPECT_EQ(stated("detector_aperture: 4"), 4);
  EXPECT_EQ(stated("Detector aperture: 4 degrees"), 4);
  EXPECT_EQ(stated("APERTURE: 2.5 deg"), 2.5);
  EXPECT_NEAR(stated("SOLID_ANGLE: 0.0038275"), 4, .001);
  EXPECT_NEAR(stated("collection solid angle: 3.8275 msr"), 4, .001);
  for (const char* other :
       {"aperture: Circular", "aperture: 2", "aperture: 5 mm", "detector_aperture: -4",
        "detector_aperture: 400", "solid_angle: 7 sr", "solid_angle: 4 deg", "note: 4 degrees"})
    EXPECT_EQ(stated(other), 0) << other;
}

TEST(Aperture, IsAKeywordOfAstm) {
  const SampleTable t = read(std::string("SOLID_ANGLE 0.0038275\n") + kAstm);
  EXPECT_NEAR(stated_aperture(t).value_or(0), 4, .001);
}

}  // namespace
}  // namespace brdf::io
