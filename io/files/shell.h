// Quotes words for a shell's command line.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// Returns the word unchanged if a shell does not interpret any of its characters, otherwise in single
// quotes. The result is always one line of UTF-8. Control characters, and all bytes beyond ASCII in a word
// that is not UTF-8, are written as in $'\012' (bash, zsh, ksh).
std::string shell_word(std::string_view word);

// Returns a file's name as an argument. A name that begins with a dash gets the prefix "./", so that it is
// not taken for an option. Standard input is `-`. Verbs take a material or a table by this argument alone.
std::string shell_file(std::string_view name);

}  // namespace brdf::io
