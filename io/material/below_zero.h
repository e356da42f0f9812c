// Materials whose weights of either sign make f negative.
#pragma once

#include <string>

#include "brdf/material.h"

namespace brdf::io {

// Throws InputError that begins with `name` if f of the material is below 0 for some pair of directions at
// which a matt basis of the material has its least value. Pictures, instruments and other programs take
// f >= 0 for granted.
void require_not_below_zero(const Material& material, const std::string& name);

}  // namespace brdf::io
