// Tests the project's own tables (CSV) and the trigonometric functions of degrees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"
#include "io/samples/degrees.h"
#include "io/samples/samples.h"
#include "tests/io/reading.h"

namespace brdf::io {
namespace {

using testing::HasSubstr;

constexpr const char* kOneChannel = "theta_i,phi_i,theta_o,phi_o,fr\n";

class Csv : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& content) {
    const auto path = folder_.path() / "s.csv";
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  std::string message(const std::string& content) {
    try {
      read_samples(file(content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  io::TemporaryFolder folder_;
};

TEST_F(Csv, RoundTripsExactly) {
  std::mt19937_64 random(7);
  SampleTable table;
  table.channels = {"r", "g"};
  table.values.resize(2);
  table.sigma.resize(2);
  table.metadata = {{"sample", "a: b, c"}, {"", "free text"}};
  const auto bits = [&](double scale) {
    return scale * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  for (int k = 0; k < 5000; ++k) {
    table.add_directions(bits(90), bits(360) - 180, bits(90), bits(360));
    table.values[0].push_back(std::exp(bits(200) - 100));
    table.values[1].push_back(bits(1) - .5);
    table.sigma[1].push_back(bits(1e-9) + 1e-300);
  }
  write_samples(folder_.path() / "t.csv", table);
  const SampleTable back = read_samples(folder_.path() / "t.csv");
  expect_same(back, table);
}

TEST_F(Csv, AcceptsCommentsBlankLinesCarriageReturnsSpacesAndAnyColumnOrder) {
  const SampleTable t = read_samples(file(
      "\xEF\xBB\xBF# sample: x\r\n\r\nfr, sigma_fr,theta_i,phi_i,theta_o,phi_o\r\n 1.5,+.1,10,0,20,180\r\n"
      "# between\r\n2,.2,30,0,40,180"));
  ASSERT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.values[0][0], 1.5);
  EXPECT_EQ(t.sigma[0][1], .2);
  EXPECT_EQ(t.theta_i[1], 30);
  EXPECT_EQ(t.find_metadata("sample"), "x");
  EXPECT_THAT(t.where(1), HasSubstr("s.csv, line 6"));
}

TEST_F(Csv, NegativePolarAnglesAreTheOppositeAzimuth) {
  const SampleTable t =
      read_samples(file(std::string(kOneChannel) + "10,180,-20,0,1\n10,180,-20,180,1\n10,180,-20,250,1\n"));
  EXPECT_THAT(t.theta_o, testing::Each(20));
  EXPECT_THAT(t.phi_o, testing::ElementsAre(180, 0, 70));
}

TEST_F(Csv, DividesTheStatedCosineOut) {
  const SampleTable o =
      read_samples(file("# quantity: f_r*cos_o\n" + std::string(kOneChannel) + "0,0,60,0,1\n0,0,90,0,1\n"));
  EXPECT_DOUBLE_EQ(o.values[0][0], 2.0);
  EXPECT_EQ(o.rows(), 1u);
  EXPECT_EQ(o.skipped, 1u);
  EXPECT_THAT(o.warnings, testing::ElementsAre("column 'fr' is f_r times cos_o: divided by cos_o",
                                               HasSubstr("1 row left out")));
  const SampleTable i =
      read_samples(file("# quantity: f_r * cos_i\n" + std::string(kOneChannel) + "60,0,0,0,1\n"));
  EXPECT_DOUBLE_EQ(i.values[0][0], 2.0);
}

TEST_F(Csv, NamesLineAndColumnOfAMalformedRow) {
  const std::string header = kOneChannel;
  EXPECT_THAT(message(header + "0,0,0,0,1\n0,0,x,0,1\n"),
              HasSubstr("s.csv, line 3: column 3 (theta_o): 'x' is not a number"));
  EXPECT_THAT(message(header + "0,0,0,0,\n"), HasSubstr("line 2: column 5 (fr): '' is not a number"));
  EXPECT_THAT(message(header + "0,0,0,0,1 2\n"), HasSubstr("'1 2' is not a number"));
  EXPECT_THAT(message(header + "0,0,0,0,1e999\n"), HasSubstr("is not a number"));
  EXPECT_THAT(message(header + "0,0,0,0,nan\n"), HasSubstr("'nan' is not finite"));
  EXPECT_THAT(message(header + "0,0,0,0\n"), HasSubstr("line 2: 4 columns, but the header has 5"));
  EXPECT_THAT(message(header + "0,0,91,0,1\n"), HasSubstr("'91' is below the horizon"));
}

TEST_F(Csv, NamesExchangedColumns) {
  const std::string header = "theta_i,phi_i,theta_o,phi_o,fr\n";
  EXPECT_THAT(message(header + "30,180,0,10,1\n30,180,95,10,1\n30,180,270,80,1\n30,180,355,0,1\n"),
              HasSubstr("theta_o reaches 355 degrees and phi_o only 80: the columns theta_o and phi_o seem "
                        "to be exchanged"));
  // One angle of many that is too large, or polar angles above 90 degrees with azimuths beyond a quarter
  // turn, are reported as a wrong angle, not as exchanged columns.
  EXPECT_THAT(message(header + "0,0,10,0,1\n0,0,20,0,1\n0,0,30,0,1\n0,0,91,0,1\n"),
              HasSubstr("must be between"));
  EXPECT_THAT(message(header + "0,0,95,180,1\n0,0,96,180,1\n"), HasSubstr("must be between"));
}

TEST_F(Csv, NamesWhatIsWrongWithTheHeader) {
  EXPECT_THAT(message("0,0,0,0,1\n"), HasSubstr("line 1: the header row is missing"));
  EXPECT_THAT(message("theta_i,phi_i,fr\n"), HasSubstr("'theta_o' is missing"));
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o\n"), HasSubstr("no value column"));
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,a,a\n"), HasSubstr("column 'a' twice"));
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,a,sigma_b\n"),
              HasSubstr("'sigma_b' has no column of values"));
  EXPECT_THAT(message("theta_i,phi_i,theta_o,phi_o,a,sigma_a\n0,0,0,0,1,0\n"), HasSubstr("must be above 0"));
  EXPECT_THAT(
      message("# quantity: radiance\n" + std::string(kOneChannel)),
      HasSubstr("quantity 'radiance' is a radiance, not f_r: the irradiance of the sample is missing"));
  EXPECT_THAT(message("# quantity: stickiness\n" + std::string(kOneChannel)),
              HasSubstr("quantity 'stickiness' is unknown (known: f_r, BRF, f_r*cos_o, "));
  EXPECT_THAT(message(kOneChannel), HasSubstr("has no rows"));
  EXPECT_THAT(message(""), HasSubstr("no header row"));
}

TEST_F(Csv, AnUnreadableFileIsBadInput) {
  EXPECT_THROW(read_samples(folder_.path() / "none.csv"), InputError);
  EXPECT_THROW(read_samples(folder_.path()), InputError);
}

TEST_F(Csv, DirectionsNeedNoValues) {
  EXPECT_EQ(read_directions(file("theta_i,phi_i,theta_o,phi_o\n1,2,3,4\n")).rows(), 1u);
}

TEST(Degrees, AnAzimuthIsBelowAWholeTurn) {
  EXPECT_EQ(within_turn(-90), 270);
  EXPECT_EQ(within_turn(725), 5);
  // The sums of these angles and 360 round to 360.
  EXPECT_EQ(within_turn(-1e-15), 0);
  EXPECT_EQ(polar_degrees({1, -1e-18, 1}).phi, 0);
  EXPECT_FALSE(std::signbit(within_turn(-0.0)));
}

TEST(Degrees, AreExactAtQuartersAndAccurateBetween) {
  EXPECT_EQ(cos_degrees(90), 0.0);
  EXPECT_EQ(sin_degrees(180), 0.0);
  EXPECT_EQ(sin_degrees(-90), -1.0);
  EXPECT_EQ(cos_degrees(540), -1.0);
  // Results close to 0 at angles away from the origin are not compared, because there the reference itself
  // would need more digits of pi.
  double worst = 0;
  const auto compare = [&](double value, long double exact, double degrees) {
    if (std::abs(exact) > .1L || std::abs(degrees) < 45)
      worst = std::max(worst, static_cast<double>(std::abs((value - exact) / exact)));
  };
  for (double degrees = -719.99; degrees < 720; degrees += .0371) {
    const long double radians = static_cast<long double>(degrees) * (acosl(-1.0L) / 180);
    compare(sin_degrees(degrees), sinl(radians), degrees);
    compare(cos_degrees(degrees), cosl(radians), degrees);
  }
  EXPECT_LT(worst, 3.4e-16);
  EXPECT_GT(worst, 1e-16);
}

}  // namespace
}  // namespace brdf::io
