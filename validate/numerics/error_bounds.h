// Checks whether two integrals of the same quantity ever differ by more than the sum of their error bounds.
#pragma once

#include <cstdint>
#include <functional>

#include "validate/numerics/integrators.h"

namespace brdf::validate {

// Returns one row per form of the catalogue, named "bounds_FORM". The cases draw random parameters (about a
// third of them at the ends of their ranges or with equal widths; in every other case on average the
// weights are the table's own), random directions and azimuths, and fix either the light or the viewer.
// Each case is integrated by every rule to 1e-6 and by the default rule to 1e-4, 1e-6 and 1e-12. All pairs
// of these results are compared.
//
// `cases` counts the compared pairs, at least `pairs` over all forms. `wrong` counts the pairs that differ
// by more than the sum of their bounds. `unconverged` counts the results that reported no convergence.
// Their bounds are estimates, so these results are left out, except at 1e-12, where rounding alone may
// prevent convergence.
std::vector<IntegratorRow> check_bounds(std::uint64_t seed, std::size_t pairs,
                                        const std::function<void(const IntegratorRow&)>& progress = {});

}  // namespace brdf::validate
