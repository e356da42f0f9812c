// Tests tables whose angles are phase angles (planets), tangents (roads) and names of geometries.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "io/columns/aspecular_names.h"
#include "io/samples/phase_angle.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using std::numbers::pi;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(PhaseAngle, GivesTheAzimuthBetweenTheDirections) {
  EXPECT_EQ(azimuth_of_phase(30, 30, 0), 0);
  EXPECT_EQ(azimuth_of_phase(30, 30, 60), 180);
  EXPECT_NEAR(azimuth_of_phase(90, 90, 35), 35, 1e-9);
  EXPECT_EQ(azimuth_of_phase(0, 40, 40), 0) << "along the normal any azimuth";
  EXPECT_NEAR(azimuth_of_phase(30, 50, 80.3), 180, 1e-5) << "rounded separately";
  EXPECT_TRUE(std::isnan(azimuth_of_phase(30, 50, 81)));
  EXPECT_TRUE(std::isnan(azimuth_of_phase(0, 40, 30)));
}

TEST(PhaseAngle, ReplacesTheAzimuths) {
  const SampleTable t =
      read("incidence (rad),emission (rad),phase (rad),I/F\n0.5235987755982988,0.5235987755982988,0,.2\n");
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_NEAR(std::remainder(t.phi_o[0] - t.phi_i[0], 360.0), 0, 1e-9);
  EXPECT_NEAR(t.values[0][0], .2 / (pi * std::sqrt(.75)), 1e-12);
  EXPECT_THAT(t.assumptions,
              Contains(HasSubstr("is read as the angle between the incident and the viewing")));
  EXPECT_THAT(
      message("incidence,emission,phase,I/F\n30,50,10,.1\n"),
      HasSubstr("line 2: the phase angle 10 is not possible: directions at 30 and 50 degrees enclose 20 to"));
  EXPECT_THAT(message("incidence,emission,phase,I/F\n30,-50,10,.1\n"), HasSubstr("must not be negative"));
}

TEST(RoadTable, TangentsGoDownAndAzimuthsAlong) {
  const SampleTable t = read("tan gamma \\ beta,0,30,180\n0,600,600,600\n1,200,,150\n");
  ASSERT_EQ(t.rows(), 3u) << "along the normal one row, and no row for the empty cell";
  EXPECT_NEAR(t.values[0][1], 200e-4 * std::pow(2, 1.5), 1e-12);
  EXPECT_NEAR(t.theta_i[1], 45, 1e-12);
  EXPECT_EQ(t.theta_o[1], 89);
  EXPECT_EQ(t.phi_o[1] - t.phi_i[1], 180) << "beta 0 is the mirror side";
  EXPECT_EQ(t.phi_o[2] - t.phi_i[2], 0);
  EXPECT_THAT(t.assumptions, Contains(HasSubstr("an r-table of road lighting")));
  EXPECT_THAT(t.warnings, Contains(HasSubstr("--max-theta 90")));
}

TEST(RoadTable, MayBeTransposedOrStateItsQuantity) {
  const SampleTable t = read("# quantity: f_r\nbeta | tan(gamma),0,1\n0,.06,.02\n30,.06,.03\n");
  EXPECT_NEAR(value_at(t, 45, 30, 89, 180), .03, 1e-12);
}

TEST(RoadTable, MayHaveARowForEachValue) {
  const SampleTable matrix = read("tan gamma \\ beta,0,30\n0,600,600\n1,200,150\n");
  for (const char* text :
       {"beta,tan_gamma,r\n0,0,600\n0,1,200\n30,1,150\n",
        "A road\ntan gamma;beta (deg);r\n0;0;600\n1;0;200\n1;30;150\n",
        "alpha,beta,gamma,r\n1,0,0,600\n1,0,45,200\n1,30,45,150\n",
        "beta,tan gamma,q (cd/m2/lx)\n0,0,.06\n0,1,.056568542494923804\n30,1,.0424264068711929\n"}) {
    const SampleTable t = read(text);
    ASSERT_EQ(t.rows(), 3u) << text;
    EXPECT_THAT(t.assumptions, Contains(HasSubstr("an r-table of road lighting"))) << text;
    for (std::size_t k = 0; k < t.rows(); ++k) {
      EXPECT_EQ(t.theta_o[k], 89) << text;
      EXPECT_NEAR(t.values[0][k], value_at(matrix, t.theta_i[k], t.phi_i[k], 89, t.phi_o[k]), 1e-12) << text;
    }
    EXPECT_EQ(t.phi_o[1] - t.phi_i[1], 180) << text;
  }
  EXPECT_EQ(read("alpha,beta,gamma,q\n1.5,0,45,.06\n").theta_o[0], 88.5);
  // With other angles, beta is no angle of a road.
  EXPECT_THAT(message("theta_i,beta,tan gamma,r\n0,0,0,600\n"), HasSubstr("is the tangent of an r-table's"));
  EXPECT_EQ(read("theta_i,phi_i,theta_o,phi_o,beta,gamma\n30,0,30,180,1,1\n").channels.size(), 2u);
  EXPECT_THAT(message("beta,r\n0,600\n"), HasSubstr("column 'theta_i' is missing"));
  // The quantity of other names is not known.
  EXPECT_THAT(message("beta,gamma,lux\n0,0,600\n"),
              HasSubstr("'lux' of an r-table of road lighting gives no quantity"));
}

