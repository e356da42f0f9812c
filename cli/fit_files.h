#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "cli/verbs.h"
#include "fit/choice.h"
#include "fit/file_batch.h"

namespace brdf::cli {

// Several files, and which of them are fitted.
struct FileFits {
  std::vector<std::string> samples;
  std::filesystem::path folder;
  unsigned jobs = 1;
  bool pictures = true;
  std::size_t first = 0, count = std::size_t(-1);
};

// Fits them into the folder, each with a picture of a sphere where these are asked for and can be drawn here.
std::vector<fit::BatchRow> fit_files(const FileFits& files, const fit::FitChoice& choice,
                                     const fit::FitOptions& options,
                                     const std::function<void(const std::string&)>& progress);

// Writes the summary and prints where it is, or `json`.
Exit summarise(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder, bool json);

}  // namespace brdf::cli
