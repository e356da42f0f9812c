#include "cli/steps/fit_stack.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>

#include "cli/options/fit_options.h"
#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/stack_scene.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/text.h"
#include "maps/shared_fit.h"

namespace brdf::cli {

void add_share_options(CLI::App& verb, work::StackOptions& options) {
  add_repeated_option(verb, "--share", options.share,
                      "Shape of a stack with one value for all texels of a region, for instance alpha");
  verb.add_option("--regions", options.regions,
                  "EXR file with one channel, the number of the region of each texel for --share; 0: the "
                  "texel shares no value")
      ->check(CLI::ExistingFile);
}

void add_stack_memory_option(CLI::App& verb, std::uint64_t& bytes) {
  add_memory_option(verb, bytes, "memory for a stack's pixels at a time");
}

std::vector<std::string> result_names() {
  return {maps::kMapsFile, maps::kSummaryFile, kSceneFile};
}

Exit write_results(const StackFiles& files, const texel::Stack& stack, const maps::Making& making,
                   const texel::Planes& maps, std::optional<double> seconds) {
  const maps::Summary summary = maps::summary_of(maps);
  const std::string json = maps::summary_json(stack, making, summary, maps);
  io::make_folder(files.output);
  maps::write_maps(files.output, maps, making, json);
  const std::string scene = summary.fitted > 0 ? write_scene(files.output, stack, making.settings, maps) : "";
  if (!files.report.empty())
    io::write_file_atomically(files.report, maps::html_page(stack, making, summary, maps));
  if (files.json)
    std::cout << json;
  else
    maps::print(std::cout, stack, making, summary, files.output, seconds);
  if (!files.json && !scene.empty()) std::cout << io::printable(scene) << '\n';
  if (!files.json)
    print_next_step(
        {scene.empty() ? "" : scene_command((std::filesystem::path(files.output) / kSceneFile).string()),
         open_page(files.report)});
  return summary.usable() > 0 ? Exit::good : Exit::failed;
}

void check_targets(const StackFiles& files, std::vector<std::filesystem::path> inputs) {
  std::error_code unreadable;
  if (std::filesystem::equivalent(files.output, files.stack, unreadable))
    throw InputError(
        "-o " + files.output +
        ": is the folder of the stack, of which every OpenEXR file is an image: name another folder");
  for (const auto& entry : std::filesystem::directory_iterator(files.stack)) inputs.push_back(entry.path());
  io::check_folder_target({"-o", files.output}, result_names(), inputs);
  io::check_targets({{"--report", files.report}}, inputs);
}

Exit fit_a_stack(const StackFiles& files, const work::StackOptions& stack_options,
                 const fit::FitChoice& choice, const fit::FitOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  maps::Settings settings = work::settings_of(stack_options, choice, options);
  if (files.output.empty()) throw InputError("a stack needs -o FOLDER");
  require_file({"-o", files.output}, "the results of a stack are a folder");
  require_file({"--report", files.report}, "the report of a stack goes with a folder of results");
  const std::string given = work::normals_file(stack_options);
  if (!stack_options.regions.empty() && stack_options.share.empty())
    throw InputError("--regions: belongs to --share: name a shape parameter with --share");
  check_targets(files, {given, stack_options.regions});
  const texel::Stack stack = texel::open_stack(files.stack);
  std::optional<maps::Normals> normals;
  if (!given.empty()) normals = maps::read_normals(given, stack);
  const maps::Normals* const known = normals ? &*normals : nullptr;
  watch_for_interrupt();
  settings.options.metric = maps::choose_metric(stack, settings, known);
  const maps::Resources resources{stack_options.memory, files.jobs};
  const io::Progress progress = progress_line("brdf fit: parts of the stack");
  const texel::Planes maps =
      stack_options.share.empty()
          ? maps::fit_stack(stack, settings, known, resources, progress)
          : maps::fit_shared(stack, settings, known,
                             maps::read_sharing(stack_options.share, stack_options.regions, stack), resources,
                             progress);
  if (was_interrupted()) {
    Warning() << "brdf fit: interrupted: nothing is written";
    return Exit::failed;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  const maps::Making making{settings, stack_options.normals, io::provenance().command, stack_options.share,
                            stack_options.regions};
  return write_results(files, stack, making, maps, seconds);
}

}  // namespace brdf::cli
