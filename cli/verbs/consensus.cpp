#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/several_tables.h"
#include "cli/verb.h"
#include "fit/between/round_robin_report.h"
#include "io/files/error.h"

namespace brdf::cli {
namespace {

struct ConsensusCall {
  SeveralTables tables;
  std::vector<std::string> at;
  std::vector<double> albedo;
};

constexpr OptionOf kConsensusOptions[] = {kTableOptions[0], kTableOptions[1], {"--at --albedo", 1}};

Exit run_consensus(const CLI::App& verb, const ConsensusCall& o) {
  refuse_without_effect(verb, kConsensusOptions, 1, "a consensus");
  fit::AskedQuantities asked{{}, o.albedo};
  for (const std::string& text : o.at) asked.at.push_back(fit::asked_directions("--at", text));
  if (asked.at.empty()) asked.at.emplace_back();
  const auto models = fit::models_of(o.tables.choice.form);
  std::vector<fit::TableToFit> tables = tables_to_fit(o.tables, "consensus");
  const fit::RoundRobin result =
      fit::round_robin(fit::fit_tables(tables, models, step_line("brdf consensus")), asked);
  if (!o.tables.page.empty()) write_page(o.tables, fit::html_page(result));
  if (o.tables.json) {
    std::cout << io::to_text(fit::to_json(result));
  } else {
    const TextStream stream = text_stream({{"--report", o.tables.page}});
    PlainText out(stream);
    fit::print(out, result);
  }
  if (!o.tables.json) print_next_step({open_page(o.tables.page)});
  return result.is_decided() ? Exit::good : Exit::undecided;
}

}  // namespace

void add_consensus(CLI::App& app) {
  auto options = std::make_shared<ConsensusCall>();
  CLI::App* verb = add_verb(app, Purpose::measure, "consensus",
                            "Compute the consensus of several laboratories' tables of one surface");
  add_table_options(*verb, options->tables, "At least two tables of the same surface");
  add_repeated_option(
      *verb, "--at", options->at,
      "Directions of a value of f: THETA_I:THETA_O or THETA_I:THETA_O:PHI, degrees; PHI is the "
      "azimuth from the light to the viewer (default: 0:45, and PHI 180, the mirror side)");
  verb->add_option("--albedo", options->albedo,
                   "Polar angles of incidence of a directional albedo, degrees, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(0.0, 89.5));
  verb->footer(
      "All tables are fitted with the same form and metric. The logarithms of f and of each parameter are\n"
      "combined by the method of Mandel and Paule; the interval uses Student's t with one degree of freedom\n"
      "less than tables. Laboratories are taken as independent.\n"
      "Without budgets the uncertainties of the tables are scatter alone, and everything else is between\n"
      "laboratories. Exit code 4 if a quantity has no consensus; the reason is printed.\n"
      "Examples: brdf consensus lab_1.csv lab_2.csv lab_3.csv --form cook_torrance --fix f0=0.04\n"
      "          brdf consensus lab_1.csv lab_2.csv lab_3.csv --form ward --at 0:45 --at 45:0 --report "
      "round_robin.html\n"
      "          brdf consensus lab_1.csv lab_2.csv --form ward --budget budget_1.csv --budget budget_2.csv\n"
      "          brdf consensus lab_1.csv lab_2.csv lab_3.csv --form cook_torrance --albedo 8,45 --json");
  require_every_option(*verb, kConsensusOptions);
  on_run(*verb, [options, verb] { return run_consensus(*verb, *options); });
}

}  // namespace brdf::cli
