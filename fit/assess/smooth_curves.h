// Shapes that are smooth over wavelength, as polynomials with their uncertainty.
#pragma once

#include <span>
#include <vector>

#include "fit/assess/propagation.h"

namespace brdf::fit {

// Returns the coefficients of every shape that is smooth over wavelength, with their standard errors.
std::vector<SmoothCurve> smooth_curves(const Model& model, std::span<const double> p,
                                       const RowMatrix& covariance);

}  // namespace brdf::fit
