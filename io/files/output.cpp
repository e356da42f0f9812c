#include "io/files/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <optional>
#include <system_error>
#include <tuple>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/file_buffer.h"
#include "io/files/inputs.h"
#include "io/files/standard_input.h"
#include "io/files/temporary.h"

namespace brdf::io {
bool is_standard_output(const std::filesystem::path& path) {
  return path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

void write_stream(const fs::path& shown, int descriptor, const std::function<void(std::ostream&)>& write) {
  FileBuffer buffer(descriptor);
  std::ostream out(&buffer);
  write(out);
  out.flush();
  if (buffer.error() != 0) broke_off(shown, buffer.error());
}

// Returns the file at the end of a chain of links, whether that file exists or not. The loop ends because
// stat() has already followed the chain.
fs::path resolved(fs::path path) {
  for (std::error_code error; fs::is_symlink(path, error);)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::optional<struct stat> status_of(const fs::path& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

// Throws if the file cannot be written. Returns the status of an existing file, or std::nullopt.
std::optional<struct stat> checked(const fs::path& path) {
  if (path.empty() || !path.has_filename())
    throw InputError("'" + path.string() + "': is not the name of a file");
  const std::optional<struct stat> old = status_of(path);
  if (!old && errno != ENOENT) cannot_write(path, errno);
  if (old && S_ISDIR(old->st_mode)) cannot_write(path, EISDIR);
  if (is_standard_output(path)) return old;
  // The superuser may write any file, but a file's read-only permissions are respected for this user too.
  if (old && S_ISREG(old->st_mode) && (old->st_mode & 0222) == 0)
    throw InputError(path.string() + ": is read-only: cannot be written");
  if (old && ::access(path.c_str(), W_OK) != 0) cannot_write(path, errno);
  if (old && !S_ISREG(old->st_mode)) return old;
  if (::access(folder_of(resolved(path)).c_str(), W_OK | X_OK) != 0) cannot_write(path, errno);
  return old;
}

std::optional<Inputs::Identity> identity(const fs::path& path) {
  if (const auto status = status_of(path)) {
    if (!S_ISREG(status->st_mode)) return std::nullopt;  // a terminal may be written to twice
    return Inputs::Identity{status->st_dev, status->st_ino, ""};
  }
  const fs::path target = resolved(path);
  const auto folder = status_of(folder_of(target));
  if (!folder) return std::nullopt;
  return Inputs::Identity{folder->st_dev, folder->st_ino, target.filename().string()};
}

// Returns true if the folder has no such file, or if the file is a plain one that may be written, that is no
// input, and that has no second name. The folder is writable. Two calls of the system in place of six, and no
// path: a study has many thousands of files.
bool is_surely_writable(int folder, const std::string& name, const Inputs& inputs) {
  struct stat status;
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return errno == ENOENT;
  return S_ISREG(status.st_mode) && status.st_nlink == 1 && (status.st_mode & 0222) != 0 &&
         ::faccessat(folder, name.c_str(), W_OK, 0) == 0 && !inputs.find({status.st_dev, status.st_ino, ""});
}

}  // namespace

void cannot_write(const fs::path& path, int error) {
  const std::string message = path.string() + ": cannot be written: " + reason(error);
  if (is_of_the_name(error)) throw InputError(message);
  throw EnvironmentError(message);
}

void broke_off(const fs::path& path, int error) {
  throw EnvironmentError(path.string() + ": writing broke off: " + reason(error));
}

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, [&](std::ostream& out) {
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

void write_file_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  const std::optional<struct stat> old = checked(path);
  if (is_standard_output(path)) return write_stream(path, STDOUT_FILENO, write);
  if (old && !S_ISREG(old->st_mode)) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (file < 0) cannot_write(path, errno);
    const std::unique_ptr<const int, void (*)(const int*)> closed(&file, [](const int* f) { ::close(*f); });
    return write_stream(path, file, write);
  }
  if (is_kept_input(path))
    throw InputError(path.string() + ": is an input of this command, and is kept: name another output");
  const fs::path target = resolved(path);
  TemporaryFile temporary(target, old ? &*old : nullptr, path);
  write_stream(path, temporary.descriptor(), write);
  temporary.rename_to(target);
}

Inputs::Inputs(const std::vector<fs::path>& paths) {
  for (const fs::path& path : paths)
    if (const std::optional<Identity> id = identity(path)) paths_.emplace(*id, path);
}

const fs::path* Inputs::find(const Identity& file) const {
  const auto found = paths_.find(file);
  return found == paths_.end() ? nullptr : &found->second;
}

void check_targets(const std::vector<Target>& targets, const std::vector<fs::path>& inputs) {
  check_targets(targets, Inputs(inputs));
}

void check_targets(const std::vector<Target>& targets, const Inputs& inputs) {
  std::map<Inputs::Identity, const Target*> seen;
  for (const Target& target : targets) {
    if (target.path.empty()) continue;
    checked(target.path);
    const std::optional<Inputs::Identity> id = identity(target.path);
    if (!id) continue;
    const std::string name = target.option + " " + target.path.string();
    if (const fs::path* input = inputs.find(*id))
      throw InputError(name + ": is the input " + input_name(input->string()));
    if (const auto [at, fresh] = seen.emplace(*id, &target); !fresh)
      throw InputError(name + ": is also the output of " + at->second->option);
  }
}

void check_folder_target(const Target& folder, const std::vector<std::string>& names,
                         const std::vector<fs::path>& inputs) {
  check_folder_target(folder, names, Inputs(inputs));
}

void check_folder_target(const Target& folder, const std::vector<std::string>& names, const Inputs& inputs) {
  fs::path existing = folder.path;
  std::optional<struct stat> status;
  while (!(status = status_of(existing))) {
    if (errno != ENOENT) cannot_write(folder.path, errno);
    existing = folder_of(existing);
  }
  if (!S_ISDIR(status->st_mode))
    throw InputError(folder.option + " " + folder.path.string() + ": " + existing.string() +
                     " is not a folder");
  if (::access(existing.c_str(), W_OK | X_OK) != 0) cannot_write(folder.path, errno);
  if (existing != folder.path) return;
  const int opened = ::open(folder.path.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) cannot_write(folder.path, errno);
  const std::unique_ptr<const int, void (*)(const int*)> closed(&opened, [](const int* f) { ::close(*f); });
  std::vector<Target> targets;
  for (const std::string& name : names)
    if (!is_surely_writable(opened, name, inputs)) targets.push_back({folder.option, folder.path / name});
  check_targets(targets, inputs);
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) cannot_write(folder, error.value());
}

}  // namespace brdf::io
