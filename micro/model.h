// Forms to hold against traced surfaces.
#pragma once

#include <utility>
#include <vector>

#include "brdf/material.h"
#include "micro/cells.h"
#include "micro/goniometer.h"

namespace brdf::micro {

// The catalogue's forms for what is traced, found by what they stand for.
Reflectance form_of_rough_mirrors();      // Gaussian slopes, Smith's masking
Reflectance form_of_mirror_grooves();     // V-cavities with the Fresnel reflectance of an index
Reflectance form_of_lambert_grooves();    // facets by their slope angle; linear in the albedo
Reflectance form_with_interreflection();  // the same, not linear in the albedo: light is reflected twice

// One channel of a form with the given values, by role; roles that it does not have are ignored, so that one
// list serves several forms.
Material model(const Reflectance& form, const std::vector<std::pair<Role, double>>& values);

// f_r in 1/sr between two directions.
double value(const Material& material, const Vec& wi, const Vec& wo);

// Mean f_r over the cell weighted by cos theta, as measure_scatter measures it; azimuths of cells count from
// `from.phi`. Midpoint rule, 8 x 8 points of equal projected solid angle.
double cell_mean(const Material& material, const Incidence& from, const Cell& cell);

}  // namespace brdf::micro
