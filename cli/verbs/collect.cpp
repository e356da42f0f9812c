#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/fit_options.h"
#include "cli/options/options.h"
#include "cli/program/planned.h"
#include "io/files/error.h"
#include "io/files/json.h"

namespace brdf::cli {
namespace {

struct CollectCall {
  std::string job, output, report;
  bool missing = false, json = false;
};

void print_json(const std::vector<work::UnitState>& states, const std::string& missing) {
  io::Json out = io::to_json(io::provenance());
  out["missing"] = missing;
  out["results"] = io::Json::array();
  for (std::size_t unit = 0; unit < states.size(); ++unit)
    out["results"].push_back({{"unit", unit}, {"state", std::string(name_of(states[unit]))}});
  std::cout << io::to_text(out);
}

Exit run_collect(const CollectCall& o) {
  if (o.output.empty() && !o.missing && !o.json)
    throw InputError("collect needs -o FOLDER, or --missing or --json to ask for the units");
  if (o.json && (!o.output.empty() || !o.report.empty()))
    throw InputError("--json: nothing is collected: leave out -o and --report, or leave out --json");
  if (o.json && o.missing)
    throw InputError("--missing: --json states the missing units too: leave one of them out");
  const CollectFiles files{work::absolute(o.output), work::absolute(o.report)};
  const work::Task task = planned(o.job);
  std::vector<work::UnitState> states(task.plan().units().size());
  std::vector<std::size_t> open;
  for (std::size_t unit = 0; unit < states.size(); ++unit) {
    states[unit] = work::state_of(task.job(), task.plan(), unit);
    if (states[unit] != work::UnitState::done) open.push_back(unit);
  }
  const std::string missing = work::array_text(open);
  if (o.json) print_json(states, missing);
  if (!open.empty()) {
    if (o.missing && !o.json)
      std::cout << missing << '\n';
    else if (!o.json)
      std::cerr << "brdf collect: " << open.size() << " of " << states.size()
                << (open.size() == 1 ? " units is" : " units are") << " missing or damaged: " << missing
                << '\n';
    return Exit::failed;
  }
  return o.output.empty() || o.json ? Exit::good : put_together(task, files);
}

}  // namespace

void add_collect(CLI::App& app) {
  auto options = std::make_shared<CollectCall>();
  CollectCall& o = *options;
  CLI::App* verb = add_verb(app, Purpose::measure, "collect",
                            "Combine the results of planned work, or list the missing units");
  verb->add_option("JOB", o.job, "Folder of `brdf plan`")->required();
  verb->add_option(
      "-o,--output", o.output,
      "Folder of the results, the same files as the verb writes; for one table its material file");
  verb->add_option("--report", o.report, "HTML report to write");
  verb->add_flag("--missing", o.missing,
                 "If units are missing or damaged, print their numbers for a job array: 3,7,12-19");
  verb->add_flag("--json", o.json, "The state of every unit as JSON on stdout; nothing is collected");
  verb->footer(
      "Exit code 1 if units are missing.\n"
      "Examples: brdf collect job -o maps/ --report maps.html\n"
      "          brdf collect job -o paint.json --report paint.html\n"
      "          brdf collect job --missing\n"
      "          brdf collect job --json");
  on_run(*verb, [options] { return run_collect(*options); });
}

}  // namespace brdf::cli
