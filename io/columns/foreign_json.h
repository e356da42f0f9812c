// Recognises JSON of other programs by its keys.
#pragma once

#include <string>

#include "io/files/content.h"

namespace brdf::io {

// How to export tables from another program, as the end of an advice.
inline constexpr std::string_view kExportAsCsv =
    "export columns theta_i, phi_i, theta_o, phi_o and the value as CSV";

// Identifies a JSON text of another program by its keys. Returns the kind of file with advice, as the end
// of a sentence about the file; empty if no keys of a table of samples are found.
std::string foreign_json(const Content& content);

}  // namespace brdf::io
