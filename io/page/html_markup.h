// Small fragments of HTML for blocks that a page adds itself.
#pragma once

#include <string>
#include <string_view>

#include "io/page/html_report.h"

namespace brdf::io {

// Returns the CSS class of a mark; "" for Mark::none.
const char* css_class(Mark mark);
// Returns " class=...", or nothing if the mark has no class.
std::string class_of(Mark mark);
// Returns the word with a space before it; "" if the word is empty.
std::string after_space(std::string_view word);
// Returns `html` as a link to `address`, or unchanged if the address is empty.
std::string linked(std::string_view address, const std::string& html);
// Returns an image element with the PNG file embedded; `alt` is its alternative text.
std::string image(std::string_view png, std::string_view alt);
// Returns the colours of map_colour() from end to end, labelled with the meaning of both ends.
std::string colour_bar(std::string_view low, Colours colours, std::string_view high);
// Escapes JSON for a script element, in which "</" and "<!--" have special meanings.
std::string within_script(std::string_view json);

}  // namespace brdf::io
