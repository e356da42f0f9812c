#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/several_tables.h"
#include "cli/verb.h"
#include "fit/between/difference_report.h"
#include "io/files/error.h"

namespace brdf::cli {
namespace {

Exit exit_of(const fit::Difference& difference) {
  switch (difference.sameness) {
    case fit::Sameness::no_difference:
      return Exit::good;
    case fit::Sameness::different:
      return Exit::failed;
    default:
      return Exit::undecided;
  }
}

Exit run_compare(const CLI::App& verb, const SeveralTables& o) {
  refuse_without_effect(verb, kTableOptions, 1, "a comparison");
  const auto models = fit::models_of(o.choice.form);
  if (o.samples.size() != 2) throw InputError("SAMPLES: two tables are compared");
  const std::vector<fit::TableToFit> tables = tables_to_fit(o, "compare");
  const fit::Comparison comparison = fit::compare_tables(tables, models, step_line("brdf compare"));
  if (!o.page.empty()) write_page(o, fit::html_page(comparison, tables));
  if (o.json) {
    std::cout << io::to_text(fit::to_json(comparison));
  } else {
    const TextStream stream = text_stream({{"--report", o.page}});
    PlainText out(stream);
    fit::print(out, comparison);
  }
  if (!o.json) print_next_step({open_page(o.page)});
  return exit_of(comparison.difference);
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<SeveralTables>();
  CLI::App* verb = add_verb(app, Purpose::measure, "compare",
                            "Decide whether two tables are of the same surface, within their budgets");
  add_table_options(*verb, *options, "Two tables");
  verb->footer(
      "Both tables are fitted with the same form and metric. The difference of the logarithms of the\n"
      "parameters is compared with the uncertainty of both tables, and with the scale error, zero error or\n"
      "aperture that would explain the difference alone.\n"
      "Exit code 0: no difference beyond the budgets. 1: different. 4: it cannot be told, because the "
      "tables\n"
      "have no budgets, or because the fits do not allow it; the reason is printed.\n"
      "Examples: brdf compare before.csv after.csv --form cook_torrance --fix f0=0.04 --budget "
      "goniometer.csv\n"
      "          brdf compare before.csv after.csv --form auto --report difference.html\n"
      "          brdf compare before.csv after.csv --form ward --json");
  require_every_option(*verb, kTableOptions);
  on_run(*verb, [options, verb] { return run_compare(*verb, *options); });
}

}  // namespace brdf::cli
