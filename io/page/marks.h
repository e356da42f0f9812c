// The marks of an assessment: one table for pages, overviews and terminals.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "brdf/names.h"

namespace brdf::io {

// The assessment of a value. Marks are ordered by precedence: the largest of several marks outweighs the
// others. unknown: it is not known whether the value is good; absent: does not apply. Every mark except
// none has a sign of its own shape in addition to its colour.
enum class Mark { none, good, unknown, warn, bad, absent };

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 6> kNames<io::Mark>{"none", "good", "unknown",
                                                                  "warn", "bad",  "absent"};

}  // namespace brdf

namespace brdf::io {

// The look of a mark. The shapes differ, so that readers without colour vision distinguish the marks.
struct MarkLook {
  Mark mark;
  std::string_view word;      // a word that names the state: "good", "warning", "bad", "unknown"
  std::string_view sign;      // one character in UTF-8; empty for Mark::none
  std::string_view shape;     // CSS of the ground behind the sign: disc, ring, triangle, square
  std::string_view terminal;  // the escape sequence of the colour in a terminal
};

// Returns the look of a mark.
const MarkLook& look_of(Mark mark);
// Returns the style of all marks, for the style of a page.
std::string mark_style();
// Returns one line that explains the marks, as HTML.
std::string mark_legend();

}  // namespace brdf::io
