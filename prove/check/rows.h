// One row of a certificate, checked.
#pragma once

#include <span>

#include "prove/check/certificate.h"

namespace brdf::prove {

// Throws InputError where the row is of no such kind; what does not hold is the result's fault. Adds to
// `leaves`.
CheckedResult check_form_row(const io::JsonPlace& row, long& leaves);
CheckedResult check_material_row(const io::JsonPlace& row, std::span<const NamedMaterial> materials,
                                 long& leaves);

// The claim that a row makes of the form at this place of the catalogue; its words for the scalar and the
// numbers must be those of such a proof, else `fault` says so.
Claim claim_of_row(const io::JsonPlace& row, int form);
std::string other_words(const io::JsonPlace& row, const Claim& claim, std::string_view arithmetic);

}  // namespace brdf::prove
