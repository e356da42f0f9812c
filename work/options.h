// What a job is told, as the verbs that do it at once are told it.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "fit/choice.h"
#include "maps/page.h"

namespace brdf::work {

// What a fit of a stack is told beside a fit of a table.
struct StackOptions {
  std::string normals = "flat";  // flat, fit or a file
  std::uint64_t memory = std::uint64_t{1} << 29;
  std::vector<std::string> share;  // shapes that a region's texels have in common
  std::string regions;             // a file; empty: the whole stack
};

// A plan keeps these as words.
struct TaskOptions {
  fit::FitChoice choice;
  StackOptions stack;
  bool no_pictures = false;
};
// The words, as a command line has them.
std::vector<std::string> arguments_of(const TaskOptions& options);

// What the choice means. Where no more than one of `jobs` files is fitted at a time, its models are fitted
// side by side. A fit ends with the best so far once `interrupted` (none: nobody interrupts) is true. Throws
// InputError.
fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs,
                            const std::atomic<bool>* interrupted);

// Throws InputError where the choice is none for a stack.
maps::Settings settings_of(const StackOptions& stack_options, const fit::FitChoice& choice,
                           const fit::FitOptions& options);
// The file that the normals are given in; empty where they are flat or fitted.
std::string normals_file(const StackOptions& options);

// Sample files as they are named; in place of a folder those in it, in the order of their names, hidden ones
// left out. Throws InputError for a folder without any, and for one of images, which is a stack or should be.
std::vector<std::string> sample_files(const std::vector<std::string>& named);

// Whether one of them is a folder: the results are those of several files then, whatever their number.
bool names_folder(const std::vector<std::string>& named);

}  // namespace brdf::work
