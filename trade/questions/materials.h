// The materials of the questions.
#pragma once

#include "brdf/material.h"

namespace brdf::trade {

// Returns a form that questions need, by its name. Throws InputError if the catalogue does not have the
// form.
Reflectance named_form(std::string_view name);
// Returns the form with which others are compared.
Reflectance reference_form();

// Sets every parameter of this role, in all channels. For a width or an exponent, also sets the parameter
// across the tangent.
void set_parameter(Material& material, Role role, double value);

// Returns for example "cook_torrance, alpha 0.1, kd 0.2": the form of the only term with the values of the
// first channel.
std::string described(const Material& material);

}  // namespace brdf::trade
