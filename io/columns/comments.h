// Reads and writes the comments above the header row of a sample table.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace brdf::io {

using Comment = std::pair<std::string, std::string>;  // key and value; free text has no key

inline constexpr std::string_view kQuantityKey = "quantity";  // reserved: states the quantity of the columns

// Parses the text after the `#`. A key ends at the first colon. Control characters become blanks.
Comment parse_comment(std::string_view text);

// Returns the line, without its `#`, that reads back to this comment. Free text with a colon and reserved
// keys get a leading colon.
std::string comment_text(const Comment& comment);

}  // namespace brdf::io
