// A shader's value in more digits than double has: what is the model's, and what its arithmetic's.
#pragma once

#include <span>

#include "shader/function.h"

namespace brdf::shader {

// f_r in 1/sr of one component by the processor's extended type (64 bits of mantissa on x86-64), rounded to
// double at the end, for the unit directions that these vectors stand for; `values` are those of all
// parameters in order. Errors of rounding are about two thousand times smaller than those of double. Throws
// EndlessLoop.
double in_more_digits(const Function& function, std::span<const double> values, const Vec3<double>& wi,
                      const Vec3<double>& wo, std::size_t component);

// False where the processor has no such type: then in_more_digits is no better than double.
bool has_more_digits();

}  // namespace brdf::shader
