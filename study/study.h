// Many samples studied side by side into one folder: resumable, with an overview.
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
  // Everything that decides the results, as text: finished ones are kept only if they were made with the
  // same.
  std::string settings;
  unsigned jobs = 1;
  // Only these are done, and have rows, without an overview; folders are called as if all were.
  std::size_t first = 0, count = std::size_t(-1);
  io::Progress progress;  // steps done, of all
};

enum class Fault { none, input, environment, interrupted };

struct Row {
  std::string file;
  std::filesystem::path folder;  // of its files
  io::Json json;                 // docs/study.schema.json
  Fault fault = Fault::none;     // why there is no study: json's `error` says it in words
  bool kept = false;             // from an earlier run
  std::vector<std::string> assumptions =
      {};  // of the reader, on which values or directions rest; of one that is not kept
  bool usable() const { return fault == Fault::none && json["usable"].get<bool>(); }
};

// Of one sample FOLDER/index.html is its page; of many FOLDER/NAME/index.html are, and FOLDER/index.html the
// overview. A sample whose results were made by the same settings from the same content is kept, so that a
// run that was killed redoes only what was in flight. What goes wrong with a sample is its row's fault, and
// ends no other. Throws InputError where the folder cannot be written, a result would replace a sample, or no
// sample can be used; nothing is written then.
std::vector<Row> study(const std::vector<std::string>& samples, const StudyOptions& options);

}  // namespace brdf::study
