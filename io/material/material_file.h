// Reads and checks material files.
#pragma once

#include <filesystem>

#include "brdf/material.h"
#include "io/files/content.h"

namespace brdf::io {

// Reads a material's JSON (docs/formats.md). Throws InputError with the file, the JSON path, the value and
// the rule. See io/material/material_json.h for writing, the `fit` block, and materials inside other
// documents.
// Example:
//     const brdf::Material copper = brdf::io::read_material("copper.json");
//     const auto up = direction(brdf::degrees(0), brdf::degrees(0));
//     std::vector<double> f_r(copper.channels.size());
//     eval(copper, up, up, f_r);
Material read_material(const std::filesystem::path& path);
Material read_material(const Content& content);

// Throws InputError if parameters are outside the range of their table, if counts are wrong, or if a table
// cannot hold the names of the channels. `where` opens the message.
void check_material(const Material& material, const std::string& where);

}  // namespace brdf::io
