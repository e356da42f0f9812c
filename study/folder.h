// Stores the results of one sample in a folder, and determines whether earlier results there can be reused.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/files/json.h"

namespace brdf::study {

inline constexpr const char* kPage = "index.html";
inline constexpr const char* kResults = "study.json";
inline constexpr const char* kSheet = "sheet.json";
inline constexpr const char* kFit = "fit.json";
inline constexpr const char* kMaterial = "material.json";
inline constexpr const char* kProperties = "properties.json";
inline constexpr const char* kShader = "material.glsl";
inline constexpr const char* kStudio = "studio.png";
inline constexpr const char* kSmallStudio = "studio_small.png";
inline constexpr const char* kMeasured = "measured.png";
inline constexpr const char* kFitted = "fitted.png";
inline constexpr const char* kDifference = "difference.png";
// All files of a study that a sample's folder may contain.
inline constexpr std::array kSampleFiles{kPage,   kResults, kSheet,       kFit,      kMaterial, kProperties,
                                         kShader, kStudio,  kSmallStudio, kMeasured, kFitted,   kDifference};

struct File {
  std::string name, bytes;
};

// Returns one folder name per sample: the file's name without its suffix; with the suffix if that name is
// taken; with a number appended if that is taken, too. The names never collide with the files that the
// overview writes next to the folders.
std::vector<std::string> folder_names(const std::vector<std::string>& samples);

// Writes a sample's files. Each file is written completely or not at all, and study.json is written last:
// `results`, with a key computed from `key` and the results, and with a fingerprint of every file. Files
// that an earlier study.json lists and that are not written again are removed. Throws the same errors as
// io::write_file_atomically().
void publish(const std::filesystem::path& folder, const std::vector<File>& files, io::Json results,
             const std::string& key);

// Returns whether the folder has a study.json, which may be an older one.
bool has_results(const std::filesystem::path& folder);

// Returns the content of the folder's study.json; std::nullopt if the file does not exist or was not written
// by a study.
std::optional<io::Json> results_in(const std::filesystem::path& folder);

// Returns the folder's study.json if it was made with the same `key` and every file that it lists is
// unchanged; otherwise std::nullopt.
std::optional<io::Json> kept(const std::filesystem::path& folder, const std::string& key);

}  // namespace brdf::study
