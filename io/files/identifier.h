// Names of materials as other languages take them.
#pragma once

#include <string>

namespace brdf::io {

// Where the name stands: in a file that has no words of its own (also behind a prefix), or as an identifier
// of a language.
enum class NameIn { file, cpp, osl };

// Letters, digits and single _, not a digit first. "material_" stands before a name that there is none of,
// that begins with a digit or _ (reserved in C++, refused by Mitsuba as an id), or that the language or the
// exported text takes for something else: its keywords, in C++ also what its headers declare for everyone and
// compilers define. Two _ are reserved in C++ and GLSL.
std::string identifier(const std::string& name, NameIn in = NameIn::file);

}  // namespace brdf::io
