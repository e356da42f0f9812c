#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/fit_options.h"
#include "cli/options/options.h"
#include "cli/options/products.h"
#include "cli/verb.h"
#include "io/files/numbers.h"
#include "work/task.h"

namespace brdf::cli {
namespace {

struct PlanCall {
  std::string verb, unit_size, output;
  std::vector<std::string> inputs;
  work::TaskOptions task;
};

enum Planned : unsigned { kPlannedFit = 1, kPlannedStudy = 2, kAnyPlan = 3 };
constexpr OptionOf kPlanOptions[] = {
    {"VERB SAMPLES --form --metric --anisotropic --per-channel --shape "
     "--free-scale --keep-fill --polarisation --repeats "
     "--quantity --mirror-side --layout --budget --max-theta --fix --start --bounds --tie "
     "--physical --robust --weights --starts --aperture "
     "--no-pictures --unit-size --output",
     kAnyPlan},
    {"--bootstrap --normals", kPlannedFit},
    {"--seed", kAnyPlan, "--starts --bootstrap"}};

Exit run_plan(const CLI::App& verb, const PlanCall& o) {
  refuse_without_effect(verb, kPlanOptions, o.verb == "fit" ? kPlannedFit : kPlannedStudy, o.verb);
  const work::Plan plan = work::plan_of(o.verb, o.inputs, o.unit_size, o.task);
  work::write_plan(o.output, plan);
  const std::size_t last = plan.units().size() - 1;
  std::cout << io::plural(last + 1, "unit") << ": 0" << (last > 0 ? "-" + std::to_string(last) : "") << '\n';
  return Exit::good;
}

}  // namespace

void add_plan(CLI::App& app) {
  auto options = std::make_shared<PlanCall>();
  PlanCall& o = *options;
  CLI::App* verb = add_verb(app, Purpose::measure, "plan", "Divide long work into units for many processes");
  offer(verb->add_option("VERB", o.verb, "Verb to plan: fit or study")->required(), {"fit", "study"})
      ->check(CLI::IsMember({"fit", "study"}));
  verb->add_option("SAMPLES", o.inputs,
                   "Sample tables (CSV, MERL, ...) or folders of them; for fit also one stack of "
                   "photographs, or one table, with its folds and bootstrap replicates as units")
      ->required();
  add_task_options(*verb, o.task);
  verb->add_option("--unit-size", o.unit_size,
                   "Size of a unit. For a stack: texels, both sides multiples of 8 (64x64). For tables: "
                   "their number (16). For one table: the number of its folds and bootstrap replicates (64)");
  verb->add_option("-o,--output", o.output, "Folder of the job")->required();
  verb->footer(
      "Then `brdf work` does the units, in any order and on any machine that sees the folder, and\n"
      "`brdf collect` puts the results together.\n"
      "Examples: brdf plan fit stack --form cook_torrance --normals fit --unit-size 64x64 -o job\n"
      "          brdf plan fit paint.csv --form ward --bootstrap 1000 --unit-size 100 -o job\n"
      "          brdf plan study measurements/ --no-pictures --unit-size 10 -o job");
  require_every_option(*verb, kPlanOptions);
  on_run(*verb, [options, verb] { return run_plan(*verb, *options); });
}

}  // namespace brdf::cli
