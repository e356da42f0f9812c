// Which channel of a material stands for which of a table's.
#pragma once

#include <string>
#include <vector>

namespace brdf::measured {

// For each of the table's channels the material's of the same name, or else of the same colour; a material of
// one channel stands for all. -1: none.
std::vector<int> counterparts(const std::vector<std::string>& of_table,
                              const std::vector<std::string>& of_material);

}  // namespace brdf::measured
