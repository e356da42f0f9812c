// Reads and checks material files.
#pragma once

#include <filesystem>

#include "brdf/material.h"
#include "io/files/content.h"

namespace brdf::io {

// Reads a material's JSON (docs/formats.md). Throws InputError with the file, the JSON path, the value and
// the rule. See io/material/material_json.h for writing, the `fit` block, and materials inside other
// documents.
Material read_material(const std::filesystem::path& path);
Material read_material(const Content& content);

// Throws InputError if parameters are outside the range of their table, if counts are wrong, or if a table
// cannot hold the names of the channels. `where` opens the message.
void check_material(const Material& material, const std::string& where);

}  // namespace brdf::io
