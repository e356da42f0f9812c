// Writes matrices of LBNL Window and Radiance (XML).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io::klems {

// Writes the values as matrices in a Klems basis, according to BSDF-v1.7.7.xsd of LBNL. The directions must
// be the centres of all pairs of patches of a known basis (klems_bases.h) within 1e-6 degrees, and the values
// count as means over the patches. The same matrix is written for `Reflection Front` and `Reflection Back`:
// the back is the mirror image of the front. Transmission is not written.
//
// Bands are written for their wavelengths. `Visible`, which Radiance reads, holds the only channel if its
// name has no wavelength, the luminance of r, g, b or of X, Y, Z, or the luminance of a spectrum under D65.
// Returns the losses, one phrase each. Throws InputError for other directions, for pairs that are missing or
// repeated, and for other channels.
// Example:
//     // #include "brdf/io/formats/read.h"
//     brdf::io::SampleTable table = brdf::io::read_samples("window.xml");
//     for (const std::string& loss : brdf::io::klems::write("copy.xml", table))
//       std::printf("lost: %s\n", loss.c_str());
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::klems
