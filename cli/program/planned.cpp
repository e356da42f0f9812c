#include "cli/program/planned.h"

#include <filesystem>

#include "cli/options/fit_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/program/study_files.h"
#include "cli/steps/fit_files.h"
#include "cli/steps/fit_stack.h"
#include "cli/steps/fit_table.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "work/unit.h"

namespace brdf::cli {
namespace {

Exit collect_refits(const work::Task& task, const CollectFiles& files) {
  const fit::FitOptions options = fit_options(task.options().choice, 1);
  work::check_input(task.plan().inputs[0], true);
  io::check_targets({{"-o", files.output}, {"--report", files.report}}, {task.samples()[0]});
  const fit::Samples samples = work::samples_to_fit(task.samples()[0], options, this_program());
  const fit::RefitSolutions solutions = work::refits_of(task);
  const fit::FitResult result =
      fit::fit(samples, fit::models_of(task.options().choice.form), options, {}, &solutions);
  return write_fit(result, samples.table, options, {files.output, files.report, "", false});
}

Exit collect_stack(const work::Task& task, const CollectFiles& files) {
  require_file({"-o", files.output}, "the results of a stack are a folder");
  const work::StackTask stack = task.stack();
  const StackFiles outputs{task.plan().stack, files.output, files.report, 1, false};
  check_targets(outputs, {});
  const texel::Planes maps = work::maps_of(task, stack);
  const maps::Making making{stack.settings, task.options().stack.normals, task.plan().command};
  return write_results(outputs, stack.stack, making, maps, std::nullopt);
}

Exit collect_tables(const work::Task& task, const CollectFiles& files) {
  if (!files.report.empty()) throw InputError("--report is for a stack of photographs");
  require_file({"-o", files.output}, "the results of several files are a folder");
  work::unpack_units(task, files.output);
  const fit::FitChoice& choice = task.options().choice;
  if (task.plan().verb == "study") {
    return study_files(
        task.samples(),
        work::study_options(choice, !task.options().no_pictures, files.output, 1, this_program()), false,
        choice.options.supplied == io::Supplied());
  }
  const auto rows = work::fit_files({task.samples(), files.output, 1, !task.options().no_pictures}, choice,
                                    fit_options(choice, 1), this_program());
  for (const fit::BatchRow& row : rows)
    if (!row.error.empty() && row.error != fit::kInterrupted) Warning() << "brdf collect: " << row.error;
  return summarise(rows, files.output, false);
}

}  // namespace

work::Task planned(const std::string& job) {
  work::Task task(job, task_options_of);
  std::error_code error;
  std::filesystem::current_path(task.plan().directory, error);
  if (error) throw InputError(job + ": planned in " + task.plan().directory + ": " + error.message());
  io::record_command(task.plan().command);
  return task;
}

Exit put_together(const work::Task& task, const CollectFiles& files) {
  if (task.of_refits()) return collect_refits(task, files);
  return task.plan().stack.empty() ? collect_tables(task, files) : collect_stack(task, files);
}

}  // namespace brdf::cli
