// Targets: the reflectances that other programs compute, for fits and exports in their own formula.
//
// A target is a form in everything but its place: it stands in no list of forms (`fit --form all`, the checks
// of all forms), because it is another program's choice, not a model of ours. It is found by its name as a
// form is (find_form), evaluated, fitted, drawn and written to material files. Each header of brdf/targets/
// cites the file and the snapshot it was read from; tests/libbrdf/targets_test.cpp holds the same lines a
// second time.
#pragma once

#include <span>

#include "brdf/reflectance.h"

namespace brdf {

// All of them, those of one program together.
std::span<const Reflectance> targets();

}  // namespace brdf
