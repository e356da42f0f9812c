// Small words of HTML for io/html_*.cpp.
#pragma once

#include <string>
#include <string_view>

#include "io/page/html_report.h"

namespace brdf::io {

// "" for Mark::none.
const char* css_class(Mark mark);
// " class=...", or nothing.
std::string class_of(Mark mark);
// With a space before it where it is not empty.
std::string after_space(std::string_view word);
// The HTML as a link, or as it stands where there is no address.
std::string linked(std::string_view address, const std::string& html);
std::string image(std::string_view png, std::string_view alt);
// The colours of map_colour() from end to end, with what both ends mean.
std::string colour_bar(std::string_view low, Colours colours, std::string_view high);
// JSON as it may stand in a script element, where "</" and "<!--" have meanings of their own.
std::string within_script(std::string_view json);

}  // namespace brdf::io
