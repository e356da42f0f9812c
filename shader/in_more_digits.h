// Evaluates a shader with more digits than double has, to separate properties of the model from errors of
// its arithmetic.
#pragma once

#include <span>

#include "shader/function.h"

namespace brdf::shader {

// Returns f_r of one component in 1/sr, computed with the processor's extended type (64 bits of mantissa on
// x86-64) and rounded to double at the end, for the unit directions that these vectors represent. `values`
// are the values of all parameters in order. Rounding errors are about two thousand times smaller than in
// double. Throws EndlessLoop.
double in_more_digits(const Function& function, std::span<const double> values, const Vec3<double>& wi,
                      const Vec3<double>& wo, std::size_t component);

}  // namespace brdf::shader
