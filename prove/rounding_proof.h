// Rounding errors of a form's lobes as a proof.
#pragma once

#include "prove/proof.h"

namespace brdf::prove {

// Fills in what is proved of p's form and precision on p.domain, by the search that p's options allow.
void prove_rounding(Proof& p, const SearchOptions& search);

}  // namespace brdf::prove
