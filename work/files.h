// What is done with several files, all at once or some of them as a unit.
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

// Whom long work listens to and tells.
struct Caller {
  const std::atomic<bool>* interrupted = nullptr;  // none: nobody interrupts
  std::function<void(const std::string& sentence)> say = [](const std::string&) {};

  bool stops() const { return interrupted && interrupted->load(std::memory_order_relaxed); }
};

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
                                     const fit::FitOptions& options, const Caller& caller,
                                     const std::function<void(const std::string&)>& progress = {});

// What is fitted, read and arranged as the options ask; the caller hears its warnings.
fit::Samples samples_to_fit(const std::string& file, const fit::FitOptions& options, const Caller& caller);

study::StudyOptions study_options(const fit::FitChoice& choice, bool pictures,
                                  const std::filesystem::path& folder, unsigned jobs, const Caller& caller);

}  // namespace brdf::work
