// The questions that are answered by evaluating kernels. Other questions (batches, fits, frames) have
// measurements of their own in evaluations.h, fits.h and frames.h.
#pragma once

#include "trade/measure/question.h"

namespace brdf::trade {

std::vector<Question> precision_questions();  // double, float, half; own kernels against the C library
std::vector<Question> fresnel_questions();
std::vector<Question> masking_questions();
std::vector<Question> lobe_questions();      // powers, Gaussians, mirror or half vector, naive GGX
std::vector<Question> lookup_questions();    // the lookup texture
std::vector<Question> albedo_questions();    // tables and fits
std::vector<Question> integral_questions();  // integrators; masking judged by the resulting albedo

}  // namespace brdf::trade
