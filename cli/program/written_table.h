// Writes lookup tables of albedos and of linearly transformed cosines as images.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/files/json.h"

namespace brdf::cli {

// Values of `export --to` that write a lookup table.
inline constexpr std::string_view kTables[] = {"dfg", "albedo", "ltc"};
bool is_lookup_table(std::string_view to);

// What was written, in sentences and as JSON.
struct WrittenTable {
  std::vector<std::string> sentences;
  io::Json json;
  std::size_t not_converged = 0;  // texels with integrals that did not converge
};

// Computes the table `to` of the material and writes it to `path`. An OpenEXR image has 16-bit floats if the
// layout's program holds these, and otherwise 32-bit floats, with the sentences on the table as attributes. A
// PNG is written for layouts of 8 bits. dfg and albedo have the layout of this name and the channels R and G;
// ltc has the layout of its only source, RGBA for the matrix and two further channels for the albedo.
// Throws InputError if the path ends in another suffix, if this build has no OpenEXR, and for materials that
// the table cannot hold.
WrittenTable write_lookup_table(std::string_view to, const Material& material, std::string_view layout,
                                const std::string& path);

}  // namespace brdf::cli
