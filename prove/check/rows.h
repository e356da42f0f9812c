// The check of one row of a certificate.
#pragma once

#include <span>

#include "prove/check/certificate.h"

namespace brdf::prove {

// Checks the row of a form, or of a material. Throws InputError if the row is not of this kind. A statement
// that does not hold becomes the fault of the result. Adds the number of leaves to `leaves`.
CheckedResult check_form_row(const io::JsonPlace& row, long& leaves);
CheckedResult check_material_row(const io::JsonPlace& row, std::span<const NamedMaterial> materials,
                                 long& leaves);

// Returns the claim that a row makes about the form at this index of the catalogue. A proof of that claim
// has a certain scalar and arithmetic; other_words() returns the fault if the row states others.
Claim claim_of_row(const io::JsonPlace& row, int form);
std::string other_words(const io::JsonPlace& row, const Claim& claim, std::string_view arithmetic);

}  // namespace brdf::prove
