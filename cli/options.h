#pragma once

#include <string>
#include <vector>

#include "cli/parameters.h"

namespace CLI {
class App;
}

namespace brdf::cli {

// Adds --form, --material and --set, the same in every verb that takes one material.
void add_material_options(CLI::App& verb, MaterialChoice& choice);

// Adds an option that may be repeated and takes one word
// each time (so that a file after it is not swallowed).
void add_repeated_option(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                         const std::string& description);

}  // namespace brdf::cli
