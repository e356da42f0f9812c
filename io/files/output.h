// Writes output files atomically and checks beforehand that they can be written.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace brdf::io {

// Writes `path` completely or not at all. The content goes to a temporary file in the same folder
// (io/files/temporary.h), which is then renamed, so that an old file survives every failure. Symbolic
// links are followed and permissions are kept; hard links to the old file keep the old content. Paths that
// are not regular files (a terminal, a pipe, /dev/stdout) are written directly. Throws InputError for an
// input that is kept (io/files/inputs.h), and the exceptions of check_targets() and broke_off();
// exceptions of the callback are passed on.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(std::ostream&)>& write);

// Returns whether the path names standard output.
bool is_standard_output(const std::filesystem::path& path);

// The path of an output, and the option that named the path.
struct Target {
  std::string option;
  std::filesystem::path path;  // empty if the output is not requested
};

// Files that are read, looked up once for many checks. The device, the inode and, for a file that does not
// exist, the name in its folder identify a file.
class Inputs {
 public:
  using Identity = std::tuple<dev_t, ino_t, std::string>;
  explicit Inputs(const std::vector<std::filesystem::path>& paths);
  // Returns the input that is this file, or null.
  const std::filesystem::path* find(const Identity& file) const;

 private:
  std::map<Identity, std::filesystem::path> paths_;
};

// Checks the targets before the work begins. Throws InputError if a target cannot be written (a missing
// folder, a read-only file, a loop of links), is one of the inputs, or is named twice.
void check_targets(const std::vector<Target>& targets, const std::vector<std::filesystem::path>& inputs = {});
void check_targets(const std::vector<Target>& targets, const Inputs& inputs);
// Does the same for files with these names in a folder, which need not exist yet.
void check_folder_target(const Target& folder, const std::vector<std::string>& names,
                         const std::vector<std::filesystem::path>& inputs = {});
void check_folder_target(const Target& folder, const std::vector<std::string>& names, const Inputs& inputs);

// Creates a folder and its missing parent folders.
void make_folder(const std::filesystem::path& folder);

// Throws InputError if the errno concerns the path (is_of_the_name()), otherwise EnvironmentError.
[[noreturn]] void cannot_write(const std::filesystem::path& path, int error);
// Throws EnvironmentError for a write that failed part of the way, for example on a full disk.
[[noreturn]] void broke_off(const std::filesystem::path& path, int error);

}  // namespace brdf::io
