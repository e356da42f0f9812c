// What is made of a table before it is used, where somebody asks for it.
#pragma once

#include "io/samples/polarisation.h"
#include "io/samples/repeats.h"

namespace brdf::io {

struct Arrangement {
  Polarisation polarisation = Polarisation::keep;
  Repeats repeats = Repeats::keep;

  bool operator==(const Arrangement&) const = default;
};

// First the channels, then the rows. What was done stands in the table's warnings. Throws InputError as
// choose_polarisation does.
void arrange(SampleTable& table, const Arrangement& asked);

}  // namespace brdf::io
