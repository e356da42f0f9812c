// Detects whether the directions of a measurement could miss a highlight.
#pragma once

#include <optional>

#include "fit/model/data.h"

namespace brdf::fit {

// Returns the width, as Ward's alpha, above which a highlight of weight 0.04 (the reflectance of a
// dielectric at normal incidence) would be visible in the samples. Narrower highlights may lie between the
// samples. Returns std::nullopt if even the narrowest tested width, 1e-4, would be visible.
//
// Uses only the directions and the magnitudes of the values. For each of 14 widths, computes the standard
// error of the weight of such a lobe in a fit of the lobe plus a multiple of the values. The noise is
// proportional to the values (`scatter`, relative; 0.05 if unknown).
std::optional<double> hidden_width(const FitData& data, std::optional<double> scatter);

}  // namespace brdf::fit
