// The MERL BRDF files (Matusik et al. 2003): isotropic, RGB, 90 x 90 x 180 cells in Rusinkiewicz'
// half-difference angles.
#pragma once

#include <filesystem>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::merl {

inline constexpr int kThetaHalf = 90, kThetaDifference = 90, kPhiDifference = 180;
inline constexpr std::size_t kCells = std::size_t{kThetaHalf} * kThetaDifference * kPhiDifference;
inline constexpr double kScale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};  // file times this is 1/sr

// Directions in degrees; theta_o or theta_i above 90 where the cell lies below the horizon.
struct CellDirections {
  double theta_i, phi_i, theta_o, phi_o;
};

// The centre of a cell in file order (theta_half, theta_difference, phi_difference
// from slow to fast): theta_half = 90 ((i + 1/2)/90)^2, theta_difference = j + 1/2,
// phi_difference = k + 1/2 degrees, half vector at azimuth 0. phi_difference covers
// 180 degrees: exchanging the directions adds 180, and the files are reciprocal.
CellDirections cell_directions(std::size_t cell);

// The cell that holds a pair of directions; their common azimuth does not matter.
std::size_t find_cell(double theta_i, double phi_i, double theta_o, double phi_o);

// Appends the directions of all cells above the horizon, in file order, without values.
void add_cell_directions(SampleTable& table);

// True where the file begins with three small integers, as no text does: whether they are the right ones, and
// the size, read() judges.
bool recognises(const Content& content);

// Reads the whole file; cells marked invalid (negative) or below the horizon are left out and counted.
// `supplied` may say nothing else of values and azimuths than the format does.
SampleTable read(const Content& content, const Supplied& supplied = {});

// Writes the mean of the rows in each cell, -1 where there are none; which channels are red, green and blue
// their names say (io/colour/channel_colours.h). Returns what is lost, one phrase each.
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::merl
