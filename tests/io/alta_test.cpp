// Tests the tables of ALTA: one measurement, written in each of the parametrisations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/samples/samples.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Written {
  const char *name, *row;
};

std::ostream& operator<<(std::ostream& out, const Written& w) {
  return out << w.name;
}

std::string header(const std::string& dimensions, const std::string& name) {
  return "#SAMPLE \"Gray tape\"\n#DIM " + dimensions + "\n#PARAM_IN " + name + "\n#PARAM_OUT INV_STERADIAN\n";
}

// The light is at 30 degrees and the viewer at 50 degrees, with 120 degrees of azimuth between them. The
// half and difference angles follow Rusinkiewicz 1998 and were calculated independently of the reader.
class Parametrisations : public testing::TestWithParam<Written> {};

TEST_P(Parametrisations, SayTheSameDirections) {
  const std::string row = GetParam().row;
  const long columns = std::count(row.begin(), row.end(), ' ') + 1;
  const SampleTable t = read(header(std::to_string(columns) + " 1", GetParam().name) + row + " 0.25\n");
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.format, "alta");
  EXPECT_THAT(t.channels, ElementsAre("f"));
  EXPECT_NEAR(t.theta_i[0], 30, 1e-9);
  EXPECT_NEAR(t.theta_o[0], 50, 1e-9);
  const double between = std::remainder(t.phi_o[0] - t.phi_i[0], 360.0);
  EXPECT_NEAR(std::abs(between), 120, 1e-9);
  EXPECT_EQ(t.values[0][0], 0.25);
  EXPECT_EQ(*t.find_metadata("SAMPLE"), "\"Gray tape\"");
}

constexpr Written kWritten[] = {
    {"SPHERICAL_TL_PL_TV_PV", "0.5235987755982988 0.1 0.8726646259971648 2.1943951023931953"},
    {"ISOTROPIC_TV_TL_DPHI", "0.8726646259971648 0.5235987755982988 2.0943951023931953"},
    {"ISOTROPIC_TL_TV_PROJ_DPHI", "0.5235987755982988 -0.4363323129985822 0.7557497350975908"},
    {"RUSIN_TH_TD_PD", "0.41991916007752167 0.5984962127171533 1.0633436001088312"},
    {"RUSIN_TH_PH_TD_PD", "0.41991916007752167 0.7 0.5984962127171533 1.0633436001088312"},
    {"CARTESIAN", "-0.38302222155948895 0.6634139481689384 0.6427876096865394 0.5 0 0.8660254037844387"},
};
INSTANTIATE_TEST_SUITE_P(Alta, Parametrisations, testing::ValuesIn(kWritten),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(Alta, ThreeValuesAreColoursSegmentsAndTheCosineAreTakenOff) {
  const SampleTable t = read(
      "#DIM 4 3\n#PARAM_IN SPHERICAL_TL_PL_TV_PV\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n#VS 1 1 1\n"
      "0.5 0 1.0471975511965976 3 1 2 3 .1 .1 .1\n0.5 0 1.8 3 1 2 3 .1 .1 .1\n");
  EXPECT_THAT(t.channels, ElementsAre("r", "g", "b"));
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.skipped, 1u);
  EXPECT_NEAR(t.values[1][0], 4, 1e-12);
  EXPECT_THAT(t.warnings, ElementsAre(HasSubstr("below the horizon"), HasSubstr("vertical segments"),
                                      HasSubstr("divided by the cosine of the viewing direction")));
}

TEST(Alta, WhatIsNotUnderstoodIsRefused) {
  const std::string ok = header("3 1", "RUSIN_TH_TD_PD");
  const std::pair<std::string, const char*> cases[] = {
      {header("2 1", "RUSIN_TH_TD") + "0 0 1\n", "line 3: #PARAM_IN 'RUSIN_TH_TD' does not give both"},
      {header("2 1", "RUSIN_TH_TD_PD") + "0 0 1\n", "#DIM has 2 angles, but RUSIN_TH_TD_PD has 3"},
      {header("many", "CARTESIAN"), "line 2: '#DIM <angles> <channels>' expected"},
      {ok + "0 0 0\n", "line 5: 3 columns, but #DIM requires 4"},
      {ok + "0 0 x 1\n", "line 5: column 3: 'x' is not a finite number"},
      {ok, "holds no rows"},
      {ok + "#FORMAT binary\n", "binary tables of ALTA are not read"},
      {"#DIM 3 1\n#PARAM_IN RUSIN_TH_TD_PD\n#PARAM_OUT ENERGY\n0 0 0 1\n", "#PARAM_OUT 'ENERGY' is not f_r"},
  };
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

}  // namespace
}  // namespace brdf::io
