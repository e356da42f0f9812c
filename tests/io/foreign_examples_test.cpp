// Compares all small examples of other programs' files with their expected tables. A new example without an
// entry here is compared with NAME.expect.csv.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

// Examples that are refused, with a part of the message.
const std::map<std::string, std::string> kRefusedExamples{
    {"bird_legacy_shifted.json", "the values cannot be assigned to directions"},
    {"quantity_btdf_1_sr.csv", "transmitted light"},
    {"quantity_btdf_sphere.csv", "transmitted light is not read"},
    {"quantity_r_db.csv", "in decibels of a ratio"},
    {"quantity_scatter_ppm_sr.csv", "give --quantity"},
    {"speos_binary.brdf", "is a binary BRDF file of Speos"},
    {"speos_tiny_transmission.brdf", "holds transmission only"}};

// Examples whose table has another name.
const std::map<std::string, std::string> kExpectedOfExamples{
    {"aspecular_wide.csv", "aspecular"},
    {"fred_in_plane.txt", "two_angle"},
    {"matrix_columns.csv", "two_angle"},
    {"matrix_rows.csv", "two_angle"},
    {"metadata_text.csv", "quantity"},
    {"mueller_tiny_paper.csv", "mueller_tiny"},
    {"speos_tiny.anisotropicbsdf", "speos_tiny_anisotropic"},
    {"two_angle_negative_light.csv", "two_angle"},
    {"two_angle_one_frame.csv", "two_angle"}};

// Examples whose expected table needs a statement of the user, which other tests make: the unit of the
// angles and the quantity.
const std::set<std::string> kElsewhere{"radians_signed.csv", "two_angle_measure.csv"};

std::string expected_name(const std::filesystem::path& file) {
  const std::string name = file.filename();
  if (const auto known = kExpectedOfExamples.find(name); known != kExpectedOfExamples.end())
    return known->second;
  for (const char* family : {"quantity", "wavelength"})
    if (name.starts_with(family)) return family;
  return file.stem();
}

Tolerance tolerance_of(const std::string& name) {
  if (name.starts_with("speos")) return {.value = .01};
  // The digits of these files do not give more.
  if (name.starts_with("brf_titled") || name.starts_with("r_table")) return {.value = 1e-5};
  return {.angle = 2e-4};
}

// The expected table of Mueller matrices has more channels, of polarised light. The azimuth that follows
// from a phase angle has no sign.
SampleTable comparable(SampleTable expected, const std::string& name) {
  if (name.starts_with("mueller")) {
    expected.channels.resize(2);
    expected.values.resize(2);
  }
  return expected;
}

TEST(ForeignExamples, AgreeWithTheirExpectedTables) {
  const auto folder = example("../faults/formats");
  BRDF_SKIP_WITHOUT(folder);
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    const std::string name = entry.path().filename();
    if (name.find(".expect.") != name.npos || kElsewhere.contains(name)) continue;
    SCOPED_TRACE(name);
    const auto refused = kRefusedExamples.find(name);
    const std::string answer = message_of([&] { read_samples(entry.path()); });
    EXPECT_THAT(answer, testing::HasSubstr(refused == kRefusedExamples.end() ? "accepted" : refused->second));
    if (answer != "accepted") continue;
    const std::filesystem::path expected = *folder / (expected_name(entry.path()) + ".expect.csv");
    expect_rows(read_samples(entry.path()), comparable(read_samples(expected), name), tolerance_of(name));
    ++compared;
  }
  EXPECT_GE(compared, 40u);
}

}  // namespace
}  // namespace brdf::io
