// A table that is written in the format of another program is read back unchanged, or is refused, or the
// loss is reported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "io/files/content.h"
#include "io/files/temporary.h"
#include "io/formats/any_table.h"
#include "io/formats/read.h"
#include "tests/io/data_folder.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class RoundTrips : public testing::Test {
 protected:
  // Writes the table under this suffix and reads it again. `lost_` receives the losses that the writer
  // reported.
  SampleTable again(const SampleTable& table, const std::string& suffix) {
    const std::filesystem::path path = folder_.path() / ("file" + suffix);
    lost_ = write_table(path, table);
    return read_samples(path);
  }
  std::string refusal(const SampleTable& table, const std::string& suffix) {
    return message_of([&] { again(table, suffix); });
  }
  io::TemporaryFolder folder_;
  std::vector<std::string> lost_;
};

const std::string kAngles = "theta_i,phi_i,theta_o,phi_o,";

TEST_F(RoundTrips, AstmHoldsWhatACsvDoes) {
  for (const char* text :
       {"# sample: a \"quoted\" one\n# VENDOR:\n# Source: Measured\ntheta_i,phi_i,theta_o,phi_o,r,"
        "my channel,465nm,sigma_r,sigma_465nm\n.1,180,1.5,0.30000000000000004,1e-300,-2,3,.1,.2\n"
        "0,-720.5,.7,1e6,5,6,7,.3,.4\n",
        "theta_i,phi_i,theta_o,phi_o,fr\n30,180,90,5,1\n30,180,90,5,2\n"}) {
    const SampleTable table = read(text), back = again(table, ".astm");
    EXPECT_EQ(back.format, "astm_e1392");
    expect_same(back, table);
    EXPECT_THAT(lost_, IsEmpty());
    EXPECT_THAT(back.warnings, IsEmpty());
  }
}

TEST_F(RoundTrips, AstmSaysWhatItCannotHold) {
  SampleTable table =
      read("# free text\n# a key: b\n# kept: yes\n# : quantity: counts\n" + kAngles + "fr\n1,2,3,4,5\n");
  const SampleTable back = again(table, ".astm");
  EXPECT_THAT(lost_, ElementsAre("3 comments that are not a keyword with a value"));
  table.metadata = {{"kept", "yes"}};
  expect_same(back, table);
  EXPECT_THAT(refusal(read("# quantity: f_r\n" + kAngles + "theta_s\n1,2,3,4,5\n"), ".astm"),
              HasSubstr("channel 'theta_s' is the name of an angle in ASTM E1392"));
  SampleTable many = read(kAngles + "fr\n1,2,3,4,5\n");
  for (int k = 0; k < 2000; ++k) many.add_comment("key" + std::to_string(k), "value");
  EXPECT_EQ(again(many, ".astm").rows(), 1u);
  EXPECT_THAT(lost_, ElementsAre(HasSubstr("1002 comments")));
}

TEST_F(RoundTrips, AstmColumnsOfStandardDeviationsAreRead) {
  const std::string vars = "VARS theta_i,phi_i,theta_s,phi_s,";
  const SampleTable got = read("ANGLE_UNIT radians\n" + vars + "400,sigma_400\n0.5,1,1,0,2,.1\n");
  EXPECT_THAT(got.channels, ElementsAre("400nm"));
  EXPECT_THAT(got.sigma[0], ElementsAre(.1));
  EXPECT_THAT(got.metadata, IsEmpty());
  EXPECT_NEAR(got.theta_i[0], 28.64788975654116, 1e-13);
  EXPECT_THAT(message(vars + "Y,sigma_X\n.5,1,1,0,2,.1\n"), HasSubstr("'sigma_X' has no column of values"));
  EXPECT_THAT(message(vars + "Y,sigma_Y,sigma_Y\n.5,1,1,0,2,.1,.1\n"), HasSubstr("'sigma_Y' twice"));
  EXPECT_THAT(message(vars + "Y,sigma_Y\n.5,1,1,0,2,0\n"), HasSubstr("must be above 0"));
}

