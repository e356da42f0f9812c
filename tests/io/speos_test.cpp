// Tests Speos' text formats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

// A diffuse block: the value `inside` up to 90 degrees, every 10 degrees. `mirror`: the value at 30 degrees
// and azimuth 0.
std::string block(const std::string& inside, const std::string& mirror) {
  std::string text = "10 5\n\t0 90 180 270 360\n";
  for (int theta = 0; theta <= 90; theta += 10) {
    const std::string first = theta == 30 ? mirror : inside;
    text += std::to_string(theta) + "\t" + first + " " + inside + " " + inside + " " + inside + " " + first +
            "\n";
  }
  return text;
}

std::string complete(const std::string& blocks, const std::string& flags = "1 0\n1\n") {
  return "OPTIS - brdf surface file v9.0\n0\nown numbers\n7\ntwo\nLin\n" + flags + "1 2\n30\n500 600\n" +
         blocks;
}

const std::string kTwo = "50\n" + block("2", "2") + "25\n" + block("3", "3");

TEST(Speos, PercentagesSetTheLevel) {
  const SampleTable t = read(complete(kTwo));
  EXPECT_EQ(t.format, "speos");
  EXPECT_THAT(t.channels, ElementsAre("500nm", "600nm"));
  EXPECT_EQ(t.rows(), 33u) << "the normal once, azimuth 360 not again, no row at 90 degrees";
  for (const double f : t.values[0]) EXPECT_NEAR(f, .5 / std::numbers::pi, 1e-12);
  for (const double f : t.values[1]) EXPECT_NEAR(f, .25 / std::numbers::pi, 1e-12);
  EXPECT_THAT(t.assumptions, Contains(HasSubstr("the percentages of reflected light set the scale")));
  EXPECT_THAT(t.assumptions, Contains(HasSubstr("differ by more than 10 %")));
}

TEST(Speos, IntensitiesAreDividedByTheCosine) {
  std::string text =
      "OPTIS - brdf surface file v8.0\r\n0\r\n\r\n0\r\n\r\n1 0\r\n0\r\n1 1\r\n0\r\n550\r\n40\r\n181 "
      "1\r\n\t0\r\n";
  for (int k = 0; k <= 180; ++k)
    text += to_text(k / 2.0) + " " + to_text(std::cos(k * std::numbers::pi / 360)) + "\r\n";
  const SampleTable t = read(text);
  ASSERT_EQ(t.rows(), 180u);
  for (const double f : t.values[0]) EXPECT_NEAR(f, .4 / std::numbers::pi, 1e-5);
}

TEST(Speos, AzimuthZeroIsTheMirrorSideAndZerosAreFill) {
  const SampleTable t = read(complete("50\n" + block("2", "9") + "25\n" + block("3", "0")));
  EXPECT_EQ(t.rows(), 32u);
  EXPECT_TRUE(std::isnan(value_at(t, 30, 180, 30, 0)));
  EXPECT_THAT(t.warnings, Contains(HasSubstr("1 row left out: exactly 0, which stands for directions")));
  const SampleTable peak = read(complete("50\n" + block("2", "8") + "25\n" + block("3", "9")));
  EXPECT_NEAR(value_at(peak, 30, 180, 30, 0), 4 * value_at(peak, 30, 180, 30, 180), 1e-12);
  EXPECT_THAT(peak.assumptions, Not(Contains(HasSubstr("on the side of the incident light"))));
}

TEST(Speos, TheLengthOfTheDescriptionMayBeWrong) {
  for (const char* length : {"5", "8", "70"}) {
    const SampleTable t =
        read(replaced(complete(kTwo), "own numbers\n7", std::string("own numbers\n") + length));
    EXPECT_EQ(t.rows(), 33u) << length;
    EXPECT_THAT(t.warnings, Contains(HasSubstr("the description does not have the")));
  }
}

TEST(Speos, BlocksOfTransmissionAreLeftOut) {
  const std::string through = "10\n2 2\n0 180\n90 1 1\n180 1 1\n";
  const SampleTable t = read(complete(kTwo + through + through, "1 1\n1\n"));
  EXPECT_EQ(t.rows(), 33u);
  EXPECT_THAT(t.warnings, Contains("2 blocks of transmission left out"));
}

TEST(Speos, ABlockOfPercentage0IsLeftOut) {
  const std::string lights = replaced(complete("", "1 0\n1\n"), "1 2\n30\n500 600\n", "2 1\n10 30\n550\n");
  const SampleTable t = read(lights + "0\n" + block("2", "2") + "50\n" + block("2", "2"));
  EXPECT_EQ(t.theta_i[0], 30);
  EXPECT_THAT(t.warnings, Contains(HasSubstr("1 block without a level left out")));
}

std::string anisotropic(const std::string& spectrum) {
  return "OPTIS - Anisotropic BSDF surface file v8.0\n0\n\n3\nabc\n0 1 0\n1 0\n1\n2\n0 90\n1\n30\n2\n30 "
         "50\n" +
         spectrum + block("2", "2") + block("2", "2") + block("4", "4");
}

