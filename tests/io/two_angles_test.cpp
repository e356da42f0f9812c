// Tests tables of two signed angles in the plane of incidence, with one row for each pair or as a matrix.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/files/text.h"
#include "io/formats/read.h"
#include "io/samples/in_plane.h"
#include "tests/io/data_folder.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

// Lights at 25 and 50 degrees, with the highlight at the mirror angle and a small one near the light.
const std::string kRows =
    "25,-50,.05\n25,-25,.12\n25,0,.08\n25,25,.7\n25,55,.2\n50,-40,.06\n50,0,.07\n50,50,1.4\n50,70,.5\n";

std::string mirrored(const std::string& rows, bool light) {
  std::string out;
  std::istringstream lines(rows);
  for (std::string line; std::getline(lines, line);) {
    double theta_i, theta_o, value;
    char comma;
    std::istringstream(line) >> theta_i >> comma >> theta_o >> comma >> value;
    out += to_text(light ? -theta_i : theta_i) + "," + to_text(light ? theta_o : -theta_o) + "," +
           to_text(value) + "\n";
  }
  return out;
}

std::vector<double> in_plane_angles(const SampleTable& table) {
  std::vector<double> angles;
  for (std::size_t k = 0; k < table.rows(); ++k) angles.push_back(in_plane_angle(table, k));
  return angles;
}

SampleTable read_with(const std::string& text, MirrorSide side) {
  return read_samples(Content{"file", text}, {"", side});
}

TEST(TwoAngles, PositiveOnTheMirrorSide) {
  for (const char* header : {"Incident angle (deg),Scatter angle (deg),BRDF (1/sr)", "theta_i,theta_o,fr",
                             "AOI,detector angle,brdf", "Incident_angle,Measure_angle,fr"}) {
    const SampleTable t = read(header + ("\n" + kRows));
    EXPECT_THAT(in_plane_angles(t), ElementsAre(-50, -25, 0, 25, 55, -40, 0, 50, 70)) << header;
    EXPECT_THAT(t.warnings,
                Contains("two angles in the plane of incidence: positive viewing angles are on the mirror "
                         "side, because the largest values are there (if not: --mirror-side negative)"));
  }
}

TEST(TwoAngles, NegativeOnTheMirrorSideAreToldByTheHighlight) {
  const SampleTable t = read("theta_i,theta_o,fr\n" + mirrored(kRows, false));
  EXPECT_THAT(in_plane_angles(t), ElementsAre(-50, -25, 0, 25, 55, -40, 0, 50, 70));
  EXPECT_THAT(t.warnings,
              Contains(HasSubstr(
                  "negative viewing angles are on the mirror side, because the largest values are there")));
}

TEST(TwoAngles, OfNegativeLightsAreOnOneScale) {
  const SampleTable t = read("theta_i,theta_o,fr\n" + mirrored(kRows, true));
  EXPECT_THAT(in_plane_angles(t), ElementsAre(-50, -25, 0, 25, 55, -40, 0, 50, 70));
  EXPECT_THAT(t.warnings, Contains(HasSubstr("the mirror direction is at -theta_i")));
  // A retroreflective sample is still one after reading.
  const SampleTable retro = read("theta_i,theta_o,fr\n-40,-40,2\n-40,0,.1\n-40,40,.2\n");
  EXPECT_THAT(in_plane_angles(retro), ElementsAre(-40, 0, 40));
}

TEST(TwoAngles, WithoutAHighlightAreAGuessThatIsAnnounced) {
  const SampleTable t = read("theta_i,theta_o,fr\n30,-40,.3\n30,0,.3\n30,40,.3\n60,-40,.3\n60,50,.3\n");
  EXPECT_THAT(in_plane_angles(t), ElementsAre(-40, 0, 40, -40, 50));
  EXPECT_THAT(
      t.warnings,
      Contains(HasSubstr(
          "positive viewing angles are assumed to be on the mirror side, because the values do not decide")));
}