constexpr const char* kTwoIncidences =
    "# Sample: test\nSource Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType "
    "BRDF\n"
    "SampleRotation 1\n0\nAngleOfIncidence 2\n15 40\nScatterAzimuth 3\n0 45.5 180\nScatterRadial 3\n0 7.25 "
    "35\n"
    "Monochrome\nDataBegin\nTIS 0.5\n1 2 3\n1 4 5\n1 0 6\nTIS .5\n7 8 9\n7 .1 .2\n7 .3 .4\nDataEnd\n";

TEST_F(RoundTrips, LensDesignTextHoldsWhatWasReadFromIt) {
  const std::string one = kTwoIncidences;
  for (const std::string& text :
       {one, replaced(replaced(one, "0 45.5 180", "10 200 350"), "PlaneSymmetrical", "ASymmetrical")}) {
    const SampleTable table = read(text), back = again(table, ".zemax");
    EXPECT_EQ(back.format, "zemax");
    expect_same(back, table);
    EXPECT_THAT(lost_, IsEmpty());
    const std::string written = read_content(folder_.path() / "file.zemax").bytes;
    EXPECT_THAT(written,
                HasSubstr(text == one ? "Symmetry\tPlaneSymmetrical\n" : "Symmetry\tASymmetrical\n"));
  }
  std::string colours =
      "Source Measured\nSymmetry ASymmetrical4D\nSpectralContent XYZ\nScatterType BRDF\n"
      "SampleRotation 2\n0 90\nAngleOfIncidence 1\n60\nScatterAzimuth 1\n45\nScatterRadial 2\n5 10\n";
  for (const char* axis : {"X", "Y", "Z"})
    colours += "Tristimulus" + std::string(axis) + "\nDataBegin\nTIS 1\n.1 .2\nTIS 1\n.3 .4\nDataEnd\n";
  const SampleTable table = read(colours);
  ASSERT_EQ(table.rows(), 4u);
  expect_same(again(table, ".zemax"), table);
  EXPECT_THAT(lost_, IsEmpty());
}

