// The programs of a function in float, in double and in half precision.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "shader/function.h"
#include "shader/program/lower.h"

namespace brdf::shader {

// Sets the programs of the function for float and for the other scalars. `kernels`: the functions
// that are the library's (shader/kernels.h). `lower` flattens the function. Returns a function with the
// program that rounds every value that has or may have 16 bits; null if the function has no such values.
std::shared_ptr<Function> set_programs(Function& function, LowerOptions options,
                                       const std::set<spirv::Id>& kernels,
                                       const std::function<Program(const LowerOptions&)>& lower);

// Returns f_r of one component in 1/sr at directions that are rounded to float, with every value that has or
// may have 16 bits rounded to half precision. `values` are the values of all parameters in order. Throws
// InputError if a loop does not end in half precision. Precondition: function.in_half is not null.
double in_half(const Function& function, std::span<const double> values, const Vec3<double>& wi,
               const Vec3<double>& wo, std::size_t component);

// Returns a note on the values of 16 bits, if there are any. `in_half`: of set_programs(). `word`: the type
// of 16 bits in the text after the preprocessor; empty if the text has no such type.
std::string said_of_half(const Function& function, const Function* in_half, const std::string& word);

}  // namespace brdf::shader
