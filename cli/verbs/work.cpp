#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "cli/options/fit_options.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/terminal.h"
#include "cli/program/planned.h"
#include "cli/steps/fit_stack.h"
#include "io/files/error.h"
#include "io/files/parallel.h"
#include "work/unit.h"

namespace brdf::cli {
namespace {

struct WorkCall {
  std::string job;
  std::optional<std::size_t> unit;
  bool check = false;
  std::uint64_t memory = work::StackOptions().memory;
};

Exit run_work(const WorkCall& o) {
  const work::Task task = planned(o.job);
  const std::size_t count = task.plan().units().size();
  if (o.unit && *o.unit >= count)
    throw InputError("--unit " + std::to_string(*o.unit) + ": the units are 0 to " +
                     std::to_string(count - 1));
  watch_for_interrupt();
  io::limit_threads(1);  // the units run in parallel
  const auto progress = progress_line("brdf work: units");
  for (std::size_t unit = o.unit.value_or(0); unit < (o.unit ? *o.unit + 1 : count); ++unit) {
    if (!o.unit) progress(int(unit), int(count));
    work::do_unit(task, unit, o.memory, o.check, this_program());
    if (!was_interrupted()) continue;
    Warning() << "brdf work: interrupted: unit " << unit << " is not written";
    return Exit::failed;
  }
  return Exit::good;
}

}  // namespace

void add_work(CLI::App& app) {
  auto options = std::make_shared<WorkCall>();
  WorkCall& o = *options;
  CLI::App* verb =
      add_verb(app, Purpose::measure, "work", "Do one unit of planned work, unless it is done already");
  verb->add_option("JOB", o.job, "Folder of `brdf plan`")->required();
  verb->add_option("--unit", o.unit, "Number of the unit, from 0 (default: all units, one after another)");
  verb->add_flag("--check-inputs", o.check,
                 "Compare the images of a stack with the plan byte by byte, and not only by their lengths");
  add_stack_memory_option(*verb, o.memory);
  verb->footer(
      "Examples: brdf work job --unit 3 --memory-limit 1G\n"
      "          brdf work job --check-inputs\n"
      "          seq 0 63 | parallel -j2 brdf work job --unit {}");
  on_run(*verb, [options] { return run_work(*options); });
}

}  // namespace brdf::cli
