// Cheaper variants of the reference form: the ledger's approximations inside a whole model, fitted like one.
#pragma once

#include <optional>

#include "brdf/material.h"
#include "trade/measure/question.h"
#include "trade/questions/names.h"

namespace brdf::trade {

// Every whole model with one factor replaced, against the model itself: costs and errors.
std::vector<Question> variant_questions();

// A reflectance that is not in the catalogue: one width, and no f0 where there is no Fresnel term.
const Reflectance& variant_form(Variant variant);
std::optional<Variant> find_variant(const Reflectance& reflectance);

// The reference form with a variant's parameters: lobes that the variant lacks get no weight.
Material in_reference_form(const Material& variant);

}  // namespace brdf::trade
