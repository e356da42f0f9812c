// The outcome of a check is one notion for forms, materials and tables (sheet/finding.h); here are its names
// in this room.
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
