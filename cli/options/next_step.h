// The last line of a verb's text: the command that looks at the result.
#pragma once

#include <string>
#include <vector>

#include "cli/options/terminal.h"

namespace brdf::cli {

// Declares that this build lacks a verb; its commands are then not proposed.
void set_missing(const std::string& verb);

// Returns the command that shows a material in the window, next to the samples unless their name is empty or
// standard input. Returns an empty string if this build has no window, or if a name has characters that a
// terminal must not receive.
std::string view_command(const std::string& material, const std::string& samples = "");
// Does the same for a scene's file.
std::string scene_command(const std::string& scene);
// Returns the request to open a page. Returns an empty string if `page` is empty, a stream, or such a name.
std::string open_page(const std::string& page);
// Returns the command that checks a certificate, or an empty string as open_page().
std::string check_command(const std::string& certificate);

// Prints "look at it: A, or B"; `purpose` replaces "look at it". Empty steps are left out. Prints nothing if
// no step is left, or with --quiet. The line is not folded, so that its commands can be pasted.
void print_next_step(const std::vector<std::string>& steps, TextStream stream = TextStream::out,
                     const std::string& purpose = "look at it");

}  // namespace brdf::cli
