// Where the results of one sample are kept, and whether what is there can be kept.
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
inline constexpr const char* kMeasured = "measured.png";
inline constexpr const char* kFitted = "fitted.png";
inline constexpr const char* kDifference = "difference.png";
inline constexpr const char* kSmallMeasured = "measured_small.png";
inline constexpr const char* kSmallFitted = "fitted_small.png";
// All that a sample's folder may hold of a study.
inline constexpr std::array kSampleFiles{kPage,     kResults,    kSheet,         kFit,
                                         kMaterial, kProperties, kShader,        kMeasured,
                                         kFitted,   kDifference, kSmallMeasured, kSmallFitted};

struct File {
  std::string name, bytes;
};

// A folder for each sample: the file's name without its suffix, with it where that is taken, and numbered
// where that is taken too. None is called like what the overview writes beside the folders.
std::vector<std::string> folder_names(const std::vector<std::string>& samples);

// Writes a sample's files, each at once or not at all, and last of all study.json: `results` with the key of
// what they were made of and a fingerprint of every file. What an earlier study.json lists and is not written
// again is removed. Throws as io::write_file_atomically().
void publish(const std::filesystem::path& folder, const std::vector<File>& files, io::Json results,
             const std::string& key);

// The folder's study.json, where it was made of the same and every file that it lists is there as it was
// written.
std::optional<io::Json> kept(const std::filesystem::path& folder, const std::string& key);

}  // namespace brdf::study
