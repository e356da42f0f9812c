// Processing of several files, all in one run or a part of them as a unit.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fit/file_batch.h"
#include "study/study.h"
#include "work/options.h"

namespace brdf::work {

// The connection of long work to its caller: a request to stop, and a receiver for messages.
struct Caller {
  const std::atomic<bool>* interrupted = nullptr;  // null: the work cannot be interrupted
  std::function<void(const std::string& sentence)> say = [](const std::string&) {};

  bool stops() const { return interrupted && interrupted->load(std::memory_order_relaxed); }
};

// Several files, and the range of files to be fitted.
struct FileFits {
  std::vector<std::string> samples;
  std::filesystem::path folder;
  unsigned jobs = 1;
  bool pictures = true;
  std::size_t first = 0, count = std::size_t(-1);
};

// Fits the files into the folder. Each material gets a picture of a sphere if pictures are requested and can
// be rendered on this machine.
std::vector<fit::BatchRow> fit_files(const FileFits& files, const fit::FitChoice& choice,
                                     const fit::FitOptions& options, const Caller& caller,
                                     const std::function<void(const std::string&)>& progress = {});

// Returns the samples for a fit, read and arranged as the options request. Warnings are passed to
// caller.say.
fit::Samples samples_to_fit(const std::string& file, const fit::FitOptions& options, const Caller& caller);

// Returns the options of a study with this choice.
study::StudyOptions study_options(const fit::FitChoice& choice, bool pictures,
                                  const std::filesystem::path& folder, unsigned jobs, const Caller& caller);

}  // namespace brdf::work
