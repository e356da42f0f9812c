// Tests the conversion of polarised channels, and of directions that were measured more than once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "io/samples/arrange.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SampleTable arranged(const std::string& text, const Arrangement& asked) {
  SampleTable table = read(text);
  arrange(table, asked);
  return table;
}

std::string refusal(const std::string& text, Polarisation asked) {
  return message_of([&] { arranged(text, {.polarisation = asked}); });
}

const std::string kAngleColumns = "theta_i,phi_i,theta_o,phi_o,";

TEST(Polarisation, IsToldByTheWordsOfAName) {
  const std::pair<const char*, std::pair<const char*, Polarisation>> cases[] = {
      {"fr_s", {"fr", Polarisation::s}},
      {"465nm p", {"465nm", Polarisation::p}},
      {"p_465nm", {"465nm", Polarisation::p}},
      {"TE 650nm", {"650nm", Polarisation::s}},
      {"BRDF (s-pol)", {"BRDF", Polarisation::s}},
      {"r_p_polarised", {"r", Polarisation::p}},
      {"sp", {"fr", Polarisation::sp}},
      {"fr parallel", {"fr", Polarisation::p}}};
  for (const auto& [name, expected] : cases) {
    const PolarisedName got = polarised_name(name);
    EXPECT_EQ(got.name, expected.first) << name;
    EXPECT_EQ(got.of, expected.second) << name;
  }
  for (const char* name : {"r", "samples", "fr", "s_p", "pol"})
    EXPECT_EQ(polarised_name(name).of, std::nullopt) << name;
}

TEST(Polarisation, AverageIsWhatUnpolarisedLightSees) {
  const SampleTable two = arranged(kAngleColumns + "fr_s,fr_p,sigma_fr_s,sigma_fr_p\n1,2,3,4,1,3,.3,.4\n",
                                   {.polarisation = Polarisation::average});
  EXPECT_THAT(two.channels, ElementsAre("fr"));
  EXPECT_EQ(two.values[0][0], 2);
  EXPECT_DOUBLE_EQ(two.sigma[0][0], .25);
  const SampleTable four =
      arranged(kAngleColumns + "465nm_ss,465nm_sp,465nm_ps,465nm_pp,r\n1,2,3,4,1,2,4,8,9\n",
               {.polarisation = Polarisation::average});
  EXPECT_THAT(four.channels, ElementsAre("465nm", "r"));
  EXPECT_EQ(four.values[0][0], 7.5);
  EXPECT_EQ(four.values[1][0], 9);
  EXPECT_FALSE(four.has_sigma(0));
  EXPECT_THAT(four.warnings.back(), HasSubstr("became 465nm, r"));
}

TEST(Polarisation, IsChosen) {
  const std::string text = kAngleColumns + "fr_ss,fr_sp,fr_ps,fr_pp\n1,2,3,4,1,2,4,8\n";
  const std::pair<Polarisation, double> cases[] = {{Polarisation::s, 3},  {Polarisation::p, 12},
                                                   {Polarisation::ss, 1}, {Polarisation::sp, 2},
                                                   {Polarisation::ps, 4}, {Polarisation::pp, 8}};
  for (const auto& [asked, value] : cases)
    EXPECT_EQ(arranged(text, {.polarisation = asked}).values[0][0], value);
  EXPECT_EQ(arranged(text, {}).channels.size(), 4u);
}

TEST(Polarisation, ThatIsNotThereIsRefusedWithWhatIs) {
  const std::string row = "\n1,2,3,4,1,2\n";
  EXPECT_THAT(refusal(kAngleColumns + "a,b" + row, Polarisation::s),
              HasSubstr("file: --polarisation s: no channel name contains a polarisation; found a, b"));
  EXPECT_THAT(refusal(kAngleColumns + "fr_ss,fr_pp" + row, Polarisation::average),
              HasSubstr("--polarisation average: cannot be computed from the channels of 'fr': ss, pp"));
  EXPECT_THAT(refusal(kAngleColumns + "fr_s,fr_p" + row, Polarisation::sp), HasSubstr("of 'fr': s, p"));
  EXPECT_THAT(refusal(kAngleColumns + "fr_s,fr_te" + row, Polarisation::s),
              HasSubstr("'fr_s' and 'fr_te' are both s"));
  EXPECT_THAT(refusal(kAngleColumns + "fr_s,fr" + row, Polarisation::s),
              HasSubstr("channel 'fr' has the same name as polarised channels"));
  EXPECT_THAT(refusal(kAngleColumns + "s,p\n1,2,3,4,1.7e308,1.7e308\n", Polarisation::average),
              HasSubstr("must be finite"));
}

