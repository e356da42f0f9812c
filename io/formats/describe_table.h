// Proposes a layout (io/columns/layout.h) for a table of text columns.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/files/content.h"
#include "io/files/json.h"
#include "io/samples/samples.h"

namespace brdf::io {

struct TableProposal {
  // The layout, as docs/layout.schema.json defines it. Places that could not be decided are null, and
  // `unsure` has their paths with the reasons, and the paths of guesses.
  Json layout;
  std::optional<SampleTable> alone;  // the table as it is read without a layout; empty if it is refused
  std::string refusal;               // the reason of the refusal
  std::size_t open = 0;              // places that are null
};

// Proposes a layout. If the table is read without a layout, the proposal reads it to the same directions and
// values, and has no null. Throws InputError for files of other formats, for a matrix of two angles and for a
// text without columns of numbers.
TableProposal propose_layout(Content content);

// Adds the numbers that the value columns hold in these lines of the file to the layout's fill values. A
// number is added only if it occurs in at least three of the lines. `lines`: numbers of lines, from 1.
void add_fill(TableProposal& proposal, Content content, const std::vector<std::uint32_t>& lines);

}  // namespace brdf::io
