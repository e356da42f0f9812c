// Reads and writes the BSDF data interchange text of a lens-design program (Zemax OpticStudio).
#pragma once

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::zemax {

// Returns whether the first line of the text, apart from comments, is "Source Measured".
bool recognises(const Content& text);

// Reads the reflectance (BRDF) blocks. Directions in the file are polar about the mirror direction, with
// azimuth 0 towards the normal; they are converted to directions about the normal. Entries of 0, which mean
// "not measured", and entries below the horizon are left out; both are counted. The TIS lines are not used
// because they are unreliable in files of this kind. A PlaneSymmetrical file yields only the half that it
// holds. `supplied` must agree with the format about values and azimuths. Throws InputError for a
// disagreement, and if the text breaks the format or holds no measured value.
SampleTable read(const Content& text, const Supplied& supplied = {});

// Writes a table with directions on a grid about the mirror direction, for example a scan in the plane of
// incidence or a table that was read from such a file. The table has one channel, or X, Y and Z. If all
// rows have the same phi_i, the table is written as sample rotation 0. Entries without a row are 0. The TIS
// of each block is the trapezoidal sum of f_r cos_o over the grid. Returns the losses, one phrase each.
// Throws InputError for other channels, if two rows belong to the same entry, and if more than seven of
// eight entries would be empty.
// Example:
//     // #include "brdf/io/formats/read.h"
//     const brdf::io::SampleTable table = brdf::io::read_samples("in_plane.csv");
//     for (const std::string& loss : brdf::io::zemax::write("in_plane.zemax", table))
//       std::printf("lost: %s\n", loss.c_str());
//     const auto again = brdf::io::zemax::read(brdf::io::read_content("in_plane.zemax"), {});
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::zemax
