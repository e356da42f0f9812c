// Writes universal BRDF files of the BiRD project.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io::bird {

// Writes a universal BRDF file (JSON, version 1.0) with one entry for each row and channel. Angles are in
// degrees, azimuths in [0, 360). Standard deviations become `uBRDF` if all channels have them. A stated
// aperture becomes the solid angle of the detection system. Required texts that the table does not state are
// "not stated", and required objects are "NA" or empty; nothing is invented. The identifier follows from the
// values. Comments without a place of their own are kept in `adhoc_section`.
//
// Returns the losses, one phrase each: negative values (the schema requires values of at least 0), rows at 90
// degrees, and standard deviations of some channels only. Throws InputError if a channel is named neither by
// a wavelength nor by a polarisation and is not the only one, if two channels are equal in both, if no value
// remains, or if the file would exceed the largest JSON that is read.
// Example:
//     // #include "brdf/io/formats/read.h"
//     brdf::io::SampleTable table = brdf::io::read_samples("paint.csv");
//     for (const std::string& loss : brdf::io::bird::write("paint.brdf", table))
//       std::printf("lost: %s\n", loss.c_str());
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::bird
