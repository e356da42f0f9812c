// Forms that are compared with traced surfaces.
#pragma once

#include <utility>
#include <vector>

#include "brdf/material.h"
#include "micro/cells.h"
#include "micro/goniometer.h"

namespace brdf::micro {

// Return the form of the catalogue that describes a traced surface, found by its properties. Throw
// std::invalid_argument if the catalogue has no such form.
Reflectance form_of_rough_mirrors();      // Gaussian slopes, Smith's masking
Reflectance form_of_mirror_grooves();     // V-cavities with the Fresnel reflectance of an index
Reflectance form_of_lambert_grooves();    // facets by their slope angle; linear in the albedo
Reflectance form_with_interreflection();  // the same, not linear in the albedo: light is reflected twice

// Returns one channel of a form with the given values, identified by role. Roles that the form does not
// have are ignored; one list can thus serve several forms.
Material model(const Reflectance& form, const std::vector<std::pair<Role, double>>& values);

// Returns f_r in 1/sr between two directions.
double value(const Material& material, const Vec& wi, const Vec& wo);

// Returns the mean f_r over the cell, weighted by cos theta, for comparison with measure_scatter. Azimuths
// of cells are measured from `from.phi`. Midpoint rule with 8 x 8 points of equal projected solid angle.
double cell_mean(const Material& material, const Incidence& from, const Cell& cell);

}  // namespace brdf::micro