TEST(Aspecular, NamesAreReadFromTheMirrorDirectionTowardsTheNormal) {
  const auto angles = [](std::string_view name) {
    const auto found = aspecular_geometry(name);
    return found && found->fault.empty() ? std::pair(found->light, found->viewer) : std::pair(-1.0, -1.0);
  };
  EXPECT_EQ(angles("45as15"), std::pair(45.0, 30.0));
  EXPECT_EQ(angles("45as-15"), std::pair(45.0, 60.0));
  EXPECT_EQ(angles("r45as110"), std::pair(45.0, -65.0));
  EXPECT_EQ(angles("45A:25"), std::pair(45.0, 20.0));
  EXPECT_EQ(angles("45/0"), std::pair(45.0, 0.0));
  for (const char* name : {"550nm", "as15", "45as", "theta_i", "45", "r", "gas15"})
    EXPECT_FALSE(aspecular_geometry(name)) << name;
  for (const char* name : {"45as25az90", "d/8", "8/d", "45as-60"})
    EXPECT_FALSE(aspecular_geometry(name).value().fault.empty()) << name;
}

TEST(Aspecular, GeometriesAreCellsOrColumns) {
  const SampleTable rows = read("geometry;500nm;600nm\n45as15;0,4;0,8\n45as110;0,1;0,2\n");
  EXPECT_EQ(rows.format, "aspecular");
  EXPECT_THAT(rows.channels, ElementsAre("500nm", "600nm"));
  EXPECT_NEAR(value_at(rows, 45, 180, 30, 0, 1), .8 / pi, 1e-12);
  EXPECT_NEAR(value_at(rows, 45, 180, 65, 180), .1 / pi, 1e-12);
  const SampleTable columns =
      read("# instrument: own\nwavelength (nm),45as15,45as110\n500,.4,.1\n600,.8,.2\n");
  EXPECT_EQ(columns.channels, rows.channels);
  EXPECT_EQ(columns.values, rows.values);
  EXPECT_EQ(columns.theta_o, rows.theta_o);
  EXPECT_EQ(*columns.find_metadata("instrument"), "own");
}

TEST(Aspecular, PercentMustBeStated) {
  EXPECT_THAT(message("geometry,500nm\n45as15,40\n"), HasSubstr("--quantity 'BRF %'"));
  const SampleTable t = read("# quantity: BRF %\ngeometry,500nm\n45as15,40\n");
  EXPECT_NEAR(t.values[0][0], .4 / pi, 1e-12);
  EXPECT_NEAR(read("# quantity: f_r\ngeometry,500nm\n45as15,40\n").values[0][0], 40, 1e-12);
}

TEST(Aspecular, RefusesOtherGeometries) {
  const std::pair<std::string, const char*> cases[] = {
      {"geometry,500nm\n45as15,.4\n45as25az90,.1\n", "line 3: the geometry '45as25az90' leaves the plane"},
      {"geometry,500nm\nd/8,.4\n", "is a geometry with an integrating sphere"},
      {"geometry,500nm\n45as15,.4\nmiddle,.1\n", "line 3: 'middle' is not a geometry such as 45as15"},
      {"geometry,500nm\n45as15,x\n", "line 2: column 2 (500nm): 'x' is not a finite number"},
      {"wavelength,45as15,45as25,L\n500,.4,.5,3\n", "column 'L' is neither a geometry nor the wavelength"},
      {"45as15,45as25\n.4,.5\n.4,.5\n", "several rows need a column of wavelengths"},
      {"geometry\n45as15\n", "no column of values"},
      {"wavelength,45as15,45as25\n500,.4\n", "line 2: 2 columns, but the header has 3"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

TEST(RoadsAndPlanets, AgreeWithTheExamples) {
  BRDF_SKIP_WITHOUT(expect_example("r_table.csv", "r_table.expect.csv", {.value = 1e-5}));
  EXPECT_TRUE(expect_example("i_over_f.csv", "i_over_f.expect.csv", {.angle = 1e-3}));
  EXPECT_TRUE(expect_example("aspecular.csv", "aspecular.expect.csv"));
  EXPECT_TRUE(expect_example("aspecular_wide.csv", "aspecular.expect.csv"));
}

}  // namespace
}  // namespace brdf::io