TEST(TwoAngles, MayBeToldTheSide) {
  const std::string retro = "theta_i,theta_o,fr\n40,-40,2\n40,0,.1\n40,40,.2\n";
  EXPECT_THAT(in_plane_angles(read(retro)), ElementsAre(40, 0, -40));
  EXPECT_THAT(in_plane_angles(read_with(retro, MirrorSide::positive)), ElementsAre(-40, 0, 40));
  EXPECT_THAT(in_plane_angles(read_with(retro, MirrorSide::negative)), ElementsAre(40, 0, -40));
  const auto refusal = [](const std::string& text) {
    return message_of([&] { read_with(text, MirrorSide::positive); });
  };
  EXPECT_THAT(refusal(std::string(kHeader) + kRow),
              HasSubstr("--mirror-side applies to tables with two angles"));
  EXPECT_THAT(refusal(kAstm), HasSubstr("--mirror-side applies to tables with two angles"));
  EXPECT_THAT(refusal(kLens), HasSubstr("--mirror-side applies to tables with two angles"));
}

TEST(TwoAngles, MayBeRadiansByTheirNames) {
  const SampleTable t = read(
      "theta_i (rad),theta_o (rad),fr\n0.5235987755982988,-0.5235987755982988,.1\n"
      "0.5235987755982988,0.5235987755982988,.9\n");
  EXPECT_THAT(t.theta_i, ElementsAre(30, 30));
  EXPECT_THAT(in_plane_angles(t), ElementsAre(-30, 30));
  EXPECT_TRUE(t.raw_angles[2].has_unit);
  EXPECT_THAT(t.raw_angles[2].magnitudes, ElementsAre(0.5235987755982988));
}

TEST(TwoAngles, TakeTheQuantityOfTheirNamesOrAComment) {
  const SampleTable brf = read(
      "# quantity: BRF\nIncident_angle,Measure_angle, 500nm , 600nm\n30,30,3.141592653589793,1\n30,0,1,1\n");
  EXPECT_THAT(brf.channels, ElementsAre("500nm", "600nm"));
  EXPECT_THAT(brf.values[0][0], DoubleEq(1));
  const SampleTable unsaid = read("Incident_angle,Measure_angle, 500nm , 600nm\n30,30,3,1\n30,0,1,1\n");
  EXPECT_EQ(unsaid.values[0][0], 3);
  EXPECT_THAT(unsaid.warnings, Contains(HasSubstr("'500nm', '600nm' is interpreted as f_r in 1/sr")));
}

TEST(Matrix, OfIncidencesAlongOrDownIsTheSameTable) {
  const char* const same = "25,-25,.12\n25,0,.08\n25,25,.7\n50,0,.07\n50,25,.3\n50,50,1.4\n";
  const SampleTable rows = read("theta_i,theta_o,fr\n" + std::string(same));
  for (const char* matrix :
       {"# quantity: BRDF\ntheta_s \\ theta_i,25,50\n-25,.12,\n0,.08,.07\n25,.7,.3\n50,,1.4\n",
        "viewing angle (deg) | incidence (deg),25,50\n-25,.12,nan\n0,.08,.07\n25,.7,.3\n50,-,1.4\n",
        "incidence;-25;0;25;50\n25;0,12;0,08;0,7;\n50;;0,07;0,3;1,4\n",
        "theta_i/theta_o\t-25\t0\t25\t50\n25\t.12\t.08\t.7\t\n50\t\t.07\t.3\t1.4\n"}) {
    const SampleTable t = read(matrix);
    ASSERT_EQ(t.rows(), rows.rows()) << matrix;
    EXPECT_EQ(t.skipped, 2u);
    EXPECT_THAT(t.warnings, Contains("2 empty cells of the matrix are treated as not measured"));
    std::map<std::pair<double, double>, double> found, expected;
    for (std::size_t k = 0; k < t.rows(); ++k) {
      found[{t.theta_i[k], in_plane_angle(t, k)}] = t.values[0][k];
      expected[{rows.theta_i[k], in_plane_angle(rows, k)}] = rows.values[0][k];
    }
    EXPECT_EQ(found, expected) << matrix;
  }
}

