// Tests BRDF files of the BiRD project, of version 1.0 and before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/samples/aperture.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

// Two entries: light at 30, viewer at 60 degrees on the mirror side, at 550 nm in s and p.
Json universal() {
  return Json::parse(R"({"metadata": {"type": "BRDF", "description": "own"}, "data": {
      "theta_i": {"unit": "deg", "values": [30, 30]}, "phi_i": {"unit": "rad", "values": [3.141593, 3.141593]},
      "theta_r": {"unit": "°", "values": [60, 60]}, "phi_r": {"unit": "°", "values": [0, 0]},
      "wavelength_i": {"unit": "μm", "values": [0.55, 0.55]},
      "polarization_i": {"notation": "sp", "values": ["s", "p"]},
      "BRDF": {"unit": "sr^-1", "values": [0.4, 0.2]}}})");
}

TEST(Bird, ReadsUnitsAndPolarisations) {
  const SampleTable t = read(universal().dump());
  EXPECT_EQ(t.format, "bird");
  EXPECT_THAT(t.channels, ElementsAre("s_550nm", "p_550nm"));
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.phi_i[0], 180);
  EXPECT_EQ(t.values[0][0], .4);
  EXPECT_EQ(t.values[1][0], .2);
  EXPECT_FALSE(t.has_sigma(0));
}

TEST(Bird, ReadsStokesVectorsOfBothSides) {
  Json json = universal();
  json["data"]["polarization_i"]["values"] = {{1, 1, 0, 0}, {1, -1, 0, 0}};
  json["data"]["polarization_r"] = {{"notation", "sp"}, {"values", {"p", "s"}}};
  EXPECT_THAT(read(json.dump()).channels, ElementsAre("sp_550nm", "ps_550nm"));
  json["data"]["polarization_i"]["values"] = {{1, 0, 1, 0}, {1, -1, 0, 0}};
  EXPECT_THAT(message(json.dump()),
              HasSubstr("$.data.polarization_i.values[0]: [1,0,1,0] is not read as a pol"));
}

TEST(Bird, UncertaintiesBecomeStandardDeviations) {
  Json json = universal();
  json["data"]["BRDF"]["uncertainty"] = {{"value", 0.01}, {"unit", "1/sr"}};
  EXPECT_EQ(read(json.dump()).sigma[1][0], .01);
  json["data"]["uBRDF"] = {{"unit", "%"}, {"values", {5, 10}}};
  const SampleTable t = read(json.dump());
  EXPECT_NEAR(t.sigma[0][0], .02, 1e-15);
  EXPECT_NEAR(t.sigma[1][0], .02, 1e-15);
  EXPECT_THAT(t.assumptions, Contains(HasSubstr("coverage factor 1")));
  json["data"]["uBRDF"]["values"] = {5, 0};
  EXPECT_FALSE(read(json.dump()).has_sigma(0));
}

TEST(Bird, AdhocVariablesAreNoChannels) {
  Json json = universal();
  json["data"]["adhoc_variables"] = {{"width", {{"unit", "mm"}, {"values", {1, 2}}}}};
  EXPECT_EQ(read(json.dump()).channels.size(), 2u);
}

TEST(Bird, SolidAngleBecomesTheAperture) {
  Json json = universal();
  json["metadata"]["instrumentation"]["detection_system"]["solid_angle"] = {{"value", 0.002194},
                                                                            {"unit", "sr"}};
  EXPECT_NEAR(stated_aperture(read(json.dump())).value(), 3.03, .005);
}

TEST(Bird, RefusesWhatItDoesNotUnderstand) {
  const auto with = [](auto change) {
    Json json = universal();
    change(json);
    return json.dump();
  };
  const std::pair<std::string, const char*> cases[] = {
      {with([](Json& j) { j["data"]["phi_r"]["values"] = {0}; }),
       "$.data.phi_r.values has 1 member, but $.data.theta_i.values has 2"},
      {with([](Json& j) { j["data"]["theta_i"]["unit"] = "nm"; }),
       "$.data.theta_i.unit: \"nm\" must be rad, deg"},
      {with([](Json& j) { j["data"]["BRDF"]["unit"] = "%"; }), "$.data.BRDF.unit: \"%\" must be 1/sr"},
      {with([](Json& j) { j["data"]["BRDF"]["values"][1] = "x"; }),
       "$.data.BRDF.values[1]: \"x\" must be a number"},
      {with([](Json& j) { j["metadata"]["type"] = "BTDF"; }), "$.metadata.type: 'BTDF' is not read"},
      {with([](Json& j) { j["data"].erase("phi_i"); }), "$.data: key \"phi_i\" is missing"},
      {with([](Json& j) {
         j["data"]["wavelength_r"] = {{"unit", "nm"}, {"values", {600, 550}}};
       }),
       "fluorescence is not a reflectance"},
      {with([](Json& j) {
         j["data"].erase("polarization_i");
         j["data"]["polarization_r"] = {{"notation", "sp"}, {"values", {"s", "p"}}};
       }),
       "with unpolarised incident light is not read"},
      {with([](Json& j) {
         j["data"]["theta_r"]["values"] = {120, 120};
       }),
       "holds no rows of reflected light"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

const std::string kEarly =
    R"({"head": {"quantity": "brdf", "unit": "sr-1"}, "data": {"wavelengths": [550], "pol": "sp",
        "theta_i": [30, 30], "phi_i": [0, 0], "theta_v": [-40, -40], "phi_v": [0, 0], "data": [[0.4, 0.2]]}})";