// Returns the rows sorted by their directions, because a grid has an order of its own.
std::vector<std::array<double, 5>> sorted_rows(const SampleTable& t) {
  std::vector<std::array<double, 5>> rows;
  for (std::size_t k = 0; k < t.rows(); ++k)
    rows.push_back(
        {t.theta_i[k], t.phi_i[k], t.theta_o[k], t.theta_o[k] == 0 ? 0 : t.phi_o[k], t.values[0][k]});
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST_F(RoundTrips, LensDesignTextHoldsAScanInThePlaneOfIncidence) {
  std::string text = kAngles + "fr\n";
  for (const int theta_i : {0, 15, 30, 60})
    for (int theta_o = 0; theta_o <= 80; theta_o += 5)
      for (const int phi_o : {0, 180})
        if ((theta_o > 0 || phi_o == 0) && (theta_i > 0 || phi_o == 0))
          text += std::to_string(theta_i) + ",180," + std::to_string(theta_o) + "," + std::to_string(phi_o) +
                  "," + std::to_string(1 + theta_i + theta_o) + "\n";
  const SampleTable table = read(text);
  EXPECT_EQ(sorted_rows(again(table, ".zemax")), sorted_rows(table));
  EXPECT_THAT(lost_, IsEmpty());
  SampleTable turned = table;
  for (double& phi : turned.phi_i) phi -= 180;
  for (double& phi : turned.phi_o) phi = phi == 0 ? 180 : 0;
  EXPECT_EQ(sorted_rows(again(turned, ".zemax")), sorted_rows(table));
  EXPECT_THAT(
      lost_,
      ElementsAre("the azimuth of incidence, 0 degrees: all azimuths are rotated so that it is 180 degrees"));
}

TEST_F(RoundTrips, LensDesignTextSaysWhatItCannotHold) {
  const std::string rows = "30,180,30,0,1,.1\n30,180,40,0,2,.1\n30,180,50,0,0,.1\n30,180,90,0,4,.1\n";
  again(read("# free text\n" + kAngles + "Y,sigma_Y\n" + rows), ".zemax");
  EXPECT_THAT(lost_, ElementsAre("1 row at 90 degrees",
                                 "1 row with the value 0, which the format defines as 'not measured'",
                                 "1 comment that cannot be written as a short key with a value",
                                 "the channel's name", "standard deviations"));
  again(read(kAngles + "fr\n30,180,40.12345678901,0,1\n"), ".zemax");
  EXPECT_THAT(lost_, ElementsAre(HasSubstr("directions beyond ")));
  EXPECT_THAT(refusal(read(kAngles + "r,g,b\n1,2,3,4,5,6,7\n"), ".zemax"),
              HasSubstr("lens-design text stores one channel, or X, Y and Z; the table has r, g, b"));
  EXPECT_THAT(refusal(read(kAngles + "fr\n30,180,40,0,1\n30,180,40,0,2\n"), ".zemax"),
              HasSubstr("stores each direction once: file, line 2 and file, line 3 have the same"));
  EXPECT_THAT(refusal(read(kAngles + "fr\n30,180,40,0,0\n"), ".zemax"),
              HasSubstr("needs a value that is not 0"));
  std::string hemisphere = kAngles + "fr\n";
  for (int theta = 10; theta < 80; theta += 10)
    for (int phi = 0; phi < 360; phi += 20)
      hemisphere += "30,180," + std::to_string(theta) + "," + std::to_string(phi) + ",1\n";
  EXPECT_THAT(
      refusal(read(hemisphere), ".zemax"),
      HasSubstr(
          "stores directions on a grid around the mirror direction: the 126 rows require 1 incidences, "));
}

// f_r = 1/pi everywhere reflects all light.
TEST_F(RoundTrips, LensDesignTextStatesTheScatteredShare) {
  std::string text = kAngles + "fr\n";
  for (int theta = 0; theta < 90; theta += 2)
    for (int phi = 0; phi < (theta == 0 ? 1 : 360); phi += 20)
      text += "0,180," + std::to_string(theta) + "," + std::to_string(phi) + ",0.3183098861837907\n";
  again(read(text), ".zemax");
  const std::string written = read_content(folder_.path() / "file.zemax").bytes;
  EXPECT_NEAR(std::stod(written.substr(written.find("TIS") + 4)), 1, .002);
}

// Numbers of six digits are read back unchanged; order, comments and standard deviations are kept, too.
TEST_F(RoundTrips, OpenExrHoldsNumbersOfSixDigits) {
  std::string text =
      "# sample: x\n# free text\n# sample: y\n# type: deepscanline\n# columns: none\n# : quantity: counts\n" +
      kAngles + "r,465nm,b,sigma_b,sigma_r\n";
  for (int row = 0; row < 1500; ++row) {
    const std::string n = std::to_string(row);
    text += "30.1,180," + std::to_string(row % 90) + ".25,-720.5," + n + "e-7,-0.0" + n + ",1e30,.1,1e-40\n";
  }
  const SampleTable table = read(text), back = again(table, ".exr");
  EXPECT_EQ(back.format, "exr");
  SampleTable expected = table;
  expected.sigma[0] = back.sigma[0];  // too small for a float to hold six digits
  expect_same(back, expected);
  EXPECT_NEAR(back.sigma[0][7], 1e-40, 1e-45);
  EXPECT_THAT(lost_, ElementsAre("digits beyond 32-bit float (7 significant ones)"));
  EXPECT_THAT(back.warnings, IsEmpty());
  expect_same(again(back, ".exr"), back);
}

// Other programs expect numbers or other types under these names and complain about a string.
TEST_F(RoundTrips, OpenExrHasNoStringUnderTheNameOfAnAttributeOfAnotherType) {
  constexpr const char* kTyped[] = {"aperture",    "expTime",        "isoSpeed",       "focus",
                                    "xDensity",    "utcOffset",      "timeCode",       "worldToCamera",
                                    "keyCode",     "whiteLuminance", "imageCounter",   "shutterAngle",
                                    "captureRate", "latitude",       "framesPerSecond"};
  constexpr const char* kStrings[] = {"owner", "capDate", "wrapmodes", "lensModel"};
  std::string text;
  for (const char* key : kTyped) text += "# " + std::string(key) + ": 2.5\n";
  for (const char* key : kStrings) text += "# " + std::string(key) + ": somebody\n";
  const SampleTable table = read(text + kAngles + "fr\n1,2,3,4,5\n");
  expect_same(again(table, ".exr"), table);
  const std::string bytes = read_content(folder_.path() / "file.exr").bytes;
  const auto holds = [&](const std::string& name) {
    const std::size_t at = bytes.find(name + '\0' + "string" + '\0');  // follows the value of another one
    return at != bytes.npos && bytes[at - 1] != '.';
  };
  for (const std::string key : kTyped) {
    EXPECT_FALSE(holds(key)) << key;
    EXPECT_TRUE(holds("comment." + key)) << key;
  }
  for (const std::string key : kStrings) EXPECT_TRUE(holds(key)) << key;
}

TEST_F(RoundTrips, OpenExrRoundsOnceToFloat) {
  const SampleTable table =
      read(kAngles + "fr,sigma_fr\n89.99999999,180,12.345678901,5,0.12345678901234567,1e-60\n");
  const SampleTable back = again(table, ".exr");
  EXPECT_EQ(back.theta_i[0], 90);
  EXPECT_NE(back.values[0][0], table.values[0][0]);
  EXPECT_NEAR(back.values[0][0], table.values[0][0], 1.2e-7 * table.values[0][0]);
  EXPECT_GT(back.sigma[0][0], 0);
  expect_same(again(back, ".exr"), back);
}

TEST_F(RoundTrips, OpenExrLeavesOutWhatIsNotFinite) {
  const SampleTable back = again(read(kAngles + "fr\n1,2,3,4,5\n1,2,3,4,1e300\n1,2,3,5,6\n"), ".exr");
  EXPECT_THAT(back.values[0], ElementsAre(5, 6));
  EXPECT_EQ(back.skipped, 1u);
  EXPECT_THAT(back.warnings,
              ElementsAre("1 of 3 pixels left out, because they have a value that is not finite"));
}

TEST_F(RoundTrips, OpenExrThatIsNoTableIsRefused) {
  SampleTable table = read(kAngles + "fr\n1,2,3,4,5\n");
  again(table, ".exr");
  std::string bytes = read_content(folder_.path() / "file.exr").bytes;
  EXPECT_THAT(message(bytes.substr(0, bytes.size() / 2)),
              HasSubstr("is not a readable OpenEXR picture: the header is damaged or truncated"));
  std::string long_one = bytes;
  const std::size_t size = long_one.find(std::string("columns") + '\0' + "string" + '\0') + 15;
  long_one.replace(size, 4, "\xff\xff\xff\x7f");
  EXPECT_THAT(message(long_one), HasSubstr("the header is damaged or truncated"));
  for (std::size_t at = bytes.find("phi_o"); at != bytes.npos; at = bytes.find("phi_o", at + 1))
    bytes[at] = 'q';
  EXPECT_THAT(message(bytes),
              HasSubstr("is an OpenEXR picture (channels fr, phi_i, qhi_o, theta_i, theta_o), not "
                        "a table of samples, which has channels theta_i, phi_i, theta_o, phi_o"));
}

TEST_F(RoundTrips, OfMeasuredFilesAreTheSameTable) {
  const auto folder = measured_data();
  if (!folder) GTEST_SKIP() << "BRDF_DATA_DIR is unset";
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    const SampleTable table = read_samples(entry.path());
    for (const char* suffix : {".csv", ".astm"}) {
      SampleTable back = again(table, suffix);
      if (!lost_.empty()) back.metadata = table.metadata;  // free text is lost, and the loss is reported
      expect_same(back, table);
    }
    const SampleTable as_float = again(table, ".exr");
    ASSERT_EQ(as_float.rows(), table.rows());
    EXPECT_EQ(as_float.metadata, table.metadata);
    for (std::size_t c = 0; c < table.channels.size(); ++c)
      for (std::size_t k = 0; k < table.rows(); ++k)
        ASSERT_NEAR(as_float.values[c][k], table.values[c][k], 1.2e-7 * std::abs(table.values[c][k]));
    if (table.format != "zemax") continue;
    const SampleTable back = again(table, ".zemax");
    expect_same(back, table);
    EXPECT_THAT(lost_, IsEmpty());
  }
}

}  // namespace
}  // namespace brdf::io
