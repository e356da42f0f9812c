// Studies many samples in parallel and writes one folder. The study can be resumed, and it has an overview.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/files/json.h"
#include "io/files/parallel.h"
#include "study/changes.h"
#include "study/sample.h"

namespace brdf::study {

struct Row;

struct StudyOptions {
  std::filesystem::path folder;
  SampleOptions sample;
  // All settings that affect the results, as text. Finished samples are kept only if they were made with
  // the same settings.
  std::string settings;
  unsigned jobs = 1;
  // Folder of an older study that the rows are compared with; empty: the earlier results in `folder`, if
  // there are any.
  std::filesystem::path against;
  // Only samples `first` to `first + count - 1` are studied and have rows. If samples are left out, no
  // overview is written. Folder names are chosen from the whole list, so that partial runs agree.
  std::size_t first = 0, count = std::size_t(-1);
  io::Progress progress;  // called with the number of finished steps and of all steps
  // Called by one thread at a time with each row and the rows' number, in the order of the samples, as soon
  // as the rows before it are finished and a sample could be read. There is no call if no sample can be read.
  std::function<void(const Row& row, std::size_t k, std::size_t rows)> finished = {};
};

enum class Fault { none, input, environment, interrupted };

struct Row {
  std::string file;
  std::filesystem::path folder;  // folder of the sample's files
  io::Json json;                 // docs/study.schema.json
  Fault fault = Fault::none;     // the reason why the study failed; `error` of `json` describes it
  bool kept = false;             // taken from an earlier run
  // The differences from the row of the same name in an older study (study/changes.h). Empty without an
  // older row, and if nothing differs.
  std::vector<Change> changes = {};
  // An older study was named and has a row of this name, or something differs from the earlier results.
  bool compared = false;
  // Assumptions of the reader that affect values or directions. Empty if the row is taken from an earlier
  // run.
  std::vector<std::string> assumptions = {};
  bool usable() const { return fault == Fault::none && json["usable"].get<bool>(); }
  // Returns whether a tolerance was set and the sample misses it.
  bool misses_tolerance() const {
    return fault == Fault::none && json["within_tolerance"].is_boolean() &&
           !json["within_tolerance"].get<bool>();
  }
};

// Returns the row for study.json and --json, with its changes: null if it was not compared.
io::Json to_json(const Row& row);

// Studies the samples and returns one row for each. For one sample the page is FOLDER/index.html. For
// several samples the pages are FOLDER/NAME/index.html, and FOLDER/index.html is the overview.
//
// A sample is kept if its results were made with the same settings from the same content, so that after an
// interruption only unfinished samples are recomputed. Samples without results are studied first, and the
// results of the others are checked in between, so that new results appear at once. An error in one sample
// is reported as the fault of its row and does not affect other samples. Throws InputError if the folder
// cannot be written, if a result would overwrite a sample, or if no sample can be used; nothing is written in
// these cases.
std::vector<Row> study(const std::vector<std::string>& samples, const StudyOptions& options);

}  // namespace brdf::study
