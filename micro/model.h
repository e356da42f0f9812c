// Forms to hold against traced surfaces.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "brdf/material.h"
#include "micro/cells.h"
#include "micro/goniometer.h"

namespace brdf::micro {

/// One channel of a form of the catalogue with the given parameters; those that it does not have are ignored,
/// so that one list serves several forms. `form` must be in the catalogue.
Material model(std::string_view form, const std::vector<std::pair<std::string_view, double>>& parameters);

/// f_r in 1/sr between two directions.
double value(const Material& material, const Vec& wi, const Vec& wo);

/// Mean f_r over the cell weighted by cos theta, as measure_scatter measures it; azimuths of cells count from
/// `from.phi`. Midpoint rule, 8 x 8 points of equal projected solid angle.
double cell_mean(const Material& material, const Incidence& from, const Cell& cell);

}  // namespace brdf::micro
