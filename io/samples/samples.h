#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "brdf/directions.h"
#include "io/columns/comments.h"
#include "io/samples/raw_angles.h"

namespace brdf::io {

// Measured or computed values of f_r in 1/sr, one row per pair of directions; column
// by column in memory. Directions are polar coordinates in DEGREES as in the files
// (so that reading and writing is exact), both away from the surface, theta from the
// normal in [0, 90]; the mirror direction is theta_o = theta_i, phi_o = phi_i + 180.
struct SampleTable {
  std::vector<std::string> channels;
  std::vector<double> theta_i, phi_i, theta_o, phi_o;  // degrees
  std::vector<std::vector<double>> values;             // [channel][row], f_r in 1/sr
  std::vector<std::vector<double>> sigma;  // [channel][row], standard deviation in 1/sr; empty where unknown
  std::vector<Comment> metadata;           // header comments in order; free text has no key

  std::string source;                 // the file's path, for messages
  std::string format = "csv";         // csv, merl, rgl, astm_e1392, zemax, alta, exr
  std::vector<std::uint32_t> lines;   // [row] line in the file; empty where the format has none
  std::vector<std::string> warnings;  // what the reader left out or repaired, one sentence each
  // Those of the warnings on which values or directions rest: conversions of quantities and units, guesses.
  std::vector<std::string> assumptions;
  double scale = 1;         // by which the file's values were divided (relative_scale.h)
  std::size_t skipped = 0;  // entries of the file that hold no value (marked invalid, or undefined)
  RawAngles raw_angles;     // the columns of the angles as the file holds them; empty for binary formats

  std::size_t rows() const { return theta_i.size(); }
  bool has_sigma(std::size_t channel) const { return channel < sigma.size() && !sigma[channel].empty(); }
  // Whether a polar angle of a row is beyond this one, degrees, by more than conversions round.
  bool is_beyond(std::size_t row, double max_theta) const {
    return theta_i[row] > max_theta + 1e-6 || theta_o[row] > max_theta + 1e-6;
  }
  // The file, or "table" where there is none.
  std::string name() const { return source.empty() ? "table" : source; }
  // "FILE, line N" or "FILE, row N".
  std::string where(std::size_t row) const;
  // First metadata value under `key`.
  std::optional<std::string> find_metadata(std::string_view key) const;
  // Adds a warning that is an assumption.
  void assume(const std::string& sentence);
  // Adds a comment as a file holds it: one line, free text where its key is reserved.
  void add_comment(std::string_view key, std::string_view value);
  void reserve(std::size_t rows);
  // Adds a row of directions, in degrees; its values are the caller's.
  void add_directions(double theta_of_light, double phi_of_light, double theta_of_viewer,
                      double phi_of_viewer);
};

// Where a table's values come from: measured ones are finite, which is a rule of the format; computed ones
// are what a function gave, written as nan, inf and -inf where they are no finite numbers. A table with such
// values is not read back as samples.
enum class Origin { measured, computed };

// Unit vectors of all rows in the local frame (normal +z, tangent +x).
DirectionArrays<double> unit_directions(const SampleTable& table);

}  // namespace brdf::io
