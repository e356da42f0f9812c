// The formulas as a C++17 header in float.
#pragma once

#include <string>

#include "brdf/material.h"

namespace brdf::io {

// The library's float values, with own kernels bit for bit where contraction is off (-ffp-contract=off). The
// header refuses
// -ffast-math and its like where a macro tells, and keeps the arithmetic as it is written where none does.
// The forms' functions, and with `with_material` brdf_material(wi, wo), stand in a namespace of this name
// (io/files/identifier.h); vec3 and the kernels in one that several headers share.
std::string cpp_text(const Material& material, bool with_material, const std::string& name,
                     bool builtin_kernels);

}  // namespace brdf::io
