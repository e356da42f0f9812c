// Tests small versions of RGL's files with spectra and with azimuths.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "io/files/content.h"
#include "io/formats/rgl.h"
#include "io/samples/degrees.h"
#include "tests/io/reading.h"
#include "tests/io/tensor_bytes.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr float kPi = std::numbers::pi_v<float>;

SampleTable read_tensor(const TensorBytes& tensor) {
  return read(tensor.bytes());
}

// Returns a file in which the values of each band are constant over the square. `value_at` has one value
// for each azimuth of the file.
TensorBytes of_azimuths(const std::vector<float>& phi_i, const std::vector<float>& value_at) {
  TensorBytes tensor;
  const std::size_t n = phi_i.size();
  tensor.field("phi_i") = {"phi_i", 10, {n}, TensorBytes::floats(phi_i)};
  tensor.field("vndf") = {"vndf", 10, {n, 2, 2, 2}, TensorBytes::floats(std::vector<float>(8 * n, 1.0f))};
  tensor.field("ndf").data = tensor.field("sigma").data;
  std::vector<float> values;
  for (const float v : value_at) values.insert(values.end(), 24, v);
  tensor.field("rgb") = {"rgb", 10, {n, 2, 3, 2, 2}, TensorBytes::floats(values)};
  return tensor;
}

double at(const TensorBytes& tensor, double phi_i, double phi_o) {
  const std::string bytes = tensor.bytes();
  const rgl::Measurement measurement(Content{"file", bytes});
  std::vector<double> f(3);
  measurement.eval_cos_o(unit_vector(40, phi_i), unit_vector(30, phi_o), f);
  EXPECT_EQ(f[0], f[2]);
  return 4 * f[0];  // ndf / (4 sigma) is a quarter
}

TEST(RglFile, BandsAreChannelsOfTheirWavelengths) {
  const SampleTable rgb = read_tensor(TensorBytes());
  TensorBytes tensor;
  std::vector<float> values;
  for (int angle = 0; angle < 2; ++angle)
    for (const float band : {0.25f, 0.5f, 1.0f, 2.0f}) values.insert(values.end(), 4, band);
  tensor.field("rgb") = {"spectra", 10, {1, 2, 4, 2, 2}, TensorBytes::floats(values)};
  tensor.fields.push_back({"wavelengths", 10, {4}, TensorBytes::floats({400, 500.5f, 600, 1000})});
  const SampleTable spectrum = read_tensor(tensor);
  EXPECT_THAT(spectrum.channels, ElementsAre("400nm", "500.5nm", "600nm", "1000nm"));
  ASSERT_EQ(spectrum.rows(), rgb.rows());
  EXPECT_EQ(spectrum.values[1], rgb.values[0]);
  for (std::size_t row = 0; row < rgb.rows(); ++row)
    EXPECT_DOUBLE_EQ(spectrum.values[3][row], 4 * rgb.values[0][row]);
}

TEST(RglFile, AQuarterOfTheCircleStandsForAllOfItByMirrors) {
  const TensorBytes quarter = of_azimuths({-kPi, -0.75f * kPi, -0.5f * kPi}, {1, 2, 4});
  for (const double phi : {0.0, 180.0}) EXPECT_NEAR(at(quarter, phi, phi + 180), 1, 1e-6) << phi;
  for (const double phi : {90.0, 270.0}) EXPECT_NEAR(at(quarter, phi, phi + 180), 4, 1e-6) << phi;
  for (const double phi : {45.0, 135.0, 225.0, 315.0})
    EXPECT_NEAR(at(quarter, phi, phi + 180), 2, 1e-6) << phi;
  EXPECT_NEAR(at(quarter, 202.5, 0), 1.5, 1e-6);  // between two azimuths of the file
}

TEST(RglFile, HalfOfTheCircleStandsForAllOfItByHalfATurn) {
  const TensorBytes half = of_azimuths({-kPi, -0.5f * kPi, 0}, {1, 2, 4});
  EXPECT_NEAR(at(half, 225, 0), 1.5, 1e-6);
  EXPECT_NEAR(at(half, 45, 180), 1.5, 1e-6);
  EXPECT_NEAR(at(half, 315, 0), 3, 1e-6);
  EXPECT_NEAR(at(half, 135, 180), 3, 1e-6);
}

TEST(RglFile, AnAnisotropicOneIsSampledOverWhatItHolds) {
  const SampleTable t = read_tensor(of_azimuths({-kPi, -0.75f * kPi, -0.5f * kPi}, {1, 1, 1}));
  EXPECT_EQ(t.rows(), 4u * 6 * (1 + 20 * 24));
  EXPECT_EQ(*std::min_element(t.phi_i.begin(), t.phi_i.end()), 180);
  EXPECT_EQ(*std::max_element(t.phi_i.begin(), t.phi_i.end()), 270);
  EXPECT_EQ(read_tensor(of_azimuths({-kPi, kPi}, {1, 1})).rows(), 6u * (1 + 20 * 19));  // isotropic
  EXPECT_THAT(message(of_azimuths({-1, 0, 1}, {1, 1, 1}).bytes()), HasSubstr("phi_i spans neither"));
}

TEST(RglFile, WithoutAJacobianTheValuesStandAsTheyAre) {
  TensorBytes tensor = of_azimuths({0}, {0.5f});
  tensor.fields.push_back({"jacobian", 1, {1}, std::string(1, '\0')});
  EXPECT_NEAR(at(tensor, 180, 0) / 4, 0.5, 1e-7);
}

}  // namespace
}  // namespace brdf::io
