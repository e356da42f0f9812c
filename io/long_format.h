// The long format of spectra: one row for each wavelength of each pair of directions.
#pragma once

#include <vector>

#include "io/samples.h"

namespace brdf::io {

// The same samples with a channel for each wavelength (in nm, one for each row of `narrow`, whose one channel holds
// the values): `465nm`, sorted, the pairs of directions in the order of their first rows. A table of mere directions
// keeps each pair once. Throws InputError where a pair lacks a wavelength or has one twice, naming the row.
SampleTable widened(const SampleTable& narrow, const std::vector<double>& wavelengths);

}  // namespace brdf::io
