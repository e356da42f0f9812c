// Recognises JSON of other programs by its keys.
#pragma once

#include <string>

#include "io/files/content.h"

namespace brdf::io {

// How to export tables from another program, as the end of an advice.
inline constexpr std::string_view kExportAsCsv =
    "export columns theta_i, phi_i, theta_o, phi_o and the value as CSV";

// Formats of JSON in which other programs keep tables of samples.
enum class JsonTable {
  absent,
  openmaterial,           // BRDF values
  openmaterial_ratios,    // ratios of amplitudes
  openmaterial_material,  // refractive indices, permittivities, or a whole material
  bird,
  early_bird,
  unknown
};
// Returns the format of a JSON text according to its keys. `unknown`: keys of directions without a known
// format. `absent`: the text is not JSON or has no such keys.
JsonTable json_table(const Content& content);

// Returns whether the text is JSON other than a table of samples of another program. Verbs that accept
// materials and samples read such a file as a material.
bool may_be_material(const Content& content);

// Describes a JSON text of another program with advice, as the end of a sentence about the file; empty if
// no keys of a table of samples are found.
std::string foreign_json(const Content& content);

}  // namespace brdf::io
