// The content of a file, read once so that pipes work too. The format is detected from the content, never
// from the name.
#pragma once

#include <filesystem>
#include <string>

#include "io/files/limits.h"

namespace brdf::io {

struct Content {
  std::string name;  // for messages
  std::string bytes;
};

// Returns whether a system error (errno) concerns the name or the access rights. Such an error is the
// caller's fault; all others are failures of the machine.
bool is_of_the_name(int error);
// Throws InputError if is_of_the_name(error), otherwise EnvironmentError. The message suggests a similar
// file name if the file does not exist.
[[noreturn]] void cannot_be_read(const std::string& name, int error);
// Returns the standard library's complaint about a path as one sentence, for example that the name is too
// long or that a folder is not accessible.
std::string cannot_be_used(const std::filesystem::filesystem_error& error);

// Reads a whole file, a pipe or /dev/stdin. `limit`: largest size in bytes. Throws InputError if the file
// cannot be opened, is a folder or a device (terminals are accepted), or exceeds `limit`; throws
// EnvironmentError if the machine fails.
Content read_content(const std::filesystem::path& path, std::size_t limit = kLargestFile);

// Reads a result of an earlier command that this command may write again: it is no input (io/files/inputs.h).
Content read_result(const std::filesystem::path& path, std::size_t limit = kLargestFile);

// Returns whether the first character after leading white space opens a JSON object.
bool is_json(const Content& content);

// Returns the number, from 1, of the line that contains the byte at offset `place`.
std::size_t line_of(const std::string& bytes, std::size_t place);

// Converts text to UTF-8 in place. UTF-16 is converted, with or without a byte order mark. Other bytes that
// are not UTF-8 are interpreted as Latin-1, which instruments write. Lines that end in CR alone get LF
// instead. Returns a note on each conversion except one: the note on Latin-1 replaces the others. The note
// is empty if nothing had to be converted. Throws InputError if the bytes are not text.
std::string make_utf8(Content& text);

}  // namespace brdf::io
