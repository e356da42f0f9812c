// Tests look-up tables of ASAM OpenMATERIAL 3D.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/temporary.h"
#include "io/formats/any_table.h"
#include "io/samples/aperture.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::string openmaterial(const std::string& rows, const std::string& more = "") {
  return R"({"metadata": {"name": "own", "authors": ["a", "b"], "openMaterial3dVersion": "1.0.0"}, "brdf": {)" +
         more + R"("wavelengths": [9.05e-7], "lookupTable": [)" + rows + "]}}";
}

TEST(OpenMaterial, ReadsMetresAndRadians) {
  const SampleTable t = read(openmaterial(
      "[9.05e-7, 0.523599, 0.785398, 3.141593, 0.5], [1.55e-6, 0.523599, 0.785398, 3.141593, 0.25]"));
  EXPECT_EQ(t.format, "openmaterial");
  EXPECT_THAT(t.channels, ElementsAre("905nm", "1550nm"));
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.theta_i[0], 30);
  EXPECT_EQ(t.theta_o[0], 45);
  EXPECT_EQ(t.phi_o[0] - t.phi_i[0], 180);
  EXPECT_EQ(t.values[1][0], .25);
  EXPECT_EQ(*t.find_metadata("authors"), "a; b");
}

TEST(OpenMaterial, LeavesOutNullsAndGrazingRows) {
  const SampleTable t = read(openmaterial(
      "[9.05e-7, 0.1, 0.2, 0, 0.5], [9.05e-7, 0.1, 0.2, null, null], [9.05e-7, 1.570796, 0.2, 0, 1]"));
  EXPECT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.skipped, 2u);
  EXPECT_THAT(t.warnings, Contains("1 row left out: a member is null"));
  EXPECT_THAT(t.warnings, Contains("1 row left out: a polar angle is 90 degrees"));
}

TEST(OpenMaterial, LeavesOutDirectionsThatLackAWavelength) {
  const SampleTable t = read(
      openmaterial("[9.05e-7, 0.1, 0.2, 0, 0.5], [9.05e-7, 0.1, 0.3, 0, 0.6], [1.55e-6, 0.1, 0.3, 0, 0.7], "
                   "[1.55e-6, 0.1, 0.2, 0, null]"));
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.values[0][0], .6);
  EXPECT_THAT(t.assumptions,
              Contains(HasSubstr("1 pair of directions left out: not measured in every band")));
}

TEST(OpenMaterial, EarlyTablesHaveNegativeAngles) {
  const SampleTable t = read(openmaterial("[9.05e-7, 0.523599, -0.523599, 0, 0.5]"));
  EXPECT_EQ(t.theta_o[0], 30);
  EXPECT_EQ(t.phi_o[0], 180);
}

TEST(OpenMaterial, SolidAngleBecomesTheAperture) {
  const std::string row = "[9.05e-7, 0.1, 0.2, 0, 0.5]";
  const auto with = [&](const std::string& list) {
    return read(openmaterial(row, "\"receiverSolidAngles\": [" + list + "], "));
  };
  const SampleTable t = with(R"({"wavelength": 9.05e-7, "solidAngle": 0.0038275})");
  ASSERT_TRUE(stated_aperture(t));
  EXPECT_NEAR(*stated_aperture(t), 4, .001);
  EXPECT_FALSE(stated_aperture(with(
      R"({"wavelength": 9.05e-7, "solidAngle": 0.0038275}, {"wavelength": 1.55e-6, "solidAngle": 0.001})")));
  EXPECT_FALSE(stated_aperture(with(R"({"wavelength": 9.05e-7, "solidAngle": 7})")));
}

TEST(OpenMaterial, IsRecognisedByKeysInAnyOrderBehindAByteOrderMark) {
  const SampleTable t =
      read("\xEF\xBB\xBF\r\n{\"brdf\": {\"extra\": {}, \"lookupTable\": [[9.05e-7, 0.1, 0.2, 0, 0.5]]}}");
  EXPECT_EQ(t.rows(), 1u);
}

TEST(OpenMaterial, MayBeOneLongLine) {
  const std::string long_text(kLongestLine + 100, 'x');
  const SampleTable t = read(R"({"metadata": {"description": ")" + long_text +
                             R"("}, "brdf": {"lookupTable": [[9.05e-7, 0.1, 0.2, 0, 0.5]]}})");
  EXPECT_EQ(t.rows(), 1u);
  EXPECT_LT(t.find_metadata("description")->size(), 3000u);
}

