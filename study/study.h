// Studies many samples in parallel and writes one folder. The study can be resumed, and it has an overview.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/files/json.h"
#include "io/files/parallel.h"
#include "study/sample.h"

namespace brdf::study {

struct StudyOptions {
  std::filesystem::path folder;
  SampleOptions sample;
  // All settings that affect the results, as text. Finished samples are kept only if they were made with
  // the same settings.
  std::string settings;
  unsigned jobs = 1;
  // Only samples `first` to `first + count - 1` are studied and have rows. If samples are left out, no
  // overview is written. Folder names are chosen from the whole list, so that partial runs agree.
  std::size_t first = 0, count = std::size_t(-1);
  io::Progress progress;  // called with the number of finished steps and of all steps
};

enum class Fault { none, input, environment, interrupted };

struct Row {
  std::string file;
  std::filesystem::path folder;  // folder of the sample's files
  io::Json json;                 // docs/study.schema.json
  Fault fault = Fault::none;     // the reason why the study failed; `error` of `json` describes it
  bool kept = false;             // taken from an earlier run
  // Assumptions of the reader that affect values or directions. Empty if the row is taken from an earlier
  // run.
  std::vector<std::string> assumptions = {};
  bool usable() const { return fault == Fault::none && json["usable"].get<bool>(); }
};

// Studies the samples and returns one row for each. For one sample the page is FOLDER/index.html. For
// several samples the pages are FOLDER/NAME/index.html, and FOLDER/index.html is the overview.
//
// A sample is kept if its results were made with the same settings from the same content, so that after an
// interruption only unfinished samples are recomputed. An error in one sample is reported as the fault of
// its row and does not affect other samples. Throws InputError if the folder cannot be written, if a result
// would overwrite a sample, or if no sample can be used; nothing is written in these cases.
std::vector<Row> study(const std::vector<std::string>& samples, const StudyOptions& options);

}  // namespace brdf::study
