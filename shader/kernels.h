// The library's kernels in exported shaders.
#pragma once

#include <set>

#include "shader/spirv/module.h"

namespace brdf::shader {

// Returns the functions of the module that are kernels of the library: a function with a kernel's name, and
// with the operations that the kernel has in a text which this version exports (io/material/glsl.h). A
// function of the same name with other operations is taken as it is written.
std::set<spirv::Id> library_kernels(const spirv::Module& module);

}  // namespace brdf::shader
