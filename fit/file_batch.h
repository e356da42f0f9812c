// Many files: fitted side by side, resumable, with one summary.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fit/fit.h"
#include "io/files/json.h"

namespace brdf::fit {

struct BatchOptions {
  std::filesystem::path folder;
  unsigned jobs = 1;
  // Everything that decides the result, as text: a finished file is kept only if it was made with the same.
  std::string settings;
  // Only these are done, and have rows; results are called as if all were.
  std::size_t first = 0, count = std::size_t(-1);
  // Called, one at a time, when a file is done.
  std::function<void(const std::string& message)> progress;
  bool spheres = true;  // on each file's page, which take longer than the fit
};

// The error of a file that was not fitted because the run was interrupted.
inline constexpr const char* kInterrupted = "interrupted";

struct BatchRow {
  std::string file, name;           // name.json (material), name.fit.json, name.html in the folder
  std::string error;                // why there is no fit; empty where there is one
  bool environment_failed = false;  // not the file's fault
  bool reused = false;
  std::vector<std::string> assumptions =
      {};         // of the reader, on which the values rest; of a file that is not kept
  io::Json best;  // first of the ranking
  std::string recommended;
};

// What the results of each file are called. Throws InputError where two would have the same name.
std::vector<std::string> batch_names(const std::vector<std::string>& files);

// Fits every file into the folder. A file whose name.fit.json was written by the same settings from the same
// content is kept, so that a run that was killed redoes only what was in flight. What goes wrong with a file
// is its row's error. Throws InputError where the folder cannot be written, a result would replace one of the
// files, or two would have the same name.
std::vector<BatchRow> run_batch(const std::vector<std::string>& files,
                                const std::vector<std::vector<Reflectance>>& models,
                                const FitOptions& options, const BatchOptions& batch);

// summary.csv and summary.html in the folder; a picture name.png beside a material is shown.
void write_summary(const std::vector<BatchRow>& rows, const std::filesystem::path& folder);

// `{"files": [{"file", "material", "kept", "best"} or {"file", "error"}]}`.
io::Json to_json(const std::vector<BatchRow>& rows, const std::filesystem::path& folder);

// A row whose fit can be used.
bool usable(const BatchRow& row);

}  // namespace brdf::fit
