// Proves the rounding errors of a form's lobes.
#pragma once

#include "prove/proof.h"

namespace brdf::prove {

// Fills in the proved errors for the form and precision of p on p.domain, by a search within these limits.
void prove_rounding(Proof& p, const SearchOptions& search);

}  // namespace brdf::prove
