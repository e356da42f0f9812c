// The rule for numbers that programs write in place of a missing measurement.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// Returns whether a number is certainly a fill value, whatever the quantity: -999 and -9999 with any number
// of nines more (also -999.9 and -999.99), -32768, -1e30, -1e31, -1e34, the default of NetCDF (9.96921e36),
// and the largest 32-bit float.
bool is_fill_value(double number);

// Returns whether a number may be a fill value, but may also be a measurement: a number of nines from 99 on,
// with any sign.
bool may_be_fill_value(double number);

// Throws InputError, with the place and advice, if a value or a standard deviation is a fill value. The
// values must be as in the file: a conversion would hide the numbers.
void refuse_fill_values(const SampleTable& table);

}  // namespace brdf::io
