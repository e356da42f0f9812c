#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// Writes `path` as a whole or not at all: the content goes to a temporary file beside it
// (io/files/temporary.h), which is then renamed, so an old file survives every failure. Links are followed,
// permissions kept; other names of the old file (hard links) keep the old content. What is no regular file (a
// terminal, a pipe, /dev/stdout) is written to directly. Throws as check_targets() and broke_off(); what the
// callback throws is passed on.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(std::ostream&)>& write);

// A place for an output, and the option that named it.
struct Target {
  std::string option;
  std::filesystem::path path;  // empty: not asked for
};

// For before the work: throws InputError where a target cannot be written (a missing folder, a read-only
// file, a loop of links), is one of the inputs, or is named twice.
void check_targets(const std::vector<Target>& targets, const std::vector<std::filesystem::path>& inputs = {});
// The same for files of these names in a folder, which need not exist.
void check_folder_target(const Target& folder, const std::vector<std::string>& names,
                         const std::vector<std::filesystem::path>& inputs = {});

// Makes a folder, and those above it.
void make_folder(const std::filesystem::path& folder);

// Throw for an errno: InputError where the place is what is wrong, else EnvironmentError.
[[noreturn]] void cannot_write(const std::filesystem::path& path, int error);
// EnvironmentError: a full disk.
[[noreturn]] void broke_off(const std::filesystem::path& path, int error);

}  // namespace brdf::io
