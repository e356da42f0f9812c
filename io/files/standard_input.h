// The names of standard input: a path for the system, words for messages, `-` for a command line.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

inline constexpr std::string_view kStandardInput = "/dev/stdin";
inline constexpr std::string_view kStandardInputInWords = "standard input";

// Returns whether `name` is the path of standard input or its name in messages.
inline bool is_standard_input(std::string_view name) {
  return name == kStandardInput || name == kStandardInputInWords;
}

// Returns the name of an input for messages: "standard input" for its path, otherwise the path. A file that
// is called "standard input" is named with its folder.
inline std::string input_name(const std::string& path) {
  if (path == kStandardInput) return std::string(kStandardInputInWords);
  return path == kStandardInputInWords ? "./" + path : path;
}

}  // namespace brdf::io
