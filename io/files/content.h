// What a file holds: read once, so that a pipe is as good as a file, and told by the content, never by the
// name.
#pragma once

#include <filesystem>
#include <string>

#include "io/files/limits.h"

namespace brdf::io {

struct Content {
  std::string name;  // for messages
  std::string bytes;
};

// Whether an error of the system (errno) is of the name or the rights, which is the caller's fault, not the
// machine's.
bool is_of_the_name(int error);
// Throws for an errno: InputError where it is of the name, else EnvironmentError.
[[noreturn]] void cannot_be_read(const std::string& name, int error);
// What the standard library says of a name (too long, in a folder that may not be entered), in one sentence.
std::string cannot_be_used(const std::filesystem::filesystem_error& error);

// The whole of a file, a pipe or /dev/stdin. Throws InputError where it cannot be opened, is a folder or a
// device or is larger than `limit`; EnvironmentError where the machine fails.
Content read_content(const std::filesystem::path& path, std::size_t limit = kLargestFile);

// Whether the first character that is no blank opens a JSON object.
bool is_json(const Content& content);

// The number of the line, from 1, that holds this byte.
std::size_t line_of(const std::string& bytes, std::size_t place);

// Makes text UTF-8: what is not is taken for Latin-1, which instruments write. Returns a sentence that says
// so, empty where nothing had to be done. Throws InputError where the bytes are no text.
std::string make_utf8(Content& text);

}  // namespace brdf::io
