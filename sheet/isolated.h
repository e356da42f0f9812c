// Finds small groups of rows that agree with each other and with no other row. Their agreement is no
// evidence: each row of the group is a neighbour of the others.
#pragma once

#include <span>
#include <vector>

#include "sheet/view.h"

namespace brdf::sheet {

// The rows near each row, by another measure than View::near().
using NearRows = std::span<const std::vector<Row>>;

// Returns the rows of groups of two to five rows that no row outside the group comes near: all rows around
// the group, of View::near() and of `others`, differ from its rows by more than a factor of five and by more
// than `least` (1/sr), and lie on one side of its values. A narrow highlight is such a group, too; groups are
// therefore left out if one of their rows is nearer to the mirror direction, or to the light, than all rows
// around. Values of 0 or less form no group.
std::vector<Row> isolated_rows(const View& view, const std::vector<double>& values, NearRows others,
                               double least);

}  // namespace brdf::sheet