constexpr Arrangement kAverage{.repeats = Repeats::average};

TEST(Repeats, BecomeTheirMeanWithItsStandardDeviation) {
  const SampleTable got =
      arranged(kAngleColumns + "fr\n1,2,3,4,1.0\n5,6,7,8,2\n1,362,3,-356,1.1\n1,2,3,4,1.2\n", kAverage);
  ASSERT_EQ(got.rows(), 2u);
  EXPECT_DOUBLE_EQ(got.values[0][0], 1.1);
  EXPECT_EQ(got.values[0][1], 2);
  // Only one pair is repeated, so that its sample variance 0.01 is the only evidence of the noise. The
  // other value is larger, and its noise is assumed to be in proportion.
  EXPECT_NEAR(got.sigma[0][0], .1 / std::sqrt(3.), 1e-15);
  EXPECT_NEAR(got.sigma[0][1], .1 * 2 / 1.1, 1e-15);
  EXPECT_THAT(got.lines, ElementsAre(2u, 3u));
  EXPECT_THAT(got.warnings.back(), HasSubstr("repeats: 4 rows are 2 pairs of directions, averaged"));
}

TEST(Repeats, PropagateWhatTheTableStates) {
  const SampleTable got =
      arranged(kAngleColumns + "fr,sigma_fr\n1,2,3,4,1,.3\n1,2,3,4,2,.4\n5,6,7,8,2,.7\n", kAverage);
  EXPECT_DOUBLE_EQ(got.sigma[0][0], .25);
  EXPECT_EQ(got.sigma[0][1], .7);
}

TEST(Repeats, ThatAreCopiesTellNoScatter) {
  const SampleTable got =
      arranged(kAngleColumns + "fr\n1,2,3,4,.1\n1,2,3,4,.1\n1,2,3,4,.1\n5,6,7,8,2\n", kAverage);
  EXPECT_EQ(got.values[0][0], .1);
  EXPECT_FALSE(got.has_sigma(0));
  EXPECT_THAT(got.warnings.back(), HasSubstr("copies, which give no measurement noise"));
  const std::string once = kAngleColumns + "fr\n1,2,3,4,.1\n5,6,7,8,2\n";
  expect_same(arranged(once, kAverage), read(once));
}

// Relative noise of 5 % on values over three decades, each measured twice: (mean - truth)/sigma must have
// variance 1.
TEST(Repeats, HaveStandardDeviationsThatHold) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  constexpr int kPairs = 4000;
  std::string text = kAngleColumns + "fr\n";
  std::vector<double> truth;
  for (int k = 0; k < kPairs; ++k) {
    truth.push_back(std::pow(10., -2 + 3. * k / kPairs));
    for (int twice = 0; twice < 2; ++twice)
      text += "1,2," + std::to_string(k / 50) + "," + std::to_string(k % 50) + "," +
              std::to_string(truth.back() * (1 + .05 * normal(random))) + "\n";
  }
  const SampleTable got = arranged(text, kAverage);
  ASSERT_EQ(got.rows(), std::size_t(kPairs));
  double sum = 0, largest = 0;
  for (std::size_t k = 0; k < got.rows(); ++k) {
    const double z = (got.values[0][k] - truth[k]) / got.sigma[0][k];
    sum += z * z;
    largest = std::max(largest, std::abs(z));
  }
  EXPECT_GT(sum / kPairs, .9);
  EXPECT_LT(sum / kPairs, 1.25);
  EXPECT_LT(largest, 8);  // from the two values alone, one in 4000 would be off by hundreds
}

}  // namespace
}  // namespace brdf::io