TEST(Matrix, TakesTitlesQuantitiesAndRadians) {
  const SampleTable t =
      read("BRF of a tile\ntheta_o \\ theta_i (rad),0.5235987755982988,1\n-30,1,\n30,3.141592653589793,\n");
  EXPECT_THAT(t.theta_i, ElementsAre(30, 30));
  EXPECT_THAT(t.values[0][1], DoubleEq(1));
  EXPECT_THAT(t.raw_angles[0].magnitudes, ElementsAre(0.5235987755982988));
  EXPECT_THAT(read("incidence,-30,0,30\n30,.1,.2,.3\n").warnings,
              Contains("the values are interpreted as f_r in 1/sr, because the matrix gives no quantity"));
}

TEST(Matrix, ThatIsDamagedIsRefusedWithLineAndColumn) {
  EXPECT_THAT(message("theta_o \\ theta_i,10,20\n5,1\n"),
              HasSubstr("line 2: 2 columns, but the header has 3"));
  EXPECT_THAT(message("theta_o \\ theta_i,10,20\n5,1,x\n"), HasSubstr("line 2: column 3"));
  EXPECT_THAT(message("theta_o \\ theta_i,10,20\n95,1,2\n"), HasSubstr("is below the horizon"));
  EXPECT_THAT(message("reading,10,20\n5,1,2\n"),
              HasSubstr("in a matrix of two angles the first cell names both angles"));
}

// A polar angle that a line above the header row states for the whole table, and the rows with the angle in a
// column.
TEST(StatedAngle, AboveTheTableIsThatOfAllRows) {
  const std::string rows = "-40,.06\n0,.07\n50,1.4\n70,.5\n";
  for (const char* above :
       {"# Incidence angle: 50 deg\nscatter angle,fr\n", "# theta_i = 50\ntheta_s,fr\n",
        "AOI,50\nwavelength,633\nscatter angle (deg),fr\n", "Incident angle 50°\n\nscatter angle,fr\n",
        "# theta_i (rad): 0.872664625997165\ntheta_o,fr\n", "# light elevation: 40\ntheta_o,fr\n",
        "operator: nobody\nangle of incidence: 50\n% theta_o,fr\n", "% theta_i: 50\ntheta_s,fr\n",
        "# theta_i: 50\n# theta_i: 50.0\nmeasurement,fr\n"}) {
    const SampleTable t = read(above + rows);
    EXPECT_THAT(in_plane_angles(t), ElementsAre(-40, 0, 50, 70)) << above;
    EXPECT_THAT(t.theta_i, testing::Each(testing::DoubleNear(50, 1e-12))) << above;
    EXPECT_THAT(t.assumptions, Contains(testing::StartsWith("theta_i is 50"))) << above;
  }
  const SampleTable viewer = read("# detector angle: 20\ntheta_i,phi_i,fr\n30,0,.1\n50,90,.2\n");
  EXPECT_THAT(viewer.theta_o, ElementsAre(20, 20));
  EXPECT_THAT(viewer.assumptions, Contains("theta_o is 20 degrees in all rows, as line 1 states"));
}

TEST(StatedAngle, IsNotTakenFromOtherLines) {
  const std::string rows = "10,.1\n20,.2\n";
  // A word with other meanings, another unit, no number, an azimuth.
  for (const char* above : {"# source: 30\n", "# incidence angle: 30 mm\n", "# incidence angle: several\n",
                            "# phi_i: 30\n", "# incidence angle: 30 to 60\n"})
    EXPECT_THAT(message(above + ("theta_o,fr\n" + rows)), HasSubstr("column 'theta_i' is missing")) << above;
  EXPECT_THAT(message("# theta_i: 95\ntheta_o,fr\n" + rows), HasSubstr("line 1 is beyond 90 degrees"));
  EXPECT_THAT(message("# theta_i: 30\n# AOI: 45\ntheta_o,fr\n" + rows),
              HasSubstr("the angle 45 of line 2 contradicts the angle 30 of line 1: add a column 'theta_i'"));
  EXPECT_THAT(message("# theta_i: 30\ntheta_o,fr\n10,.1\n# theta_i: 45\n20,.2\n"),
              HasSubstr("line 4: 'theta_i' is 45 degrees here, and 30 above the header row"));
  // A column is the angle, whatever a comment states; a matrix of one column stays one.
  const SampleTable column = read("# theta_i: 30\ntheta_i,theta_o,fr\n10,20,.1\n20,30,.2\n");
  EXPECT_THAT(column.theta_i, ElementsAre(10, 20));
  const SampleTable source = read("# incidence angle: 30\ntheta_s,phi_s,theta_v,phi_v,fr\n10,0,20,180,.1\n");
  EXPECT_THAT(source.theta_i, ElementsAre(10));
  EXPECT_THAT(message("# theta_i: 30\ntheta_o,fr\n10,.1\n% theta_i: 45\n20,.2\n"),
              HasSubstr("line 4: 'theta_i' is 45 degrees here"));
  const SampleTable matrix = read("incidence,45\n10,.3\n20,.2\n");
  EXPECT_THAT(matrix.theta_i, ElementsAre(10, 20));
}

