// Writes lookup tables of directional albedos as OpenEXR images.
#pragma once

#include <string>

#include "interop/lookup_table.h"

namespace brdf::cli {

// Writes the table to `path` as 32-bit float, with two channels R and G, and with the sentences on the table
// as attributes. Throws InputError if this build has no OpenEXR.
void write_lookup_table(const std::string& path, const interop::LookupTable& table);

}  // namespace brdf::cli
