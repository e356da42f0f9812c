// Reads the author's declarations about a shader, in lines that begin with //: and in BRDF Explorer's
// blocks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "shader/front/source.h"

namespace brdf::shader {

// Reads a declaration: "param NAME MIN MAX DEFAULT [log] [role R]", "bool NAME 0|1", "color NAME r g b"
// (the last two also as "param NAME bool 0|1" and "param NAME color r g b"), and BRDF Explorer's "float
// NAME MIN MAX DEFAULT". `words` are the words after `kind`. Throws InputError with a message that begins
// with `where`.
Declared read_declared(std::string_view kind, std::span<const std::string_view> words, std::uint32_t line,
                       const std::string& where);

// Reads the text after //: in this line of the source. Throws InputError if the text is not valid.
void read_note(Source& source, std::string_view line, std::uint32_t number);

}  // namespace brdf::shader
