// Tests the synthetic instrument: its readings, noise, apertures and grids of directions.
#include "synth/instrument.h"
#include "brdf/forms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/material/material_json.h"

namespace brdf::synth {
namespace {

using testing::Contains;
using testing::HasSubstr;

Material ward_material(double alpha_x, double alpha_y) {
  Material material = make_material(ward{}, {"fr"});
  material.terms[0].shape[0] = {alpha_x, alpha_y};
  return material;
}

Instrument in_plane() {
  Instrument instrument;
  instrument.grid.parts = {"in_plane"};
  return instrument;
}

std::string text_of(const io::SampleTable& table) {
  std::ostringstream out;
  io::write_samples(out, table);
  return out.str();
}

TEST(Instrument, NoiseFreeReadingsAreTheMaterialToTwelveDigits) {
  const Material material = ward_material(0.1, 0.3);
  const io::SampleTable table = measure(material, Instrument{});
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const Directions<double> d = arrays.view();
  double value[1], worst = 0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    eval(material, d.wi(k), d.wo(k), value);
    worst = std::max(worst, std::abs(table.values[0][k] / value[0] - 1));
  }
  EXPECT_LT(worst, 5.001e-12);
  EXPECT_GT(worst, 1e-12);
}

TEST(Instrument, TheSameSettingsGiveTheSameBytesAndAnotherSeedOthers) {
  Instrument instrument;
  instrument.noise = 0.05;
  const std::string first = text_of(measure(ward_material(0.1, 0.3), instrument));
  EXPECT_EQ(first, text_of(measure(ward_material(0.1, 0.3), instrument)));
  instrument.seed = 2;
  EXPECT_NE(first, text_of(measure(ward_material(0.1, 0.3), instrument)));
}

TEST(Instrument, TheHeaderHoldsTheTruthAndEverySetting) {
  const Material material = ward_material(0.1, 0.3);
  Instrument instrument;
  instrument.noise = 0.05;
  instrument.aperture = 1.5;
  const io::SampleTable table = measure(material, instrument);
  const io::Json truth = io::parse_json(table.find_metadata("truth").value(), "header");
  EXPECT_EQ(io::material_from_json(io::JsonPlace(truth, "header")).material, material);
  EXPECT_EQ(table.find_metadata("noise"), "0.05");
  EXPECT_EQ(table.find_metadata("aperture"), "1.5");
  for (const char* key :
       {"sample", "instrument", "source", "licence", "brdf_version", "seed", "grid", "azimuths", "blind_zone",
        "source_aperture", "noise_floor", "saturation", "clip_negatives"})
    EXPECT_TRUE(table.find_metadata(key).has_value()) << key;
}

TEST(Instrument, NoiseHasMeanOneAndTheStatedDeviation) {
  Instrument instrument;
  instrument.noise = 0.2;
  Material material = make_material(lambert{}, std::vector<std::string>(31, "c"));
  for (std::size_t c = 0; c < 31; ++c) material.channels[c] += std::to_string(c);
  const io::SampleTable table = measure(material, instrument);
  double n = 0, sum = 0, squares = 0;
  for (const auto& column : table.values)
    for (const double value : column) {
      const double factor = value / (0.5 / kPi);
      n += 1;
      sum += factor;
      squares += factor * factor;
    }
  const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
  EXPECT_NEAR(mean, 1, 4 * 0.2 / std::sqrt(n));
  EXPECT_NEAR(deviation, std::sqrt(std::exp(0.04) - 1), 0.002);
}

TEST(Instrument, AdditiveNoiseSaturationAndClippingActOnReadings) {
  Instrument instrument;
  instrument.noise_floor = 0.1;
  instrument.saturation = 0.3;
  instrument.clip_negatives = true;
  const io::SampleTable table = measure(make_material(lambert{}, {"fr"}), instrument);
  const auto [low, high] = std::minmax_element(table.values[0].begin(), table.values[0].end());
  EXPECT_EQ(*low, 0);
  EXPECT_EQ(*high, 0.3);
  EXPECT_THAT(table.warnings, Contains(HasSubstr("readings saturated")));
  EXPECT_THAT(table.warnings, Contains(HasSubstr("negative readings set to 0")));
}

TEST(Instrument, SigmaColumnsSayTheDeviationOfEveryReading) {
  Instrument instrument;
  instrument.noise = 0.05;
  instrument.noise_floor = 0.01;
  instrument.sigma_columns = true;
  const io::SampleTable table = measure(make_material(lambert{}, {"fr"}), instrument);
  const double value = 0.5 / kPi, relative = std::sqrt(std::exp(0.0025) - 1);
  EXPECT_NEAR(table.sigma[0][0], std::hypot(value * relative, 0.01), 1e-12);
  instrument.noise = instrument.noise_floor = 0;
  EXPECT_THROW(measure(make_material(lambert{}, {"fr"}), instrument), InputError);
}

TEST(Instrument, AnApertureWiderThanTheLobeFlattensItAndWarns) {
  Instrument instrument = in_plane();
  instrument.grid.theta_i = {30};
  instrument.grid.step = 0.25;
  const io::SampleTable sharp = measure(ward_material(0.004, 0.004), instrument);
  EXPECT_TRUE(sharp.warnings.empty());
  instrument.aperture = 1;
  const io::SampleTable blurred = measure(ward_material(0.004, 0.004), instrument);
  ASSERT_EQ(blurred.warnings.size(), 1u);
  EXPECT_THAT(blurred.warnings[0], HasSubstr("narrower than the aperture"));
  const auto peak = [](const io::SampleTable& t) {
    return *std::max_element(t.values[0].begin(), t.values[0].end());
  };
  // At 30 degrees the mirror lobe of slopes alpha is a Gaussian of widths 2 alpha and 2 alpha cos(30) in
  // angle.
  EXPECT_NEAR(peak(blurred) / peak(sharp), 0.52, 0.05);
  EXPECT_TRUE(measure(ward_material(0.1, 0.1), instrument).warnings.empty());
}

TEST(Instrument, RefusesSettingsOutOfRangeByTheirOption) {
  const auto message = [](auto set) {
    Instrument instrument;
    set(instrument);
    try {
      measure(ward_material(0.1, 0.1), instrument);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(message([](Instrument& i) { i.noise = -1; }), HasSubstr("--noise -1: must be between 0 and 2"));
  EXPECT_THAT(message([](Instrument& i) { i.aperture = 91; }), HasSubstr("--aperture 91"));
  EXPECT_THAT(message([](Instrument& i) { i.grid.step = 1e-9; }), HasSubstr("--step 1e-09"));
  EXPECT_THAT(message([](Instrument& i) { i.grid.theta_i = {90}; }), HasSubstr("--theta-i 90"));
  EXPECT_THAT(message([](Instrument& i) { i.grid.parts = {"nowhere.csv"}; }),
              HasSubstr("nowhere.csv: cannot be read"));
}

TEST(Grid, InPlaneStaysInThePlaneAndJoinsWithTheHemisphere) {
  const std::size_t plane = make_grid(in_plane().grid).rows();
  EXPECT_EQ(plane, 6u * 171u);
  GridOptions both;
  const std::size_t hemisphere = make_grid(both).rows();
  EXPECT_EQ(hemisphere, 5u * (1 + 16 * 36));
  both.parts = {"hemisphere", "in_plane"};
  EXPECT_EQ(make_grid(both).rows(), plane + hemisphere);
}

TEST(Grid, TurningTheSampleTurnsBothDirectionsTheOtherWay) {
  GridOptions options = in_plane().grid;
  options.azimuths = {0, 30};
  const io::SampleTable grid = make_grid(options);
  const std::size_t half = grid.rows() / 2;
  EXPECT_EQ(grid.phi_i[half], 150);
  EXPECT_EQ(grid.phi_o[half + 85 + 40], 330);
  // Rotating the sample of an anisotropic material must give the same values as rotating the material.
  Instrument turned_sample = in_plane();
  turned_sample.grid.azimuths = {30};
  Material turned_material = ward_material(0.1, 0.3);
  turned_material.terms[0].tangent_phi = degrees(30);
  const io::SampleTable a = measure(ward_material(0.1, 0.3), turned_sample);
  const io::SampleTable b = measure(turned_material, in_plane());
  for (std::size_t k = 0; k < a.rows(); ++k) ASSERT_NEAR(a.values[0][k] / b.values[0][k], 1, 1e-10);
}

TEST(Grid, TheBlindZoneLeavesOutTheRetroDirection) {
  GridOptions options = in_plane().grid;
  options.blind_zone = 7;
  const io::SampleTable grid = make_grid(options);
  EXPECT_EQ(grid.rows(), 6u * (171u - 13u));
  for (std::size_t k = 0; k < grid.rows(); ++k)
    if (grid.phi_o[k] == grid.phi_i[k]) {
      EXPECT_GE(std::abs(grid.theta_o[k] - grid.theta_i[k]), 7);
    }
}

TEST(Anisotropy, IsSeenInAnyTerm) {
  EXPECT_FALSE(is_anisotropic(ward_material(0.1, 0.1)));
  EXPECT_TRUE(is_anisotropic(ward_material(0.1, 0.2)));
  EXPECT_FALSE(is_anisotropic(make_material(phong{})));
}

}  // namespace
}  // namespace brdf::synth
