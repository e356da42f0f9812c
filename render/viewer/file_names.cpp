#include "render/viewer/file_names.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <fstream>

#include "io/files/output.h"

namespace brdf::render {
namespace {

constexpr std::size_t kMostRecent = 10;
constexpr std::array kEndings{".json", ".csv", ".txt", ".bsdf", ".astm", ".binary", ".brdf", ".exr", ".obj",
                              ".x",    ".ply", ".stl", ".fbx",  ".dae",  ".gltf",   ".glb",  ".3ds"};

bool may_be_opened(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

// Returns the path of the list, which has its own file so that an error cannot damage other data.
std::filesystem::path recent_list() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state && *state)
    return std::filesystem::path(state) / "brdf" / "recent";
  const char* home = std::getenv("HOME");
  return home ? std::filesystem::path(home) / ".local/state/brdf/recent" : std::filesystem::path();
}

}  // namespace

std::vector<std::string> names_that_go_on(const std::string& typed, std::size_t most) {
  const std::size_t slash = typed.rfind('/');
  const std::string before = slash == typed.npos ? "" : typed.substr(0, slash + 1),
                    rest = typed.substr(before.size());
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(before.empty() ? "." : before, error), end;
       !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(rest) || (name.starts_with('.') && !rest.starts_with('.'))) continue;
    std::error_code unknown;
    if (entry->is_directory(unknown))
      names.push_back(before + name + "/");
    else if (may_be_opened(entry->path()))
      names.push_back(before + name);
  }
  std::ranges::sort(names);
  if (names.size() > most) names.resize(most);
  return names;
}

std::string completed(const std::string& typed) {
  const std::vector<std::string> names = names_that_go_on(typed, std::size_t(-1));
  if (names.empty()) return typed;
  std::string common = names.front();
  for (const std::string& name : names) {
    const auto [a, b] = std::mismatch(common.begin(), common.end(), name.begin(), name.end());
    common.erase(a, common.end());
  }
  return common;
}

std::vector<std::string> recent_files() {
  std::vector<std::string> files;
  std::ifstream in(recent_list());
  for (std::string line; files.size() < kMostRecent && std::getline(in, line);)
    if (!line.empty()) files.push_back(line);
  return files;
}

void remember_file(const std::filesystem::path& file) {
  const std::filesystem::path list = recent_list();
  if (list.empty()) return;
  std::vector<std::string> files = recent_files();
  const std::string name = std::filesystem::absolute(file).string();
  if (name.find('\n') != name.npos) return;
  std::erase(files, name);
  files.insert(files.begin(), name);
  if (files.size() > kMostRecent) files.resize(kMostRecent);
  std::string text;
  for (const std::string& line : files) text += line + "\n";
  try {
    std::filesystem::create_directories(list.parent_path());
    io::write_file_atomically(list, text);
  } catch (const std::exception&) {  // the list is a convenience
  }
}

}  // namespace brdf::render
