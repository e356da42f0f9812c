// Checks of code that is not ours, and which finding voids which.
#pragma once

#include <span>
#include <string_view>

#include "validate/form/checks.h"

namespace brdf::validate {

// How the statement of a finding begins that would hold of any function that is 0.
inline constexpr std::string_view kVacuous = "vacuous: ";

// f and f cos are finite numbers. Pairs inside the hemisphere, where directions coincide, and at the exact
// horizon are told apart, with their shares and the lines of the source; the horizon alone does not fail.
// `share` is the share inside. A function that is 0 everywhere is undecided: whatever it is asked holds.
Finding check_outside_finite(const Subject& subject, const CheckOptions& options);

// Which finding voids which, of one outside subject. A value below 0 that any check met fails non_negative. A
// failure whose witness is undefined is undecided; where pairs of a positive share are undefined so is what
// passed. Where values are not finite at a positive share of the pairs, energy, albedo, derivatives and
// sampling are undecided. Of a function that is 0 everything that passed is.
void apply_voids(const Subject& subject, std::span<Finding> findings);

}  // namespace brdf::validate
