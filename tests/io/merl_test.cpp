// Tests the cells and the files of the MERL format.
#include "io/formats/merl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>

#include "io/files/error.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"

namespace brdf::io::merl {
namespace {

TEST(MerlCells, EveryCellFindsItselfAndItsExchange) {
  std::size_t visible = 0;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const CellDirections d = cell_directions(cell);
    if (d.theta_i > 90 || d.theta_o > 90) continue;
    ++visible;
    if (cell % 13 != 0) continue;
    ASSERT_EQ(find_cell(d.theta_i, d.phi_i, d.theta_o, d.phi_o), cell);
    ASSERT_EQ(find_cell(d.theta_o, d.phi_o, d.theta_i, d.phi_i), cell) << "reciprocal";
    if (cell % 101 == 0) {
      ASSERT_EQ(find_cell(d.theta_i, d.phi_i + 77, d.theta_o, d.phi_o + 77), cell) << "isotropic";
    }
  }
  EXPECT_EQ(visible, 1096216u);  // 75 % of the cells are above the horizon
}

TEST(MerlCells, TheHalfVectorIsAtTheCellsCentre) {
  // theta_half is 90 (9.5/90)^2 and theta_difference 0.5: both directions are within half a degree of
  // theta_half.
  const CellDirections d = cell_directions((9 * kThetaDifference + 0) * kPhiDifference);
  EXPECT_NEAR(d.theta_i, 90 * std::pow(9.5 / 90, 2) + .5, 1e-4);
  EXPECT_NEAR(d.theta_o, 90 * std::pow(9.5 / 90, 2) - .5, 1e-2);
}

class MerlFile : public testing::Test {
 protected:
  static SampleTable table() {
    SampleTable t;
    t.channels = {"r", "g", "b"};
    t.values.resize(3);
    t.sigma.resize(3);
    add_cell_directions(t);
    std::mt19937_64 random(1);
    for (auto& plane : t.values)
      for (std::size_t k = 0; k < t.rows(); ++k)
        plane.push_back(std::exp(10 * std::ldexp(double(random() >> 11), -53) - 7));
    return t;
  }
  io::TemporaryFolder folder_;
};

TEST_F(MerlFile, RoundTripsToRoundingAndCountsInvalidCells) {
  const SampleTable t = table();
  const auto path = folder_.path() / "a.binary";
  write(path, t);
  EXPECT_EQ(std::filesystem::file_size(path), 12 + 3 * kCells * 8);
  const SampleTable back = read_samples(path);
  EXPECT_EQ(back.format, "merl");
  ASSERT_EQ(back.rows(), t.rows());
  EXPECT_EQ(back.skipped, kCells - t.rows());
  EXPECT_EQ(back.theta_i, t.theta_i);
  EXPECT_EQ(back.phi_o, t.phi_o);
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < t.rows(); ++k)
      worst = std::max(worst, std::abs(back.values[c][k] / t.values[c][k] - 1));
  EXPECT_LT(worst, 3e-16);
  EXPECT_GT(worst, 1e-17);
}

TEST_F(MerlFile, HoldsTheFormatsScalesAndOrder) {
  SampleTable t = table();
  for (std::size_t c = 0; c < 3; ++c) std::fill(t.values[c].begin(), t.values[c].end(), 1.0);
  write(folder_.path() / "a.binary", t);
  std::ifstream in(folder_.path() / "a.binary", std::ios::binary);
  std::int32_t dimensions[3];
  in.read(reinterpret_cast<char*>(dimensions), sizeof dimensions);
  EXPECT_EQ(dimensions[0], 90);
  EXPECT_EQ(dimensions[2], 180);
  for (const double expected : {1500.0, 1500.0 / 1.15, 1500.0 / 1.66}) {
    double first;
    in.read(reinterpret_cast<char*>(&first), sizeof first);
    EXPECT_NEAR(first, expected, 1e-9);
    in.seekg(static_cast<std::streamoff>((kCells - 1) * 8), std::ios::cur);
  }
}

TEST_F(MerlFile, SaysWhatIsLostAndRefusesOtherChannelCounts) {
  SampleTable t = table();
  t.metadata = {{"sample", "x"}};
  const auto lost = write(folder_.path() / "a.binary", t);
  EXPECT_THAT(lost, testing::Contains(testing::HasSubstr("361784 of 1458000 cells have no value")));
  EXPECT_THAT(lost, testing::Contains(testing::HasSubstr("comments")));
  t.channels.pop_back();
  t.values.pop_back();
  EXPECT_THROW(write(folder_.path() / "b.binary", t), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "b.binary"));
}

}  // namespace
}  // namespace brdf::io::merl
