// The table of samples: directions and BRDF values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/directions.h"
#include "io/columns/comments.h"
#include "io/samples/raw_angles.h"

namespace brdf::io {

// Measured or computed values of f_r in 1/sr, one row per pair of directions, stored column by column.
// Directions are polar coordinates in DEGREES as in the files, so that reading and writing is exact. Both
// directions point away from the surface; theta is measured from the normal, in [0, 90]. The mirror
// direction is theta_o = theta_i, phi_o = phi_i + 180.
struct SampleTable {
  std::vector<std::string> channels;
  std::vector<double> theta_i, phi_i, theta_o, phi_o;  // degrees
  std::vector<std::vector<double>> values;             // [channel][row], f_r in 1/sr
  std::vector<std::vector<double>> sigma;  // [channel][row], standard deviation in 1/sr; empty if unknown
  std::vector<Comment> metadata;           // header comments in order; free text has no key

  std::string source;                 // the file's path, for messages
  std::string format = "csv";         // csv, merl, rgl, astm_e1392, zemax, alta, exr
  std::vector<std::uint32_t> lines;   // [row] line in the file; empty if the format has no lines
  std::vector<std::string> warnings;  // omissions and repairs of the reader, one sentence each
  // The warnings on which values or directions depend: conversions of quantities and units, guesses.
  std::vector<std::string> assumptions;
  double scale = 1;         // factor by which the file's values were divided (relative_scale.h)
  std::size_t skipped = 0;  // entries of the file without a value (marked invalid, or undefined)
  RawAngles raw_angles;     // the columns of the angles as in the file; empty for binary formats

  std::size_t rows() const { return theta_i.size(); }
  bool has_sigma(std::size_t channel) const { return channel < sigma.size() && !sigma[channel].empty(); }
  // Returns whether a polar angle of a row exceeds `max_theta` (degrees) by more than the rounding of
  // conversions.
  bool is_beyond(std::size_t row, double max_theta) const {
    return theta_i[row] > max_theta + 1e-6 || theta_o[row] > max_theta + 1e-6;
  }
  // Returns the file's path, or "table" if there is no file.
  std::string name() const { return source.empty() ? "table" : source; }
  // Returns "FILE, line N" or "FILE, row N".
  std::string where(std::size_t row) const;
  // Returns the first metadata value under `key`.
  std::optional<std::string> find_metadata(std::string_view key) const;
  // Adds a warning that is an assumption.
  void assume(const std::string& sentence);
  // Adds a comment in the form that a file can hold: on one line, and as free text if the key is reserved.
  void add_comment(std::string_view key, std::string_view value);
  // Sets the names of the channels, and gives each channel an empty column of values and of deviations.
  void set_channels(std::vector<std::string> names);
  void reserve(std::size_t rows);
  // Adds a row of directions, in degrees. The caller adds the values.
  void add_directions(double theta_of_light, double phi_of_light, double theta_of_viewer,
                      double phi_of_viewer);
  void add_directions(const Vec3<double>& wi, const Vec3<double>& wo);
};

// The key of a comment that names the file of the instrument's uncertainty budget.
inline constexpr std::string_view kBudgetKey = "budget";
// Returns the path that a comment of a table names, relative to the folder of the table.
std::filesystem::path path_beside(const std::string& table, const std::string& named);
// Returns the comment of a copy of the table in this folder, which names the same file. std::nullopt if no
// comment names a budget.
std::optional<std::string> budget_comment_in(const std::filesystem::path& folder, const SampleTable& table);

// The origin of a table's values. Measured values are finite, which is a rule of the format. Computed
// values are the results of a function and may be nan, inf or -inf. A table with such values cannot be read
// back as samples.
enum class Origin { measured, computed };

// Returns the unit vectors of all rows in the local frame (normal +z, tangent +x).
// Example:
//     brdf::io::SampleTable table;
//     table.channels = {"green"};
//     table.add_directions(30, 0, 30, 180);  // degrees: the mirror direction
//     table.values = {{0.8}};                // 1/sr
//     const brdf::DirectionArrays<double> directions = unit_directions(table);
DirectionArrays<double> unit_directions(const SampleTable& table);

}  // namespace brdf::io
