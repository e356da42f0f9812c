// Fits many files in parallel. Runs can be resumed, and one summary covers all files.
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
  // Everything that determines the result, as text. A finished file is kept only if it was made with the
  // same text.
  std::string settings;
  // Only files `first` to `first + count - 1` are processed and have rows. Output names are chosen from the
  // whole list, so partial runs agree.
  std::size_t first = 0, count = std::size_t(-1);
  // Called when a file is finished, never from two threads at once.
  std::function<void(const std::string& message)> progress;
  bool spheres = true;  // draw a sphere on each file's page; a sphere takes longer than the fit
};

// The error of a file that was not fitted because the run was interrupted.
inline constexpr const char* kInterrupted = "interrupted";

struct BatchRow {
  std::string file, name;           // the folder holds name.json (material), name.fit.json and name.html
  std::string error;                // the reason why there is no fit; empty if there is a fit
  bool environment_failed = false;  // the environment caused the error, not the file
  bool reused = false;
  // Assumptions of the reader on which the values rest; filled only if the file was fitted in this run.
  std::vector<std::string> assumptions = {};
  io::Json best;  // the first entry of the ranking
  std::string recommended;
};

// Returns the name of the results of each file. Throws InputError if two files would have the same name.
std::vector<std::string> batch_names(const std::vector<std::string>& files);

// Fits every file into the folder. A file is kept if its name.fit.json was written with the same settings
// from the same content, so a run that was killed repeats only the files in progress. An error in a file is
// recorded in its row. Throws InputError if the folder cannot be written, if a result would replace one of
// the files, or if two results would have the same name.
// Example:
//     brdf::fit::BatchOptions batch;
//     batch.folder = "fits";
//     batch.spheres = false;
//     const std::vector<std::string> files{"matt.csv"};
//     const auto rows = run_batch(files, {{*brdf::find_form("lambert")}}, {}, batch);
//     write_summary(rows, batch.folder);
std::vector<BatchRow> run_batch(const std::vector<std::string>& files,
                                const std::vector<std::vector<Reflectance>>& models,
                                const FitOptions& options, const BatchOptions& batch);

// Writes summary.csv and summary.html to the folder. The page shows the picture name.png of a material if
// the picture exists.
void write_summary(const std::vector<BatchRow>& rows, const std::filesystem::path& folder);

// Returns `{"files": [{"file", "material", "kept", "best"} or {"file", "error"}]}`.
io::Json to_json(const std::vector<BatchRow>& rows, const std::filesystem::path& folder);

// Returns whether the row has a fit that can be used.
bool usable(const BatchRow& row);

}  // namespace brdf::fit
