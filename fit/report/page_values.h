// Fitted values for the pages of a fit.
#pragma once

#include <vector>

#include "brdf/directions.h"
#include "brdf/material.h"

namespace brdf::fit {

// Returns the fitted values, [channel][row], averaged over the detector's field. `aperture`: the full
// width of the field in degrees; 0: no field.
std::vector<std::vector<double>> fitted_values(const Material& material, const Directions<double>& d,
                                               double aperture);

}  // namespace brdf::fit
