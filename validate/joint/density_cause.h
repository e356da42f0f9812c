// Causes of a wrong density, from its ratios to the true one.
#pragma once

#include <span>
#include <string>

#include "validate/joint/jacobian.h"

namespace brdf::validate {

// Returns the cause of a wrong density, as a clause that follows "the density": a density of another measure,
// a constant factor, wrong probabilities of the lobes, another width, exchanged axes or directions. Empty if
// no known cause explains 95 % of the rows to 0.02 %, or if there are fewer than 6 rows.
std::string cause_of(const Trio& trio, std::span<const DensityRow> rows);

}  // namespace brdf::validate
