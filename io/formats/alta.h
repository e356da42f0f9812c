// Tables of the ALTA library (Belcour, Pacanowski, Barla et al., Inria): text with a header of `#KEY value`.
#pragma once

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io::alta {

// Whether the text begins with such a header: #DIM and #PARAM_IN.
bool recognises(const Content& text);

// f_r at the table's directions, whatever angles it names them by. Values times the outgoing cosine
// (INV_STERADIAN_COSINE_FACTOR) are divided by it; rows below the horizon are left out and counted, vertical
// segments (#VS) are left out. Throws InputError for binary tables, for parametrisations that do not give
// both directions and for other quantities.
// `supplied` may say nothing else of values and azimuths than the format does.
SampleTable read(const Content& text, const Supplied& supplied = {});

}  // namespace brdf::io::alta
