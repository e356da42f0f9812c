// Tests that universal BRDF files of the BiRD project are written so that they read back to the same table.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/columns/foreign_json.h"
#include "io/files/content.h"
#include "io/files/json.h"
#include "io/files/temporary.h"
#include "io/formats/any_table.h"
#include "io/samples/aperture.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class WrittenBird : public testing::Test {
 protected:
  std::vector<std::string> write(const SampleTable& table) { return write_table(path_, table); }
  Json json() const { return read_json(path_); }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "own.brdf";
};

const std::string kAngles = "theta_i,phi_i,theta_o,phi_o,";

TEST_F(WrittenBird, KeepsBandsPolarisationsAndDeviations) {
  const SampleTable table =
      read("# sample: own\n# detector_aperture: 4 degrees\n# humidity: 40 %\n" + kAngles +
           "s_550nm,p_550nm,sigma_s_550nm,sigma_p_550nm\n30,180,60.1,0,.4,.2,.01,.02\n0,0,10,359.5,.3,.1,.03,"
           ".04\n");
  EXPECT_THAT(write(table), IsEmpty());
  const SampleTable back = read_samples(path_);
  EXPECT_EQ(back.format, "bird");
  EXPECT_EQ(back.channels, table.channels);
  EXPECT_EQ(back.theta_i, table.theta_i);
  EXPECT_EQ(back.phi_i, table.phi_i);
  EXPECT_EQ(back.theta_o, table.theta_o);
  EXPECT_EQ(back.phi_o, table.phi_o);
  EXPECT_EQ(back.values, table.values);
  EXPECT_EQ(back.sigma, table.sigma);
  EXPECT_EQ(back.find_metadata("sample"), "own");
  EXPECT_EQ(back.find_metadata("humidity"), "40 %");
  EXPECT_NEAR(stated_aperture(back).value(), 4, 1e-3);
  const Json file = json();
  EXPECT_EQ(file["metadata"]["method"], "measurement");
  EXPECT_EQ(file["metadata"]["instrumentation"]["detection_system"]["solid_angle"]["unit"], "sr");
  EXPECT_FALSE(file["data"].contains("polarization_r"));
  const std::string first = read_content(path_).bytes;
  write(table);
  EXPECT_EQ(read_content(path_).bytes, first);
}

TEST_F(WrittenBird, KeepsBothPolarisationsAndASingleChannel) {
  const SampleTable pairs = read(kAngles + "ss_1550nm,sp_1550nm,ps_1550nm,pp_1550nm\n30,180,60,0,1,2,3,4\n");
  write(pairs);
  EXPECT_EQ(read_samples(path_).channels, pairs.channels);
  EXPECT_EQ(read_samples(path_).values, pairs.values);
  const SampleTable one = read(kAngles + "brightness\n30,180,60,0,1\n");
  write(one);
  EXPECT_EQ(read_samples(path_).values, one.values);
  EXPECT_FALSE(json()["data"].contains("wavelength_i"));
}

TEST_F(WrittenBird, AzimuthsAreWithinATurn) {
  write(read(kAngles + "fr\n30,-90,60,365,1\n"));
  EXPECT_EQ(json()["data"]["phi_i"]["values"][0], 270);
  EXPECT_EQ(json()["data"]["phi_r"]["values"][0], 5);
}

TEST_F(WrittenBird, ComputedTablesHaveNoInstrument) {
  write(read("# instrument: virtual\n# truth: {\"format\": \"brdf-material\"}\n" + kAngles +
             "fr\n30,180,60,0,1\n"));
  EXPECT_FALSE(may_be_material(read_content(path_))) << "the truth is a text";
  EXPECT_EQ(json()["metadata"]["adhoc_section"]["instrument"], "virtual");
  EXPECT_EQ(json()["metadata"]["method"], "simulation");
  EXPECT_EQ(json()["metadata"]["instrumentation"], "NA");
}

TEST_F(WrittenBird, ReportsLossesAndRefusesOtherChannels) {
  EXPECT_THAT(write(read(kAngles +
                         "500nm,600nm,sigma_500nm\n30,0,60,5,-1,1,.1\n30,0,50,5,1,1,.1\n30,0,90,5,1,1,.1\n")),
              ElementsAre("standard deviations, which not all channels have", "1 negative value",
                          "1 row at 90 degrees"));
  const auto refusal = [&](const std::string& text) { return message_of([&] { write(read(text)); }); };
  EXPECT_THAT(refusal(kAngles + "r,g,b\n30,0,60,5,1,1,1\n"), HasSubstr("channel 'r' has no wavelength"));
  EXPECT_THAT(refusal(kAngles + "500nm,a\n30,0,60,5,1,1\n"), HasSubstr("channel 'a' has no wavelength"));
  EXPECT_THAT(refusal(kAngles + "500nm,a 500nm\n30,0,60,5,1,1\n"),
              HasSubstr("has the wavelength and the polarisation of another channel"));
  EXPECT_THAT(refusal(kAngles + "fr\n30,0,90,5,1\n"), HasSubstr("has no value that a file of BiRD can hold"));
}

}  // namespace
}  // namespace brdf::io
