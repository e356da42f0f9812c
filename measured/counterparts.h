// Assigns the channels of a material to the channels of a table.
#pragma once

#include <string>
#include <vector>

namespace brdf::measured {

// Returns, for each channel of the table, the index of the material's channel of the same name, or else of
// the same colour. A material with one channel serves all. -1 means that there is no counterpart.
std::vector<int> counterparts(const std::vector<std::string>& of_table,
                              const std::vector<std::string>& of_material);

}  // namespace brdf::measured