TEST(OpenMaterial, RefusesOtherTables) {
  const std::pair<std::string, const char*> cases[] = {
      {openmaterial("[905, 0.1, 0.2, 0, 0.5]"), "$.brdf.lookupTable[0][0]: 905 is not a wavelength in m"},
      {openmaterial("[9.05e-7, 30, 30, 180, 0.5]"), "(theta_i) is not an angle in radians"},
      {openmaterial("[9.05e-7, 0.1, 0.2, 180, 0.5]"), "(phi_o) is not an angle in radians"},
      {openmaterial("[9.05e-7, 0.1, 0.2, 0.5]"),
       "$.brdf.lookupTable[0]: [9.05e-07,0.1,0.2,0.5] must be a row of 5"},
      {openmaterial("[9.05e-7, 0.1, 0.2, 0, \"x\"]"),
       "$.brdf.lookupTable[0][4]: \"x\" (value) must be a number"},
      {openmaterial(""), "holds no rows of reflected light"},
      {openmaterial("[9.05e-7, 1.570796, 0.2, 0, 1]"), "holds no rows of reflected light (1 row left out"},
      {R"({"brdf": {"lookupTable": 3}})", "$.brdf.lookupTable: 3 must be an array"},
      {openmaterial("[9.05e-7, 0.1, 0.2, 0, 0.5], [1.55e-6, 0.1, 0.3, 0, 0.7]"),
       "no pair of directions has a value in every band"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

class WrittenOpenMaterial : public testing::Test {
 protected:
  std::vector<std::string> write(const SampleTable& table) {
    path_ = folder_.path() / "own_brdf.xompt";
    return write_table(path_, table);
  }
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

TEST_F(WrittenOpenMaterial, ReadsBackWithinTheDigitsOfAngles) {
  const SampleTable table = read(
      "# sample: own\n# detector_aperture: 4 degrees\ntheta_i,phi_i,theta_o,phi_o,1550nm,905nm\n"
      "30,10,45.5,190,.5,.25\n30,10,0,0,.3,.2\n");
  EXPECT_THAT(write(table), ElementsAre("azimuths other than the difference of both directions",
                                        "comments other than sample, license, author and source"));
  const SampleTable back = read_samples(path_);
  EXPECT_THAT(back.channels, ElementsAre("905nm", "1550nm"));
  ASSERT_EQ(back.rows(), 2u);
  EXPECT_NEAR(value_at(back, 30, 0, 45.5, 180, 1), .5, 0);
  EXPECT_NEAR(value_at(back, 30, 0, 0, 0), .2, 0);
  EXPECT_NEAR(stated_aperture(back).value(), 4, 1e-3);
  EXPECT_EQ(*back.find_metadata("name"), "own");
  const std::string first = read_content(path_).bytes;
  write(table);
  EXPECT_EQ(read_content(path_).bytes, first);
}

TEST_F(WrittenOpenMaterial, NeedsWavelengthsAndValuesOfAtLeast0) {
  EXPECT_THAT(message_of([&] { write(read(std::string(kHeader) + kRow)); }),
              HasSubstr("channel 'f' has no wave"));
  EXPECT_THAT(
      message_of([&] { write(read("theta_i,phi_i,theta_o,phi_o,s_550nm,p_550nm\n30,180,60,5,1,1\n")); }),
      HasSubstr("two channels have the wavelength 550 nm"));
  const std::string header = "theta_i,phi_i,theta_o,phi_o,550nm\n";
  EXPECT_THAT(message_of([&] { write(read(header + "30,180,60,5,-1\n")); }), HasSubstr("has no value that"));
  EXPECT_THAT(write(read(header + "30,0,60,5,-1\n30,0,50,5,1\n30,0,90,5,1\n")),
              ElementsAre("1 negative value", "1 row at 90 degrees"));
}

TEST(OpenMaterial, AgreesWithTheExample) {
  BRDF_SKIP_WITHOUT(
      expect_example("openmaterial_tiny.xompt", "openmaterial_tiny.expect.csv", {.angle = 1e-4}));
}

TEST(OpenMaterial, ReadsAPublishedFile) {
  const auto file = example("formats", "openmaterial_asphalt_lidar.xompt");
  BRDF_SKIP_WITHOUT(file);
  const SampleTable t = read_samples(*file);
  EXPECT_EQ(t.rows(), 724u);
  EXPECT_EQ(t.skipped, 181u);
  EXPECT_NEAR(mean_of(t), .00082868975, 1e-11);
}

}  // namespace
}  // namespace brdf::io
