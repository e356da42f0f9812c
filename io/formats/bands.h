// The common end of readers of the long format of other programs.
#pragma once

#include <vector>

#include "io/csv/long_format.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Returns the samples of `narrow` with one channel for each band. Directions that lack a band are left out
// with a warning. Throws InputError if no direction has all bands.
SampleTable all_bands(SampleTable narrow, std::vector<Band> bands);

// Returns a wavelength in nm, rounded to the picometre and without the noise of a conversion.
double wavelength_in_nm(double metres);

}  // namespace brdf::io
