// Optional changes to a table before it is used: the choice of a polarisation and the average of repeats.
#pragma once

#include "io/columns/supplied.h"
#include "io/samples/polarisation.h"
#include "io/samples/repeats.h"

namespace brdf::io {

struct Arrangement {
  Polarisation polarisation = Polarisation::keep;
  Repeats repeats = Repeats::keep;

  bool operator==(const Arrangement&) const = default;
};

// Returns `supplied` with a request for polarised channels if the arrangement chooses a polarisation.
Supplied supplied_for(Supplied supplied, const Arrangement& asked);

// Applies the requested changes, first to the channels and then to the rows, and adds them to the table's
// warnings. Throws InputError as choose_polarisation() and check_table() do.
void arrange(SampleTable& table, const Arrangement& asked);

}  // namespace brdf::io
