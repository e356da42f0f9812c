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
#include "io/comments.h"
#include "io/content.h"
#include "io/raw_angles.h"
#include "io/supplied.h"

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

// Reads a table in any known format, recognised by its content, never by its suffix (docs/formats.md). Throws
// InputError naming file, line and column. What is read can be written: names, finite values and comments are
// those of a CSV. Values of another quantity become f_r; `supplied` states what the file does not, and may
// not contradict it.
SampleTable read_samples(const std::filesystem::path& path, const Supplied& supplied = {});
SampleTable read_samples(Content content, const Supplied& supplied = {});
// The same for a table of directions: a CSV without any value column is accepted.
SampleTable read_directions(const std::filesystem::path& path);
SampleTable read_directions(Content content);

// Where a table's values come from: measured ones are finite, which is a rule of the format; computed ones are what a function gave,
// written as nan, inf and -inf where they are no finite numbers. A table with such values is not read back as samples.
enum class Origin { measured, computed };

// Writes CSV that reads back to exactly the same table (shortest decimals that round-trip). Throws InputError
// where the table breaks a rule of the format. `quantity` is what the values are, if not f_r: f_r*cos_i or
// f_r*cos_o.
void write_samples(const std::filesystem::path& path, const SampleTable& table,
                   std::string_view quantity = "f_r", Origin origin = Origin::measured);
void write_samples(std::ostream& out, const SampleTable& table, std::string_view quantity = "f_r",
                   Origin origin = Origin::measured);

// Unit vectors of all rows in the local frame (normal +z, tangent +x).
DirectionArrays<double> unit_directions(const SampleTable& table);

// The unit vector of a direction given in degrees. Built on sin_degrees, so it is the same on every machine.
Vec3<double> unit_vector(double theta, double phi);

// The polar angle in [0, 180] and the azimuth in [0, 360)
// of a direction, in degrees; its length does not matter.
void polar_degrees(const Vec3<double>& w, double& theta, double& phi);

// Sine and cosine of an angle in degrees: exact at multiples of 90, otherwise within 1.5 ulp of the true
// value for |degrees| <= 1e6. Plain arithmetic only: the C library's differ in the last bit between
// processors, and seeded samples must not.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

}  // namespace brdf::io
