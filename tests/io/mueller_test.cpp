// Tests polarised channels from Mueller matrices.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/samples/arrange.h"
#include "tests/io/foreign_tables.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

SampleTable chosen(const std::string& text, Polarisation polarisation) {
  const Arrangement asked{.polarisation = polarisation};
  SampleTable table = read_samples(Content{"file", text}, supplied_for({}, asked));
  arrange(table, asked);
  return table;
}

const std::string kDividedMueller =
    "lambda,thetai,phii,thetar,phir,fr11,m12,m21,m22\n.5,30,180,40,0,.4,.1,.05,.5\n.6,30,180,40,0,.8,.1,.05,."
    "5\n";
const std::string kUndividedMueller =
    "theta_i,phi_i,theta_o,phi_o,M11,M12,M21,M22\n30,180,40,0,.4,.04,.02,.2\n";

TEST(Mueller, GivesPolarisedChannelsOnRequest) {
  using P = Polarisation;
  const std::pair<P, double> values[] = {{P::average, .4}, {P::s, .44},  {P::p, .36}, {P::ss, .33},
                                         {P::sp, .11},     {P::ps, .09}, {P::pp, .27}};
  for (const auto& [polarisation, value] : values) {
    const SampleTable divided = chosen(kDividedMueller, polarisation);
    EXPECT_THAT(divided.channels, ElementsAre("500nm", "600nm")) << name_of(polarisation);
    ASSERT_EQ(divided.rows(), 1u);
    EXPECT_NEAR(divided.values[0][0], value, 1e-15) << name_of(polarisation);
    EXPECT_NEAR(divided.values[1][0], 2 * value, 1e-15) << name_of(polarisation);
    const SampleTable plain = chosen(kUndividedMueller, polarisation);
    EXPECT_EQ(plain.channels.size(), 1u);
    EXPECT_NEAR(plain.values[0][0], value, 1e-15) << name_of(polarisation);
  }
  EXPECT_THAT(read(kDividedMueller).channels, ElementsAre("500nm", "600nm"))
      << "unpolarised light by default";
}

TEST(Mueller, MayCountItsElementsFromZero) {
  const std::string table =
      "theta_i,phi_i,theta_o,phi_o,m00,m01,m10,m11,m12,m21,m22\n30,180,40,0,.4,.04,.02,.2,.11,.12,.13\n";
  const SampleTable plain = read(table);
  ASSERT_EQ(plain.channels.size(), 1u);
  EXPECT_DOUBLE_EQ(plain.values[0][0], .4) << "m00 is f_r of unpolarised light, not m11";
  EXPECT_NEAR(chosen(table, Polarisation::s).values[0][0], .44, 1e-15);
  EXPECT_NEAR(chosen(table, Polarisation::pp).values[0][0], .27, 1e-15);
}

TEST(Mueller, TheFirstElementOfAStokesVectorIsRead) {
  for (const char* names : {"S0,S1,S2,S3", "I,Q,U,V"}) {
    const SampleTable table =
        read("theta_i,phi_i,theta_r,phi_r," + std::string(names) + "\n30,180,40,0,.4,.1,.02,.01\n");
    ASSERT_EQ(table.channels.size(), 1u) << names;
    EXPECT_DOUBLE_EQ(table.values[0][0], .4);
  }
  const SampleTable degree = read("theta_i,phi_i,theta_r,phi_r,BRDF,DoLP,AoLP\n30,180,40,0,.4,.1,20\n");
  EXPECT_THAT(degree.channels, ElementsAre("BRDF"));
}

TEST(Mueller, RefusesImpossibleElements) {
  EXPECT_THAT(message_of([] { chosen(replaced(kUndividedMueller, ".04", ".5"), Polarisation::s); }),
              HasSubstr("line 2: an element of the Mueller matrix exceeds the first one, 0.4"));
  EXPECT_THAT(message_of([] { chosen("theta_i,phi_i,theta_o,phi_o,f\n30,180,40,0,1\n", Polarisation::s); }),
              HasSubstr("no channel name contains a polarisation"));
}

TEST(Mueller, AgreesWithTheExamples) {
  const auto expected = example("../faults/formats", "mueller_tiny.expect.csv");
  BRDF_SKIP_WITHOUT(expected);
  const SampleTable rows = read_samples(*expected);
  for (const char* name : {"mueller_tiny.csv", "mueller_tiny_paper.csv"}) {
    const SampleTable table = read_samples(*example("../faults/formats", name), {.polarised = true});
    for (const char* polarisation : {"s", "p", "ss", "sp", "ps", "pp"}) {
      const auto column = [&](const SampleTable& t, const std::string& channel) {
        return std::size_t(std::find(t.channels.begin(), t.channels.end(), channel) - t.channels.begin());
      };
      const std::size_t ours = column(table, std::string(polarisation) + "_500nm");
      const std::size_t theirs = column(rows, std::string("500nm ") + polarisation);
      ASSERT_LT(ours, table.channels.size());
      ASSERT_LT(theirs, rows.channels.size());
      for (std::size_t k = 0; k < rows.rows(); ++k) {
        const int row = row_of(table, rows, k, 1e-5);
        ASSERT_GE(row, 0);
        EXPECT_NEAR(table.values[ours][std::size_t(row)], rows.values[theirs][k], 1e-9);
      }
    }
  }
}

TEST(Mueller, ReadsAPublishedTable) {
  const auto file = example("formats", "nist_ptfe_532_633.csv");
  BRDF_SKIP_WITHOUT(file);
  const auto mean = [&](Polarisation polarisation, std::size_t channel) {
    const Arrangement asked{.polarisation = polarisation};
    SampleTable table = read_samples(*file, supplied_for({}, asked));
    arrange(table, asked);
    return mean_of(table, channel);
  };
  EXPECT_NEAR(mean(Polarisation::s, 0), .31313985, 1e-8);
  EXPECT_NEAR(mean(Polarisation::s, 1), .31314139, 1e-8);
  EXPECT_NEAR(mean(Polarisation::p, 0), .31311344, 1e-8);
  EXPECT_NEAR(mean(Polarisation::p, 1), .31340138, 1e-8);
}

}  // namespace
}  // namespace brdf::io
