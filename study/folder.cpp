#include "study/folder.h"

#include <algorithm>
#include <set>

#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/fingerprint.h"
#include "io/files/output.h"

namespace brdf::study {
namespace {

namespace fs = std::filesystem;
using io::Json;

// Returns whether the name refers to a file directly in its folder.
bool is_plain(const std::string& name) {
  return !name.empty() && name == fs::path(name).filename() && name != "." && name != "..";
}

// A fingerprint of the inputs and of the results themselves, so that an edited row is recomputed.
std::string sealed(const std::string& key, const Json& results) {
  const auto found = results.find("results");
  return io::fingerprint({key, found == results.end() ? "null" : found->dump()});
}

// Returns whether the folder has files that are not written anew. Folders are not looked at: those of an
// overview are many.
bool has_others(const fs::path& folder, const Json& written) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (entry->is_regular_file(error) && name != kResults && !written.contains(name)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> folder_names(const std::vector<std::string>& samples) {
  std::set<std::string> taken{kPage, kResults};
  std::vector<std::string> names;
  for (const std::string& sample : samples) {
    std::string name = fs::path(sample).stem().string();
    if (!is_plain(name) || !taken.insert(name).second) {
      const std::string whole = fs::path(sample).filename().string();
      name = whole;
      for (int k = 2; !taken.insert(name).second; ++k) name = whole + "-" + std::to_string(k);
    }
    names.push_back(std::move(name));
  }
  return names;
}

bool has_results(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / kResults, ignored);
}

std::optional<Json> results_in(const fs::path& folder) {
  if (!has_results(folder)) return std::nullopt;
  try {
    Json json = io::read_json(io::read_result(folder / kResults));
    if (json.is_object() && json.contains("files") && json["files"].is_object()) return json;
  } catch (const InputError&) {  // not written by a study: it will be overwritten
  }
  return std::nullopt;
}

void publish(const fs::path& folder, const std::vector<File>& files, Json results, const std::string& key) {
  io::make_folder(folder);
  results["key"] = sealed(key, results);
  results["files"] = Json::object();
  for (const File& file : files) {
    io::write_file_atomically(folder / file.name, file.bytes);
    results["files"][file.name] = io::fingerprint({file.bytes});
  }
  // The earlier study.json of many samples is large, and is read only for the names of other files.
  const std::optional<Json> before =
      has_others(folder, results["files"]) ? results_in(folder) : std::optional<Json>();
  io::write_file_atomically(folder / kResults, io::to_text(results));
  if (!before) return;
  for (const auto& [name, fingerprint] : (*before)["files"].items()) {
    std::error_code ignored;
    if (is_plain(name) && !results["files"].contains(name)) fs::remove(folder / name, ignored);
  }
}

std::optional<Json> kept(const fs::path& folder, const std::string& key) {
  std::optional<Json> results = results_in(folder);
  if (!results || !results->contains("key") || (*results)["key"] != sealed(key, *results))
    return std::nullopt;
  try {
    for (const auto& [name, fingerprint] : (*results)["files"].items())
      if (!is_plain(name) || fingerprint != io::fingerprint({io::read_result(folder / name).bytes}))
        return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
  return results;
}

}  // namespace brdf::study
