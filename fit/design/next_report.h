// Reports of the directions to measure next: text, JSON, and a table for the instrument.
#pragma once

#include <iosfwd>

#include "fit/design/next_directions.h"
#include "io/files/json.h"

namespace brdf::fit {

// The names of the two files in texts.
struct NextSources {
  std::string samples, reach;
};

// Prints the assumptions, the rows in the order of the choice, and what they are expected to reach.
void print(std::ostream& out, const NextDirections& next, const NextSources& sources);
// Returns the JSON of `brdf next --json` (docs/next.schema.json).
io::Json to_json(const NextDirections& next, const NextSources& sources);
// Returns the chosen rows, in their order, as a table of directions without values.
io::SampleTable table_of(const NextDirections& next);

}  // namespace brdf::fit
