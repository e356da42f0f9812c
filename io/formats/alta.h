// Reads tables of the ALTA library (Belcour, Pacanowski, Barla et al., Inria): text with a header of
// `#KEY value` lines.
#pragma once

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::alta {

// Returns whether the text begins with an ALTA header, that is, with #DIM and #PARAM_IN.
bool recognises(const Content& text);

// Reads f_r at the table's directions, for every parametrisation of the angles that gives both directions.
// Values that include the outgoing cosine (INV_STERADIAN_COSINE_FACTOR) are divided by this cosine. Rows
// below the horizon are left out and counted; vertical segments (#VS) are left out. `supplied` must agree
// with the format about values and azimuths. Throws InputError for a disagreement, for binary tables, for
// other parametrisations, and for other quantities.
SampleTable read(const Content& text, const Supplied& supplied = {});

}  // namespace brdf::io::alta
