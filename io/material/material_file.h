#pragma once

#include <filesystem>

#include "brdf/material.h"
#include "io/files/content.h"

namespace brdf::io {

// Reads a material's JSON (docs/formats.md). Throws InputError with file, JSON path, value and rule.
// io/material/material_json.h has the rest: writing, the `fit` block, materials inside other documents.
Material read_material(const std::filesystem::path& path);
Material read_material(const Content& content);

// Refuses parameters outside their table's range, wrong counts,
// channel names that a table cannot hold. `where` opens the message.
void check_material(const Material& material, const std::string& where);

}  // namespace brdf::io
