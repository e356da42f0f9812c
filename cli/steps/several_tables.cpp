#include "cli/steps/several_tables.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "cli/options/fit_options.h"
#include "cli/options/options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/formats/read.h"

namespace brdf::cli {

void add_table_options(CLI::App& verb, SeveralTables& o, const std::string& description) {
  verb.add_option("SAMPLES", o.samples, description)->required();
  add_fit_options(verb, o.choice);
  add_repeated_option(
      verb, "--budget", o.budgets,
      "Uncertainty budget of an instrument, a table: once for all tables, or once for each in "
      "their order (default: the budget that each file names)");
  verb.add_option("--report", o.page, "HTML report to write");
  verb.add_flag("--json", o.json, "JSON on stdout");
}

namespace {

// Returns the budget of each table; null if no option names one.
std::vector<std::shared_ptr<const io::Budget>> budgets_of(const SeveralTables& o) {
  if (o.budgets.size() > 1 && o.budgets.size() != o.samples.size())
    throw InputError("--budget: given " + io::plural(o.budgets.size(), "time") + " for " +
                     io::plural(o.samples.size(), "table") +
                     ": must be given once for all tables, or once for each of them");
  std::vector<std::shared_ptr<const io::Budget>> out(o.samples.size());
  for (std::size_t t = 0; t < out.size() && !o.budgets.empty(); ++t)
    out[t] = o.budgets.size() == 1 && t > 0
                 ? out[0]
                 : std::make_shared<const io::Budget>(io::read_budget(o.budgets[t]));
  return out;
}

// Throws for a table that is named twice: it would count as two measurements.
void require_different(const std::vector<std::string>& samples) {
  for (std::size_t a = 0; a < samples.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      std::error_code unreadable;
      if (samples[a] == samples[b] || std::filesystem::equivalent(samples[a], samples[b], unreadable))
        throw InputError(
            "SAMPLES: " + samples[a] +
            (samples[a] == samples[b] ? " is named twice" : " is the same file as " + samples[b]) +
            ": one measurement would count as two; name different tables");
    }
}

}  // namespace

std::vector<fit::TableToFit> tables_to_fit(const SeveralTables& o, const std::string& verb) {
  text_stream({{"--report", o.page}}, o.json);  // throws before any file is read
  io::check_targets({{"--report", o.page}});
  require_different(o.samples);
  const std::vector<std::shared_ptr<const io::Budget>> budgets = budgets_of(o);
  fit::FitOptions options = fit_options(o.choice, 1);
  std::vector<fit::TableToFit> tables;
  for (std::size_t t = 0; t < o.samples.size(); ++t) {
    const std::string& file = o.samples[t];
    options.budget = budgets[t];
    fit::Samples samples = fit::arranged(
        io::read_samples(file, io::supplied_for(options.supplied, options.arrangement)), options);
    keep_budget({{"--report", o.page}}, samples);
    for (const std::string& warning : samples.table.warnings)
      Warning() << "brdf " << verb << ": " << file << ": " << warning;
    tables.push_back({std::move(samples), options});
  }
  return tables;
}

void write_page(const SeveralTables& o, const std::string& html) {
  if (!o.page.empty()) io::write_file_atomically(o.page, html);
}

}  // namespace brdf::cli
