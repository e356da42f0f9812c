// Converts names of materials into identifiers of other languages.
#pragma once

#include <string>

namespace brdf::io {

// The context of the name: a file format without keywords (the name may also follow a prefix), an identifier
// of C++ or OSL, or an argument of a function that is written as GLSL, HLSL and C++.
enum class NameIn { file, cpp, osl, argument };

// Returns a name of letters, digits and single underscores that does not begin with a digit. Other
// characters become underscores. An empty name becomes "material" ("argument" for an argument). The name is
// prefixed with "material_", or "argument_", without the underscore if it begins with one, in these cases:
// - it begins with a digit, or with an underscore, which is reserved in C++ and refused by Mitsuba as an
//   id;
// - it has another meaning in the language or in the exported text. These are the keywords and, in C++,
//   also the global names of the language's headers and the macros of compilers.
// Double underscores are avoided because C++ and GLSL reserve them.
std::string identifier(const std::string& name, NameIn in = NameIn::file);

}  // namespace brdf::io
