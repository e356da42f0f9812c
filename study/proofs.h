// How the passed checks of a reflectance are known: by a proof or by a search.
#pragma once

#include <vector>

#include "validate/report/report.h"

namespace brdf::study {

// Tries to prove the properties of each subject that the formula itself or a few boxes decide. Sets `proof`
// of each passed finding of a provable property to "proved" or "sampled". The limit is a number of boxes and
// not a time, so that equal inputs give equal words on every machine.
void mark_proofs(const std::vector<validate::Subject>& subjects, std::vector<validate::Finding>& findings);

// The same for the findings of one material, which is not outside code. A program that calls this function
// alone contains no proof of energy or of rounding.
void mark_proofs_of_material(const validate::Subject& material, std::vector<validate::Finding>& findings);

}  // namespace brdf::study
