// The materials that questions are about.
#pragma once

#include "brdf/material.h"

namespace brdf::trade {

// A form that questions need, by its name; throws InputError where the catalogue lacks it.
Reflectance named_form(std::string_view name);
// What others are compared with.
Reflectance reference_form();

// Every parameter of this role, in all channels; for a width or an exponent those across the tangent too.
void set_parameter(Material& material, Role role, double value);

// "cook_torrance, alpha 0.1, kd 0.2": the form of the only term with the first channel's values.
std::string described(const Material& material);

}  // namespace brdf::trade
