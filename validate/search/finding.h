// Brings the names of sheet/finding.h into this room. Forms, materials and tables share one notion of a
// check's outcome.
#pragma once

#include "sheet/finding.h"

namespace brdf::validate {

using sheet::Finding;
using sheet::is_worst;
using sheet::NamedRow;
using sheet::not_applicable;
using sheet::Outcome;
using sheet::Restricted;
using sheet::said;
using sheet::shows_witness;
using sheet::Witness;

}  // namespace brdf::validate
