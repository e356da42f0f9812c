// Spectral tables and materials as a picture shows them.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Whether these channels are a spectrum of visible light: all are named by a wavelength (wavelength_of), four
// or more of them between 380 and 780 nm, reaching from 480 nm or less to 620 nm or more.
bool is_spectrum(const std::vector<std::string>& channels);

// The same with channels r, g, b in linear sRGB under D65, each a sum over the bands (srgb_weights); what is
// no spectrum stays as it is.
//
// A table's standard deviations add up as those of independent bands.
SampleTable in_colour(SampleTable table);
// A material's f_r is the sum of its bands' f_r, exactly, where the bands share their shape: its weights add
// up, and f0 with the weight that it divides. Where every band has a shape of its own, a colour's is their
// mean, weighted like the bands. A sum outside of a parameter's range (a colour that sRGB does not hold) is
// brought to its end. Throws InputError for a form that mixes its channels.
Material in_colour(const Material& material);

}  // namespace brdf::io
