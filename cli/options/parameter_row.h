// A row of materials that differ in one parameter.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "brdf/material.h"

namespace brdf::cli {

// Returns the material at `count` values of one parameter, from "NAME=FIRST:LAST", each with a label ("alpha
// 0.05"). The values are spaced evenly between the two, on a logarithmic scale if the parameter has one and
// both values are above 0. A whole-number parameter takes each value once. Throws InputError.
std::vector<std::pair<std::string, Material>> parameter_row(const Material& material,
                                                            const std::string& range, int count);

}  // namespace brdf::cli
