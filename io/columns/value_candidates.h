// The columns that may hold values, ranked by their names and by the columns beside them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/columns/column_names.h"
#include "io/columns/quantities.h"

namespace brdf::io {

struct ValueCandidate {
  enum class Rank {
    values,   // values of a quantity that is converted
    neutral,  // the name states no quantity
    asked,    // the name is ambiguous
    refused,  // values of a quantity that cannot be converted to f_r
    aside     // no values
  };
  Column* column;
  NamedQuantity named;
  Rank rank;
  std::string refusal;      // for `asked` and `refused`: the end of a sentence about the column
  bool is_perhaps = false;  // values only if no other column holds any
  bool is_derived = false;  // accompanies values, and is set aside beside them
};

// Returns whether a candidate has the rank.
bool any(const std::vector<ValueCandidate>& candidates, ValueCandidate::Rank rank);

// Returns the candidate for column k of the header. The candidate refers to the column.
ValueCandidate candidate_of(Columns& header, std::size_t k, const HeaderFacts& facts);

// Adjusts the ranks of names that depend on the other columns: texts, seconds, tristimulus values, colour
// coordinates, Mueller matrices and Stokes vectors. Adds the assumptions to the header, and the places of a
// Mueller matrix. `is_format`: the columns are those of a file format, which has no colours.
void rank_by_neighbours(std::vector<ValueCandidate>& candidates, Columns& header, bool is_format);

}  // namespace brdf::io
