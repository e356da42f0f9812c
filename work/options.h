// Options of a job, with the same meaning as in the verbs that do the work in one run.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "fit/choice.h"
#include "maps/page.h"

namespace brdf::work {

// Options of a stack's fit, in addition to the options of a table's fit.
struct StackOptions {
  std::string normals = "flat";  // "flat", "fit" or a file name
  // Bytes of pixels in memory at a time, for all threads together.
  std::uint64_t memory = std::uint64_t{1} << 29;
  std::vector<std::string> share;  // shapes that the texels of a region have in common
  std::string regions;             // a file name; empty: the whole stack is one region
};

// A plan stores these options as words of a command line.
struct TaskOptions {
  fit::FitChoice choice;
  StackOptions stack;
  bool no_pictures = false;
};
// Returns the options as words of a command line.
std::vector<std::string> arguments_of(const TaskOptions& options);

// Returns the options that the choice describes. If at most one of `jobs` files is fitted at a time, its
// models are fitted in parallel. A fit ends with the best result so far as soon as `interrupted` is true; if
// `interrupted` is null, the fit cannot be interrupted. Throws InputError.
fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs,
                            const std::atomic<bool>* interrupted);

// Returns the settings of a stack's fit. Throws InputError if the choice is not valid for a stack.
maps::Settings settings_of(const StackOptions& stack_options, const fit::FitChoice& choice,
                           const fit::FitOptions& options);
// Returns the file of the given normals. Empty if the normals are flat or fitted.
std::string normals_file(const StackOptions& options);

// Returns sample files as named. A folder is replaced by its files in the order of their names, without
// hidden files. Throws InputError for a folder without sample files, and for a folder of images, which is or
// should be a stack.
std::vector<std::string> sample_files(const std::vector<std::string>& named);

// Returns true if one of the names is a folder. The results then have the format of several files, whatever
// their number.
bool names_folder(const std::vector<std::string>& named);

}  // namespace brdf::work
