// The questions that are answered by evaluating kernels. The others (integrals, fits, frames) have their own
// measurements in integrals.h, fits.h and frames.h.
#pragma once

#include "trade/question.h"

namespace brdf::trade {

std::vector<Question> precision_questions();  // double, float, half; own kernels against the C library
std::vector<Question> fresnel_questions();
std::vector<Question> masking_questions();
std::vector<Question> lobe_questions();    // powers, Gaussians, mirror or half vector, naive GGX
std::vector<Question> lookup_questions();  // the lookup texture
std::vector<Question> albedo_questions();  // tables, fits and integrators

}  // namespace brdf::trade
