// The BSDF data interchange text of a lens-design program (Zemax OpticStudio).
#pragma once

#include "io/samples.h"

namespace brdf::io::zemax {

bool recognises(const Content& text);

// Reads the reflectance (BRDF) blocks. Directions in the file are polar about the mirror direction, azimuth 0
// towards the normal; they are turned to the normal. Entries of 0 mean "not measured" and those below the
// horizon are left out; both are counted. The TIS lines are not used: in files of this kind they are
// unreliable. Only the half that a PlaneSymmetrical file holds is given.
SampleTable read(const Content& text);

}  // namespace brdf::io::zemax
