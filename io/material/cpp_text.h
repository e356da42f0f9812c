// Writes the formulas as a C++17 header in float.
#pragma once

#include <string>

#include "brdf/material.h"

namespace brdf::io {

// Returns a header that computes the library's float values. With the library's kernels the values are
// bit-identical if contraction is off (-ffp-contract=off). The header refuses -ffast-math and similar
// options if a macro reveals them; otherwise the header itself disables reassociation. The namespace `name`
// (io/files/identifier.h) holds the functions of the forms, and brdf_material(wi, wo) if `with_material`.
// vec3 and the kernels are in a namespace that several headers share. `builtin_kernels`: use the standard
// functions instead of the library's kernels.
std::string cpp_text(const Material& material, bool with_material, const std::string& name,
                     bool builtin_kernels);

}  // namespace brdf::io
