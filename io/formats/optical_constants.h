// Reads published tables of a material's complex index of refraction.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

struct Index {
  double n = 1, k = 0;
  bool operator==(const Index&) const = default;
};

// Indices of refraction, ordered by ascending wavelength. There is at least one.
struct OpticalConstants {
  std::string source;  // the file, for messages
  std::vector<double> nm;
  std::vector<Index> index;

  // Interpolates n and k linearly between the rows. Throws InputError if the wavelength (nm) is outside the
  // table.
  Index at(double wavelength) const;
  // Returns the indices for channels that are named by a wavelength. Throws InputError if a channel is not,
  // or if its wavelength is outside the table.
  std::vector<Index> indices(const std::vector<std::string>& channels) const;
  // Returns the reflectance at normal incidence in air (fresnel_conductor) for channels that are named by a
  // wavelength in the table, or for red, green and blue. The latter are linear sRGB under D65, clamped to 0
  // to 1. They are computed with srgb_weights at every 5 nm of the table, which must reach from 480 to 620
  // nm; beyond its ends the reflectance is taken as constant. Throws InputError for other channels and for
  // a table that is too short.
  std::vector<double> reflectances(const std::vector<std::string>& channels) const;
};

// Reads a table in one of these forms:
// - a header row with `wavelength` (`wl`, `lambda`), `n` and optionally `k`, separated by commas, semicolons,
//   tabs or blanks. Other columns are ignored, except `material`: it names the material of each row, and
//   only the rows of the requested `material` are read;
// - two such tables one after the other, the second with k at the same wavelengths (CSV of
//   refractiveindex.info);
// - a record of refractiveindex.info of type `tabulated nk` or `tabulated n` (Polyanskiy 2024, Sci. Data
//   11, 94).
// Wavelengths are in the unit that the column's name gives. Without a unit they are in micrometres if all
// are below 100, otherwise in nanometres. Wavelengths are 0.001 to 1e9 in their unit; n and k are 0 to 1e6.
// Without a column k, k is 0. Throws InputError with the file and the line.
OpticalConstants read_optical_constants(const Content& content, std::string_view material = "");
// Reads the table of a file. `named` is "FILE" or "FILE:MATERIAL".
OpticalConstants read_optical_constants(const std::string& named);

}  // namespace brdf::io
