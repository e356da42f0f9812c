// Writes look-up tables of ASAM OpenMATERIAL 3D.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io::openmaterial {

// Writes a look-up table (`*_brdf.xompt`) according to the public schema of version 1.1.0. The rows are
// sorted. The identifier follows from the values, so that the same table gives the same file. Returns the
// losses, one phrase each: azimuths other than differences, standard deviations, comments, negative values
// (the schema requires values of at least 0) and rows at 90 degrees. Throws InputError if a channel is not
// named by a wavelength, if two channels have the same wavelength, or if no row remains.
// Example:
//     // #include "brdf/io/formats/read.h"
//     brdf::io::SampleTable table = brdf::io::read_samples("paint.csv");
//     for (const std::string& loss : brdf::io::openmaterial::write("paint_brdf.xompt", table))
//       std::printf("lost: %s\n", loss.c_str());
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::openmaterial