TEST(Speos, OneFactorScalesAllBlocksOfAnAnisotropicFile) {
  const SampleTable t = read(anisotropic("30 0\n\n2\n400 50\n700 50\n"));
  EXPECT_THAT(t.channels, ElementsAre("fr"));
  EXPECT_EQ(t.rows(), 99u);
  EXPECT_NEAR(value_at(t, 30, 180, 10, 0), .5 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(value_at(t, 50, 90, 10, -90), 1 / std::numbers::pi, 1e-12) << "the turn lowers both azimuths";
  // The incidence of the spectrum is midway between 30 and 50 degrees of the second turn.
  const SampleTable between = read(anisotropic("40 90\ncomment\n2\n400 50\n700 25\n"));
  EXPECT_THAT(between.channels, ElementsAre("400nm", "700nm"));
  EXPECT_NEAR(value_at(between, 30, 180, 10, 0), .5 / std::numbers::pi * 2 / 3, 1e-12);
  EXPECT_NEAR(value_at(between, 30, 180, 10, 0, 1), .25 / std::numbers::pi * 2 / 3, 1e-12);
  EXPECT_EQ(read(anisotropic("30 0\n2\n400 50\n700 50\n")).values, t.values) << "without the comment's line";
}

TEST(Speos, RefusesDamagedFiles) {
  const std::pair<std::string, const char*> cases[] = {
      {complete(kTwo, "0 1\n1\n"), "holds transmission only, which is not read"},
      {complete(kTwo + "1\n"), "'1' follows the last block"},
      {complete("50\n" + block("2", "x")), "'x' is not a finite number (a value expected)"},
      {complete("50\n" + block("2", "2")), "the text ends early, a percentage expected"},
      {complete("50\n" + replaced(block("2", "2"), "0 90 180", "0 180 90")), "azimuth 90: must ascend"},
      {complete("50\n99999999 5\n0 90"), "99999999 is not a whole number from 1 to 100000"},
      {complete("50\n10 99999\n0 90"), "the text ends early, an azimuth expected"},
      {replaced(complete(kTwo), "\n1 0\n1\n", "\n1 7\n1\n"), "do not follow the description of 7 characters"},
      {complete("0\n" + block("2", "2") + "0\n" + block("2", "2")),
       "no block has a percentage and values above 0"},
      {replaced(complete(kTwo), "\n30\n", "\n130\n"), "angle of incidence 130 must be between -90 and 90"},
      {anisotropic("30 0\n\n1\n400 0\n"), "the level of the values is not defined"}};
  for (const auto& [text, expected] : cases)
    EXPECT_THAT(message(text), HasSubstr(expected)) << text.substr(0, 200);
}

TEST(Speos, AgreesWithTheExamples) {
  BRDF_SKIP_WITHOUT(expect_example("speos_tiny.brdf", "speos_tiny.expect.csv", {.value = .01}));
  EXPECT_TRUE(
      expect_example("speos_tiny.anisotropicbsdf", "speos_tiny_anisotropic.expect.csv", {.value = .01}));
  const auto refusal = [](const char* name) {
    return message_of([&] { read_samples(*example("../faults/formats", name)); });
  };
  EXPECT_THAT(refusal("speos_tiny_transmission.brdf"), HasSubstr("holds transmission only"));
  EXPECT_THAT(refusal("speos_binary.brdf"), HasSubstr("is a binary BRDF file of Speos"));
}

TEST(Speos, ReadsAConvertedMeasurement) {
  const auto file = example("formats", "radiant_imaging_sphere.anisotropicbsdf");
  BRDF_SKIP_WITHOUT(file);
  const SampleTable t = read_samples(*file);
  EXPECT_EQ(t.rows(), 7969u - 2026u);
  EXPECT_NEAR(mean_of(t), .0713413, 1e-2 * .0713413);
  EXPECT_NEAR(value_at(t, 15, 180, 15, 0), .065825, 1e-2 * .065825);
  EXPECT_NEAR(value_at(t, 45, 180, 45, 0), .145936, 1e-2 * .145936);
  EXPECT_NEAR(value_at(t, 75, 180, 75, 0), 6.34205, 1e-2 * 6.34205);
}

TEST(Speos, ReadsASimulatedGrating) {
  const auto file = example("formats", "speos_grating_550nm.brdf");
  BRDF_SKIP_WITHOUT(file);
  const SampleTable t = read_samples(*file);
  EXPECT_EQ(t.rows(), 128164u);
  EXPECT_NEAR(mean_of(t), .0233523, 1e-2 * .0233523);
  EXPECT_NEAR(value_at(t, 0, 180, 0, 0), .0598016, 1e-2 * .0598016);
  EXPECT_NEAR(value_at(t, 45, 180, 47, 1), 1.62340, 1e-2 * 1.6234);
}

}  // namespace
}  // namespace brdf::io
