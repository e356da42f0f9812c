#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/verbs.h"
#include "fit/choice.h"
#include "maps/page.h"

namespace brdf::cli {

// What a fit of a stack is told beside a fit of a table.
struct StackOptions {
  std::string normals = "flat";  // flat, fit or a file
  std::uint64_t memory = std::uint64_t{1} << 29;
  std::vector<std::string> share;  // shapes that a region's texels have in common
  std::string regions;             // a file; empty: the whole stack
};

struct StackFiles {
  std::string stack, output, report;
  unsigned jobs;
  bool json;
};

void add_normals_option(CLI::App& verb, StackOptions& options);
void add_share_options(CLI::App& verb, StackOptions& options);
void add_stack_memory_option(CLI::App& verb, std::uint64_t& bytes);

// Throws InputError where the choice is none for a stack.
maps::Settings settings_of(const StackOptions& stack_options, const fit::FitChoice& choice,
                           const fit::FitOptions& options);
// The file that the normals are given in; empty where they are flat or fitted.
std::string normals_file(const StackOptions& options);

// The files that write_results() writes into a folder, but for pictures.
std::vector<std::string> result_names();

// Writes maps, scene and page, and prints the summary.
Exit write_results(const StackFiles& files, const texel::Stack& stack, const maps::Making& making,
                   const texel::Planes& maps, std::optional<double> seconds);

Exit run_stack(const StackFiles& files, const StackOptions& stack_options, const fit::FitChoice& choice,
               const fit::FitOptions& options);

}  // namespace brdf::cli
