// The comparisons of one evaluation of a shader, and how far each is from its other outcome.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "shader/function.h"

namespace brdf::shader {

// A comparison of two numbers that was executed. min, max, step and smoothstep compare, too.
struct MetComparison {
  std::uint32_t number;  // of the comparison in the program
  std::uint32_t line;    // of the source, starting at 1; 0: unknown
  bool holds;
  double surplus;  // above 0 where it holds, below 0 where it does not, 0 at the boundary; NaN: unknown
};

// Calls look() for each comparison of one evaluation in double, in their order. `values` are the values of
// all parameters in order; the directions are unit vectors above the horizon. Throws EndlessLoop.
void for_each_comparison(const Function& function, std::span<const double> values, const Vec3<double>& wi,
                         const Vec3<double>& wo, const std::function<void(const MetComparison&)>& look);

}  // namespace brdf::shader
