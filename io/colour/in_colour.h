// Converts spectral tables and materials to red, green and blue for pictures.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Returns whether the channels are a spectrum of visible light. All must be named by a wavelength
// (wavelength_of), with four or more between 380 and 780 nm, from 480 nm or less to 620 nm or more.
bool is_spectrum(const std::vector<std::string>& channels);

// Returns the table with channels r, g, b in linear sRGB under D65, each a sum over the bands
// (srgb_weights). A table that is not a spectrum is returned unchanged. Bands are
// assumed to have independent errors; the result has standard deviations only if all bands have them.
SampleTable in_colour(SampleTable table);
// Returns the material with channels r, g, b in the same way. If the bands share their shape, its f_r is
// exactly the sum of the f_r of the bands: the weights are added, and f0 is averaged with the weight that
// it multiplies. If every band has its own shape, the shape of a colour is the mean of these shapes with
// the weights of the bands. A sum outside the range of a parameter (a colour outside the gamut of sRGB) is
// clamped to the range. Throws InputError for a form that mixes its channels or cannot be fitted.
Material in_colour(const Material& material);

}  // namespace brdf::io
