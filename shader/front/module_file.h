// SPIR-V files: shaders that another compiler has compiled, from any language.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "shader/front/glslang.h"

namespace brdf::shader {

inline constexpr std::size_t kLargestModule = 1u << 22;  // bytes

// Returns whether these bytes begin as a SPIR-V module, in either order of bytes.
bool is_module(std::string_view bytes);
// Returns the words of a module in this machine's order of bytes. `name`: of the file, for messages. Throws
// InputError if the bytes are no whole words, or more than kLargestModule.
std::vector<std::uint32_t> module_words(const std::string& name, std::string_view bytes);

// Checks source.module by the rules of the SPIR-V specification (SPIRV-Tools). The parser of
// shader/spirv/module.h relies on no rule, but a module that breaks them has no meaning. Use it with
// compile(), so that it runs in a process of its own. If the library is missing, the module is taken
// unchecked, and the note says so.
Translated checked_module(const Source& source, Places places = Places::scopes);

}  // namespace brdf::shader
