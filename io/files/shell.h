// Words of a command line as a shell takes them.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// As it stands where a shell leaves it alone, else between single quotes; on one line and UTF-8 whatever it
// holds: control characters, and all that is beyond ASCII in a word that is not UTF-8, as in $'\012' (bash,
// zsh, ksh).
std::string shell_word(std::string_view word);

// A file's name as an argument: one that begins with a dash is no option.
std::string shell_file(std::string_view name);

}  // namespace brdf::io
