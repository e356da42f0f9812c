#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace brdf::io {

// Writes `path` as a whole or not at all: the content goes to a temporary file beside it,
// which is then renamed, so an old file survives every failure and no temporary is left.
// Links are followed; what is no regular file (a terminal, a pipe, /dev/stdout) is written
// to directly. Throws InputError where the place cannot be written, EnvironmentError where
// writing breaks off (a full disk); what the callback throws is passed on.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(std::ostream&)>& write);

// The same for libraries that open their file by name: `write` receives the temporary's path.
void write_path_atomically(const std::filesystem::path& path,
                           const std::function<void(const std::filesystem::path&)>& write);

}  // namespace brdf::io
