// Do two integrals of the same thing ever lie further apart than both of their error bounds allow?
#pragma once

#include <cstdint>
#include <functional>

#include "validate/numerics/integrators.h"

namespace brdf::validate {

// One row per form of the catalogue, "bounds_FORM": random parameters (a third of them ends of their ranges
// or equal widths, the weights the table's own in every other case), directions and azimuths, the light or
// the viewer fixed. Each case is integrated by every rule to 1e-6 and by the default rule to 1e-4, 1e-6 and
// 1e-12, and every two of the results are compared. `cases` counts the pairs, at least `pairs` over all
// forms; `wrong` those that lie apart; `unconverged` the results that said so: their bounds are estimates,
// and they are left out (but those at 1e-12, where rounding alone may stand in the way).
std::vector<IntegratorRow> check_bounds(std::uint64_t seed, std::size_t pairs,
                                        const std::function<void(const IntegratorRow&)>& progress = {});

}  // namespace brdf::validate
