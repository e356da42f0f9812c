#pragma once

#include <string>
#include <utility>
#include <vector>

#include "brdf/material.h"

namespace brdf::cli {

// The material at `count` values of one parameter, from "NAME=FIRST:LAST", each with a label ("alpha 0.05"):
// evenly between the two, on a logarithmic scale where the parameter's is one and both are above 0. Throws
// InputError.
std::vector<std::pair<std::string, Material>> parameter_row(const Material& material,
                                                            const std::string& range, int count);

}  // namespace brdf::cli
