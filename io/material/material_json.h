#pragma once

#include "io/files/content.h"
#include "io/files/json.h"
#include "io/material/material_file.h"

namespace brdf::io {

// A material with the provenance and statistics of the fit it came from (null where there are none), what
// people call it and where its numbers come from (empty where the file does not say).
struct MaterialFile {
  Material material;
  Json fit;
  std::string name{}, source{};
};

MaterialFile read_material_file(const std::filesystem::path& path);
MaterialFile read_material_file(const Content& content);
void write_material_file(const std::filesystem::path& path, const MaterialFile& file);

// A material inside another document, for instance a scene's object.
MaterialFile material_from_json(const JsonPlace& place);

// File, memory, file gives the same text, and memory, file, memory the same values; only tangent_phi, degrees
// in the file and radians in memory, may differ from a computed value in its last bit.
Json to_json(const Material& material);
Json to_json(const MaterialFile& file);

}  // namespace brdf::io