TEST(EarlyBird, ReadsLettersAndNegativeAngles) {
  const SampleTable t = read(kEarly);
  EXPECT_EQ(t.format, "early_bird");
  EXPECT_THAT(t.channels, ElementsAre("s_550nm", "p_550nm"));
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.theta_o[0], 40);
  EXPECT_EQ(t.phi_o[0], 180);
  EXPECT_EQ(t.values[1][0], .2);
}

TEST(EarlyBird, ConvertsOtherQuantitiesAndAnnouncesAnAbsentOne) {
  const SampleTable brf = read(replaced(replaced(kEarly, "brdf", "BRF"), "sr-1", "%"));
  EXPECT_NEAR(brf.values[0][0], .004 / 3.14159265358979, 1e-15);
  EXPECT_THAT(brf.assumptions, Contains(HasSubstr("a reflectance factor")));
  const SampleTable silent = read(replaced(kEarly, R"("quantity": "brdf", "unit": "sr-1")", ""));
  EXPECT_THAT(silent.assumptions, Contains(HasSubstr("the file states no quantity")));
}

TEST(EarlyBird, AWavelengthOf0MeansNone) {
  const SampleTable t =
      read(replaced(replaced(kEarly, "[550]", "[0]"), "\"sp\"", "[\"no data\", \"no data\"]"));
  EXPECT_THAT(t.channels, ElementsAre("fr"));
  EXPECT_EQ(t.rows(), 2u) << "two measurements of one direction";
}

TEST(EarlyBird, AnAngleThatIsNoNumberStaysText) {
  const std::string head = R"("collection_sa": "3.8275E-3", "quantity": "brdf")";
  const SampleTable t = read(replaced(kEarly, R"("quantity": "brdf")", head));
  EXPECT_NEAR(stated_aperture(t).value(), 4, .001);
  const SampleTable u = read(replaced(kEarly, R"("quantity": "brdf")", replaced(head, "E-3", "E10-9")));
  EXPECT_FALSE(stated_aperture(u));
  EXPECT_THAT(u.warnings, Contains(HasSubstr("'3.8275E10-9' (head.collection_sa) is not a number")));
}

TEST(EarlyBird, RefusesListsOfDifferentLengths) {
  const std::pair<std::string, const char*> cases[] = {
      {replaced(kEarly, "[0.4, 0.2]", "[0, 0.4, 0.2]"),
       "$.data.data[0] has 3 members, but $.data.theta_i has 2"},
      {replaced(kEarly, "\"sp\"", "\"spp\""), "$.data.pol has 3 letters, but $.data.theta_i has 2 members"},
      {replaced(kEarly, "\"sp\"", "[\"s\", \"left\"]"),
       "$.data.pol[1]: \"left\" is not read as a polarisation"},
      {replaced(kEarly, "[550]", "[550, 650]"),
       "$.data.data has 1 row, but $.data.wavelengths has 2 members"},
      {replaced(kEarly, "brdf", "btdf"), "is of transmitted light"},
      {replaced(kEarly, "sr-1", "nm"), "$.head.unit: 'nm' contradicts the quantity 'brdf'"},
      {replaced(kEarly, "[-40, -40]", "[-40, 999]"), "$.data.theta_v[1]: 999 must be between -360 and 360"}};
  for (const auto& [text, expected] : cases) EXPECT_THAT(message(text), HasSubstr(expected)) << text;
}

TEST(Bird, AgreesWithTheExamples) {
  BRDF_SKIP_WITHOUT(expect_example("bird_tiny.json", "bird_tiny.expect.csv"));
  EXPECT_TRUE(expect_example("bird_legacy_tiny.json", "bird_legacy_tiny.expect.csv"));
  EXPECT_THAT(message_of([] { read_samples(*example("../faults/formats", "bird_legacy_shifted.json")); }),
              HasSubstr("has 4 members, but $.data.theta_i has 3"));
}

TEST(Bird, ReadsAPublishedFile) {
  const auto file = example("formats", "bird_spectralon.brdf");
  BRDF_SKIP_WITHOUT(file);
  const SampleTable t = read_samples(*file);
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.channels.size(), 8u);
  EXPECT_EQ(t.channels[0], "s_550nm");
  EXPECT_EQ(t.values[0][0], .254);
  EXPECT_EQ(t.values[1][0], .263);
  EXPECT_EQ(t.values[7][0], .301);
  EXPECT_EQ(*t.find_metadata("sample"), "SRT1");
}

}  // namespace
}  // namespace brdf::io
