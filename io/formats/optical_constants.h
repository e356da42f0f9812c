// Published tables of a material's complex index of refraction.
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

// By wavelength, ascending; one or more.
struct OpticalConstants {
  std::string source;  // the file, for messages
  std::vector<double> nm;
  std::vector<Index> index;

  // n and k, each linear between the rows. Throws InputError where the wavelength (nm) is outside the table.
  Index at(double wavelength) const;
  // Of channels that are named by a wavelength in the table. Throws InputError.
  std::vector<Index> indices(const std::vector<std::string>& channels) const;
  // The reflectance along the normal in air (fresnel_conductor) of channels that are named by a wavelength in
  // the table, or of red, green and blue: as linear sRGB under D65 (srgb_weights of every 5 nm of the table,
  // which must reach from 480 to 620 nm; beyond its ends constant), brought into 0 to 1. Throws InputError
  // for others.
  std::vector<double> reflectances(const std::vector<std::string>& channels) const;
};

// Reads a table that is written in one of these ways:
//  - a header row with `wavelength` (`wl`, `lambda`), `n` and perhaps `k`, between commas, semicolons, tabs
//    or blanks;
//    other columns are left out, but for `material` where there are several: the one that is asked for is
//        taken;
//  - two of them after each other, the second of k at the same wavelengths (refractiveindex.info's CSV);
//  - a record of refractiveindex.info of type `tabulated nk` or `tabulated n` (Polyanskiy 2024, Sci. Data
//    11, 94).
// Wavelengths are in the unit that the column's name says; else in micrometres where all are below 100, in
// nanometres where not; they are .001 to 1e9 in it, n and k 0 to 1e6. Without k it is 0. Throws InputError
// naming file and line.
OpticalConstants read_optical_constants(const Content& content, std::string_view material = "");
// The same of a file, "FILE" or "FILE:MATERIAL".
OpticalConstants read_optical_constants(const std::string& named);

}  // namespace brdf::io
