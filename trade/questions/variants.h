// Cheaper variants of the reference form: the ledger's approximations inside a whole model, which can be
// fitted like a form.
#pragma once

#include <optional>

#include "brdf/material.h"
#include "trade/measure/question.h"
#include "trade/questions/names.h"

namespace brdf::trade {

// Returns a question for every whole model with one factor replaced, compared with the model itself in cost
// and error.
std::vector<Question> variant_questions();

// Returns a reflectance outside the catalogue, with one width, and without f0 if the variant has no Fresnel
// term.
const Reflectance& variant_form(Variant variant);
std::optional<Variant> find_variant(const Reflectance& reflectance);

// Returns the reference form with a variant's parameters. Lobes that the variant lacks get the weight 0.
Material in_reference_form(const Material& variant);

}  // namespace brdf::trade
