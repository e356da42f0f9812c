// What a shader's author says of it in lines that begin with //: and in BRDF Explorer's blocks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "shader/front/source.h"

namespace brdf::shader {

// "param NAME MIN MAX DEFAULT [log] [role R]", "bool NAME 0|1", "color NAME r g b", the last two also as
// "param NAME bool 0|1" and "param NAME color r g b", and BRDF Explorer's "float NAME MIN MAX DEFAULT";
// `words` follow the kind. Throws InputError that begins with `where`.
Declared read_declared(std::string_view kind, std::span<const std::string_view> words, std::uint32_t line,
                       const std::string& where);

// What follows //: in that line of the source. Throws InputError.
void read_note(Source& source, std::string_view line, std::uint32_t number);

}  // namespace brdf::shader
