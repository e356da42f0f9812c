// Reads and writes MERL BRDF files (Matusik et al. 2003): isotropic, RGB, 90 x 90 x 180 cells in
// Rusinkiewicz' half-difference angles.
#pragma once

#include <filesystem>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::merl {

inline constexpr int kThetaHalf = 90, kThetaDifference = 90, kPhiDifference = 180;
inline constexpr std::size_t kCells = std::size_t{kThetaHalf} * kThetaDifference * kPhiDifference;
// Factors from the numbers in the file to f_r in 1/sr, for red, green and blue.
inline constexpr double kScale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

// Directions in degrees. theta_o or theta_i is above 90 if the cell lies below the horizon.
struct CellDirections {
  double theta_i, phi_i, theta_o, phi_o;
};

// Returns the centre of a cell. Cells are numbered in file order: theta_half, theta_difference,
// phi_difference from slow to fast. The centre has theta_half = 90 ((i + 1/2)/90)^2, theta_difference = j +
// 1/2 and phi_difference = k + 1/2 degrees; the half vector is at azimuth 0. phi_difference covers only 180
// degrees: exchanging the directions adds 180, and the files are reciprocal.
CellDirections cell_directions(std::size_t cell);

// Returns the cell that contains a pair of directions, in degrees. Their common azimuth has no effect.
std::size_t find_cell(double theta_i, double phi_i, double theta_o, double phi_o);

// Appends the directions of all cells above the horizon to `table`, in file order, without values.
void add_cell_directions(SampleTable& table);

// Returns whether the file begins with three small positive integers, which no text does. read() checks
// their values and the size of the file.
bool recognises(const Content& content);

// Reads the whole file. Cells that are marked invalid (negative) or lie below the horizon are left out and
// counted. `supplied` must agree with the format about values and azimuths. Throws InputError for a
// disagreement, for other dimensions or another size, and if no cell is valid.
SampleTable read(const Content& content, const Supplied& supplied = {});

// Writes the mean of the rows in each cell, and -1 for cells without rows. The names of the channels
// determine which are red, green and blue (io/colour/channel_colours.h). Returns the losses, one phrase
// each. Throws InputError if the channels have no colours, or if a value is too large for the file.
// Example:
//     // #include "brdf/io/formats/read.h"
//     const brdf::io::SampleTable table = brdf::io::read_samples("paint.csv");
//     for (const std::string& loss : brdf::io::merl::write("paint as cells.binary", table))
//       std::printf("lost: %s\n", loss.c_str());
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::merl
