// JSON of other programs, recognised by its keys.
#pragma once

#include <string>

#include "io/files/content.h"

namespace brdf::io {

// How another program's tables come to us, as the end of an advice.
inline constexpr std::string_view kExportAsCsv =
    "export columns theta_i, phi_i, theta_o, phi_o and the value as CSV";

// What a JSON text of another program is, by its keys, with the advice on it, as the end of a sentence about
// the file; empty if no keys of a table of samples are found.
std::string foreign_json(const Content& content);

}  // namespace brdf::io
