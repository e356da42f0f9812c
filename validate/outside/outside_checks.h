// Checks of outside code (code that is not part of the catalogue), and the rules by which one finding voids
// another.
#pragma once

#include <span>
#include <string_view>

#include "validate/search/finding.h"
#include "validate/search/options.h"
#include "validate/search/subject.h"

namespace brdf::validate {

// The beginning of a statement that would hold for any function that is 0 everywhere.
inline constexpr std::string_view kVacuous = "vacuous: ";

// Checks that f and f cos are finite numbers. Pairs inside the hemisphere, pairs with coincident directions
// and pairs at the exact horizon are reported separately, with their shares and the lines of the source.
// Faults at the horizon alone do not fail the check. `share` is the share inside the hemisphere. The
// finding is undecided for a function that is 0 everywhere, since every property holds for such a function.
Finding check_outside_finite(const Subject& subject, const CheckOptions& options);

// Checks that no value depends on behaviour that the shader language leaves undefined. Applies only to
// outside code, that is, code that is not part of the catalogue, such as a user's shader. `share` is the
// share of the pairs inside the hemisphere at which a value is undefined.
Finding check_undefined(const Subject& subject, const CheckOptions& options);
// Checks that float, and half precision if the code has values that may have 16 bits, agree with double of
// the same code. Applies only to outside code.
Finding check_float(const Subject& subject, const CheckOptions& options);

// Applies the rules by which the findings of one outside subject void each other. A value below 0 that any
// check met fails non_negative. A failure becomes undecided if its witness is undefined. If a positive
// share of the pairs is undefined, passed checks become undecided, too. If values are not finite at a
// positive share of the pairs, energy, albedo, derivatives and sampling become undecided if they passed.
// For a function that is 0 everywhere, every passed check becomes undecided.
void apply_voids(const Subject& subject, std::span<Finding> findings);

}  // namespace brdf::validate
