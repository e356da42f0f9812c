#include "cli/inputs.h"

#include <algorithm>
#include <filesystem>

#include "io/error.h"

namespace brdf::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().filename().string().starts_with('.')) continue;
    if (entry.path().extension() == ".exr")
      throw InputError(folder.string() + ": no stack: no folder with lights.csv, but with images");
    files.push_back(entry.path().string());
  }
  if (files.empty()) throw InputError(folder.string() + ": no files in this folder");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> sample_files(const std::vector<std::string>& named) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    if (!fs::is_directory(name)) {
      files.push_back(name);
      continue;
    }
    const std::vector<std::string> inside = files_in(name);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

bool names_folder(const std::vector<std::string>& named) {
  return std::any_of(named.begin(), named.end(), [](const auto& name) { return fs::is_directory(name); });
}

}  // namespace brdf::cli
