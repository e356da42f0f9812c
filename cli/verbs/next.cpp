#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/options/fit_options.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "fit/design/next_report.h"
#include "io/csv/csv.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/provenance.h"
#include "io/files/standard_input.h"
#include "io/formats/read.h"

namespace brdf::cli {
namespace {

struct NextCall {
  std::string samples, reach, output;
  fit::FitChoice choice;
  fit::NextOptions next;
  bool json = false;
};

Exit run_next(const NextCall& o) {
  const fit::FitOptions options = fit_options(o.choice, 1);
  const TextStream stream = text_stream({{"-o", o.output}}, o.json);  // throws before any file is read
  io::check_targets({{"-o", o.output}});
  const fit::NextModels models = fit::next_models(o.choice.form, o.next);
  const io::Supplied supplied = io::supplied_for(options.supplied, options.arrangement);
  const fit::Samples samples = fit::arranged(io::read_samples(o.samples, supplied), options);
  keep_budget({{"-o", o.output}}, samples);
  for (const std::string& warning : samples.table.warnings)
    Warning() << "brdf next: " << io::input_name(o.samples) << ": " << warning;
  const io::SampleTable reach = io::read_directions(o.reach);
  for (const std::string& warning : reach.warnings) Warning() << "brdf next: " << o.reach << ": " << warning;
  const fit::NextDirections next =
      fit::next_directions(samples, reach, models.models, options, models.next, step_line("brdf next"));
  if (!o.output.empty()) {
    io::SampleTable table = fit::table_of(next);
    for (auto& field : io::provenance_fields(io::provenance(next.seed)))
      table.metadata.push_back(std::move(field));
    io::write_samples(o.output, table);
  }
  const fit::NextSources sources{io::input_name(o.samples), io::input_name(o.reach)};
  if (o.json) {
    std::cout << io::to_text(fit::to_json(next, sources));
  } else {
    PlainText out(stream);
    fit::print(out, next, sources);
  }
  return Exit::good;
}

}  // namespace

void add_next(CLI::App& app) {
  auto options = std::make_shared<NextCall>();
  NextCall& o = *options;
  CLI::App* verb = add_verb(app, Purpose::measure, "next", "Choose the directions to measure next");
  verb->add_option("SAMPLES", o.samples,
                   "Table of the rows measured so far (CSV, MERL, ...; - for standard input)")
      ->required();
  verb->add_option("--reach", o.reach,
                   "Table of the directions that the instrument can take: theta_i, phi_i, theta_o, phi_o in "
                   "degrees; values in it are not used")
      ->required();
  verb->add_option("--rows", o.next.rows, "Number of rows to choose")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{1}, fit::NextOptions::kMostRows));
  add_named_option(
      *verb, "--aim", o.next.aim,
      "Purpose of the rows: the least expected error of the best form over the hemisphere, or to "
      "tell the two best forms apart; auto: forms if two forms are named, or if the two best of "
      "several are within a standard error of each other");
  verb->add_option(
      "--noise", o.next.noise,
      "Relative standard deviation of a reading (default: from sigma columns, from rows that must "
      "agree, or from the residuals)");
  verb->add_option("--model-error", o.next.model_error,
                   "Relative standard deviation of the form from the surface (default: from the residuals)");
  add_fit_options(*verb, o.choice);
  verb->add_option("-o,--output", o.output, "CSV of the chosen directions to write (- for standard output)");
  verb->add_flag("--json", o.json, "JSON on stdout");
  verb->footer(
      "The choice trusts the form as far as its error is known. An error of the form is taken from the "
      "residuals; below " +
      io::short_number(fit::kFewValues) + " values per parameter it is assumed to be " +
      io::short_number(fit::kAssumedError) +
      " times the noise. An error that the measured rows do not show is not taken into account: a choice "
      "without it can be worse than a choice at random, so state --model-error if the form is in doubt. The "
      "result is for a fit in first order about the present parameters; choose again when they have "
      "moved.\n"
      "Examples: brdf next samples.csv --reach directions.csv --form cook_torrance --fix f0=0.04 --rows 8\n"
      "          brdf next samples.csv --reach directions.csv --noise 0.01 --model-error 0.02 -o next.csv\n"
      "          brdf next samples.csv --reach directions.csv --form ward --form cook_torrance --json\n"
      "          brdf next samples.csv --reach directions.csv --form all --aim prediction --seed 2");
  on_run(*verb, [options] { return run_next(*options); });
}

}  // namespace brdf::cli
