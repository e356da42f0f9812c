// The comments above a sample table's header row.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace brdf::io {

using Comment = std::pair<std::string, std::string>;  // key and value; free text has no key

inline constexpr std::string_view kQuantityKey = "quantity";  // reserved: says what the columns hold

// What follows the `#`: a key ends at the first colon. Control characters become blanks.
Comment parse_comment(std::string_view text);

// The line without its `#` that reads back to this comment: free text with a colon keeps a leading one, and
// so does a key that is reserved.
std::string comment_text(const Comment& comment);

}  // namespace brdf::io
