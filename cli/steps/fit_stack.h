// The fit of a stack of photographs: options and results.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/verb.h"
#include "fit/choice.h"
#include "maps/page.h"
#include "work/options.h"

namespace brdf::cli {

// Input and output of the fit of a stack.
struct StackFiles {
  std::string stack, output, report;
  unsigned jobs;
  bool json;
};

// Adds the options for shapes that texels share.
void add_share_options(CLI::App& verb, work::StackOptions& options);
// Adds --memory-limit for the pixels in memory at a time.
void add_stack_memory_option(CLI::App& verb, std::uint64_t& bytes);

// Returns the names of the files that write_results() writes into a folder, except for pictures.
std::vector<std::string> result_names();

// Throws InputError if an output would replace a file of the stack or one of `inputs`, or if the results
// would be files of the stack.
void check_targets(const StackFiles& files, std::vector<std::filesystem::path> inputs);

// Writes the maps, the scene if it can be made, and the page if `files.report` is not empty. Prints the
// summary.
Exit write_results(const StackFiles& files, const texel::Stack& stack, const maps::Making& making,
                   const texel::Planes& maps, std::optional<double> seconds);

// Fits a stack and writes its results.
Exit fit_a_stack(const StackFiles& files, const work::StackOptions& stack_options,
                 const fit::FitChoice& choice, const fit::FitOptions& options);

}  // namespace brdf::cli
