// Compares tables that were read from files of other programs with expected rows.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "io/formats/read.h"
#include "io/samples/degrees.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Returns FOLDER/NAME in the folder of measured data, or std::nullopt if BRDF_DATA_DIR is unset or has no
// such file. `folder`: "formats" for measured files, "../faults/formats" for small examples.
inline std::optional<std::filesystem::path> example(const std::string& folder, const std::string& name = "") {
  const char* const data = std::getenv("BRDF_DATA_DIR");
  if (!data || !*data) return std::nullopt;
  const std::filesystem::path path = std::filesystem::path(data) / folder / name;
  return std::filesystem::exists(path) ? std::optional(path) : std::nullopt;
}

// Returns the digits and small letters of a channel's name, sorted, so that "s_550nm" equals "550nm s".
inline std::string name_key(const std::string& channel) {
  std::string key;
  for (const char c : channel)
    if (std::isalnum(static_cast<unsigned char>(c))) key += c;
  std::sort(key.begin(), key.end());
  return key;
}

struct Tolerance {
  double value = 1e-6;  // relative
  double angle = 1e-5;  // between directions, degrees
};

// Returns the number of the row of `table` with the directions of row `k` of `expected`: the same directions
// or, if no row has them, the same polar angles and difference of the azimuths. Returns -1 if no row has
// them.
inline int row_of(const SampleTable& table, const SampleTable& expected, std::size_t k, double tolerance) {
  const auto apart = [](double theta_a, double phi_a, double theta_b, double phi_b) {
    const Vec3<double> a = unit_vector(theta_a, phi_a), b = unit_vector(theta_b, phi_b);
    return radians(std::hypot(a.x - b.x, a.y - b.y, a.z - b.z)).degrees();
  };
  int turned = -1;  // a row of the same directions in a turned frame, or for all azimuths of the light
  for (std::size_t r = 0; r < table.rows(); ++r) {
    if (std::abs(table.theta_i[r] - expected.theta_i[k]) > tolerance) continue;
    const bool is_same_light =
        apart(table.theta_i[r], table.phi_i[r], expected.theta_i[k], expected.phi_i[k]) <= tolerance;
    if (is_same_light &&
        apart(table.theta_o[r], table.phi_o[r], expected.theta_o[k], expected.phi_o[k]) <= tolerance)
      return static_cast<int>(r);
    if (turned >= 0) continue;
    if (apart(table.theta_o[r], table.phi_o[r] - table.phi_i[r], expected.theta_o[k],
              expected.phi_o[k] - expected.phi_i[k]) <= tolerance ||
        (expected.theta_i[k] == 0 && std::abs(table.theta_o[r] - expected.theta_o[k]) <= tolerance))
      turned = static_cast<int>(r);
  }
  return turned;
}

// Expects that each row of `expected` is in `table`, with its values and standard deviations.
inline void expect_rows(const SampleTable& table, const SampleTable& expected, Tolerance tolerance = {}) {
  ASSERT_EQ(table.channels.size(), expected.channels.size());
  std::map<std::string, std::size_t> channels;
  for (std::size_t c = 0; c < table.channels.size(); ++c) channels[name_key(table.channels[c])] = c;
  for (std::size_t k = 0; k < expected.rows(); ++k) {
    const int r = row_of(table, expected, k, tolerance.angle);
    ASSERT_GE(r, 0) << "no row has the directions of " << expected.where(k);
    const auto row = static_cast<std::size_t>(r);
    for (std::size_t c = 0; c < expected.channels.size(); ++c) {
      const auto found = channels.find(name_key(expected.channels[c]));
      ASSERT_TRUE(found != channels.end() || channels.size() == 1) << "no channel " << expected.channels[c];
      const std::size_t of = found != channels.end() ? found->second : 0;
      const double value = expected.values[c][k];
      EXPECT_NEAR(table.values[of][row], value, tolerance.value * std::abs(value)) << expected.where(k);
      if (expected.has_sigma(c)) {
        ASSERT_TRUE(table.has_sigma(of));
        EXPECT_NEAR(table.sigma[of][row], expected.sigma[c][k], tolerance.value * expected.sigma[c][k]);
      }
    }
  }
}

// Compares the small example NAME with EXPECTED. Returns false if the folder is not at hand.
inline bool expect_example(const std::string& name, const std::string& expected, Tolerance tolerance = {}) {
  const auto file = example("../faults/formats", name), rows = example("../faults/formats", expected);
  if (!file || !rows) return false;
  SCOPED_TRACE(name);
  expect_rows(read_samples(*file), read_samples(*rows), tolerance);
  return true;
}

inline double mean_of(const SampleTable& table, std::size_t channel = 0) {
  double sum = 0;
  for (const double value : table.values[channel]) sum += value;
  return sum / static_cast<double>(table.rows());
}

// Returns the value of the row nearest to these directions, in degrees.
inline double value_at(const SampleTable& table, double theta_i, double phi_i, double theta_o, double phi_o,
                       std::size_t channel = 0) {
  SampleTable wanted;
  wanted.add_directions(theta_i, phi_i, theta_o, phi_o);
  const int row = row_of(table, wanted, 0, 0.01);
  return row < 0 ? std::nan("") : table.values[channel][static_cast<std::size_t>(row)];
}

#define BRDF_SKIP_WITHOUT(found) \
  if (!(found)) GTEST_SKIP() << "BRDF_DATA_DIR is unset or has no such file"

}  // namespace brdf::io
