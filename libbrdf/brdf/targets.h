// Targets: the reflectances that other programs compute, for fits and exports in their own formula.
//
// A target is a form in every respect except that no list of forms contains it (`fit --form all`, the
// checks of all forms), because it is the choice of another program and not a model of this library. A
// target is found by its name like a form (find_form), evaluated, fitted, drawn and written to material
// files. Each header of brdf/targets/ cites its source file and snapshot; tests/libbrdf/targets_test.cpp
// contains the same lines a second time.
#pragma once

#include <span>

#include "brdf/reflectance.h"

namespace brdf {

// Returns all targets; the targets of one program are adjacent.
// Example:
//     for (const brdf::Reflectance& target : brdf::targets())
//       if (target.info().family == "blender" && target.info().fittable())
//         std::printf("%s\n", std::string(target.info().name).c_str());
std::span<const Reflectance> targets();

}  // namespace brdf
