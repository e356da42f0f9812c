// Writes isotropic reflectances as RGL's files, which Mitsuba and pbrt import (Dupuy and Jakob 2018,
// supplement).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "brdf/vec3.h"

namespace brdf::io::rgl {

// f_r per channel, in 1/sr, at unit directions above the horizon.
using Values = std::function<void(const Vec3<double>& wi, const Vec3<double>& wo, std::span<double> f)>;

struct FileOptions {
  std::string description = "brdf";
  std::uint64_t bytes = 4'000'000;  // approximate size of the whole file; at least 200,000
};

// Returns the bytes of a file. One channel, or red, green and blue, become `rgb`, which an rgb variant of
// Mitsuba and RGL's own loaders read. Two or more channels that are named by wavelengths become `spectra`,
// which spectral variants and pbrt read. `values` must not change if both directions are rotated about the
// normal.
//
// A value is multiplied by the table `ndf` and divided by the table `sigma`. They follow the mean over the
// azimuth along the polar angles of the half vector and of incidence, which leaves a factor that varies
// slowly. `vndf` is uniform. `luminance` holds the whole of f cos_o as a density over half vectors, so
// importers sample in proportion to f cos_o. Accuracy: for GGX lobes of alpha 0.05 to 0.5, up to 80
// degrees, the median error is at most 0.2 % at 4 MB and 0.05 % at 25 MB. Throws InputError for other
// channels, for wavelengths that do not ascend, and for too small a file.
std::string file_of(const Values& values, const std::vector<std::string>& channels,
                    const FileOptions& options);

}  // namespace brdf::io::rgl
