#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/verb.h"
#include "fit/choice.h"
#include "maps/page.h"
#include "work/options.h"

namespace brdf::cli {

struct StackFiles {
  std::string stack, output, report;
  unsigned jobs;
  bool json;
};

void add_share_options(CLI::App& verb, work::StackOptions& options);
void add_stack_memory_option(CLI::App& verb, std::uint64_t& bytes);

// The files that write_results() writes into a folder, but for pictures.
std::vector<std::string> result_names();

// Writes maps, scene and page, and prints the summary.
Exit write_results(const StackFiles& files, const texel::Stack& stack, const maps::Making& making,
                   const texel::Planes& maps, std::optional<double> seconds);

Exit fit_a_stack(const StackFiles& files, const work::StackOptions& stack_options,
                 const fit::FitChoice& choice, const fit::FitOptions& options);

}  // namespace brdf::cli
