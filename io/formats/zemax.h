// The BSDF data interchange text of a lens-design program (Zemax OpticStudio).
#pragma once

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::zemax {

bool recognises(const Content& text);

// Reads the reflectance (BRDF) blocks. Directions in the file are polar about the mirror direction, azimuth 0
// towards the normal; they are turned to the normal. Entries of 0 mean "not measured" and those below the
// horizon are left out; both are counted. The TIS lines are not used: in files of this kind they are
// unreliable. Only the half that a PlaneSymmetrical file holds is given.
// `supplied` may say nothing else of values and azimuths than the format does.
SampleTable read(const Content& text, const Supplied& supplied = {});

// Writes a table whose directions lie on a grid round the mirror direction (a scan in the plane of incidence
// does, and what was read from such a file): one channel, or X, Y and Z. Where all rows have one phi_i it is
// written as sample rotation 0; entries that no row has are 0. Each block's TIS is the trapezoidal sum of f_r
// cos_o over its grid. Returns what is lost, one phrase each. Throws InputError where the channels are
// others, two rows are one entry, or more than seven of eight entries would be empty.
std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io::zemax
