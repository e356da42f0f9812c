// Reads and writes materials as JSON, with the facts that a material file adds.
#pragma once

#include "io/files/content.h"
#include "io/files/json.h"
#include "io/material/material_file.h"

namespace brdf::io {

// A material with additional facts. `fit` holds the provenance and statistics of the fit that produced the
// material, or null. `name` is the common name and `source` the origin of its numbers; each is empty if the
// file does not give it.
struct MaterialFile {
  Material material;
  Json fit;
  std::string name{}, source{};
};

// Reads a material file, or the selected material of a saved state of `brdf view`. Throws InputError with
// file, JSON path, value and rule.
// Example:
//     brdf::io::MaterialFile file = brdf::io::read_material_file("copper.json");
//     file.name = "dark copper";
//     for (double& weight : file.material.terms.front().weights.front()) weight /= 2;
//     write_material_file("dark_copper.json", file);
MaterialFile read_material_file(const std::filesystem::path& path);
MaterialFile read_material_file(const Content& content);
// Writes a material file. Throws InputError as check_material() does.
void write_material_file(const std::filesystem::path& path, const MaterialFile& file);

// Reads a material inside another document, for instance in an object of a scene.
MaterialFile material_from_json(const JsonPlace& place);

// Converts to JSON. Reading a file and writing it again restores the text; writing a material and reading
// it again restores the values. The only exception is tangent_phi, in degrees in the file and in radians in
// memory: a computed value may change in its last bit.
Json to_json(const Material& material);
Json to_json(const MaterialFile& file);

}  // namespace brdf::io
