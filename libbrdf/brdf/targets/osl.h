// Closures of OSL as targets.
#pragma once

#include "brdf/forms/cook_torrance.h"
#include "brdf/forms/oren_nayar.h"
#include "brdf/forms/phong.h"
#include "brdf/forms/ward.h"

namespace brdf {

// Closures of OSL that equal forms of the catalogue value by value, as shaded by OSL's testrender
// (src/testrender/shading.cpp and src/shaders/stdosl.h of OpenShadingLanguage ad63273a).
using osl_microfacet = cook_torrance_dielectric;
using osl_ward = ward;
using osl_phong = phong;
using osl_oren_nayar = oren_nayar;

}  // namespace brdf