// Names of angles that are not measured from the normal are refused by name.
TEST(OtherAngles, AreRefusedByName) {
  const std::pair<const char*, const char*> cases[] = {
      {"beta-beta0,BRDF (1/sr)\n.1,5\n", "column 'beta-beta0' is a difference of sines"},
      {"|β-β₀|,BRDF\n.1,5\n", "is a difference of sines"},
      {"theta_i,theta_s - theta_spec,BRDF\n10,5,1\n", "is an angle from the mirror direction"},
      {"AOI,delta (deg),BRDF\n10,5,1\n", "is an angle from the mirror direction"},
      {"incidence,aspecular angle,BRF\n10,5,1\n", "is an angle from the mirror direction"},
      {"src_z RF\n30 0.9\n", "column 'theta_o' is missing"},
      {"src_z RF\n30 0.9\n", "no column has the viewing angle"},
      {"theta_i,fr\n30,.9\n", "no column has the viewing angle, and no line above states it"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

class PublishedTables : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = measured_data();
    if (!folder) GTEST_SKIP() << "BRDF_DATA_DIR is unset";
    folder_ = folder->parent_path() / "formats";
  }
  static double mean(const SampleTable& table, const std::string& channel) {
    const auto c = std::size_t(std::find(table.channels.begin(), table.channels.end(), channel) -
                               table.channels.begin());
    double sum = 0;
    for (const double value : table.values.at(c)) sum += value;
    return sum / double(table.rows());
  }
  std::filesystem::path folder_;
};

TEST_F(PublishedTables, OfTwoAnglesGiveTheirMeans) {
  const SampleTable t = read_samples(folder_ / "speos_2d_white_tile.csv");
  EXPECT_EQ(t.rows(), 329u);
  EXPECT_EQ(t.channels.size(), 35u);
  EXPECT_NEAR(mean(t, "390nm"), 4.7474997, 1e-6);
  EXPECT_NEAR(mean(t, "550nm"), 5.6551243, 1e-6);
  EXPECT_THAT(t.warnings,
              Contains(HasSubstr("positive viewing angles are on the mirror side, because the largest")));
  const SampleTable brf = read_samples(folder_ / "speos_2d_white_tile.csv", {"BRF", MirrorSide::automatic});
  EXPECT_NEAR(mean(brf, "550nm"), 1.8000820, 1e-6);
}

TEST_F(PublishedTables, WithTitlesGiveTheirMeans) {
  const SampleTable t = read_samples(folder_ / "blacklab_spectralon_brf.txt");
  EXPECT_EQ(t.rows(), 19u);
  EXPECT_EQ(t.channels.size(), 11u);
  EXPECT_NEAR(mean(t, "385.65nm"), .31380510, 1e-5 * .3138);
  EXPECT_NEAR(mean(t, "1059.04nm"), .31991844, 1e-5 * .3199);
}

TEST_F(PublishedTables, OfMuellerElementsGiveFrOfUnpolarisedLight) {
  const SampleTable t = read_samples(folder_ / "nist_ptfe_532_633.csv");
  EXPECT_EQ(t.rows(), 1824u);
  EXPECT_NEAR(mean(t, "532nm"), .31312664, 1e-6);
  EXPECT_NEAR(mean(t, "633nm"), .31327138, 1e-6);
}

}  // namespace
}  // namespace brdf::io
