#include "cli/steps/several_tables.h"

#include <CLI/CLI.hpp>

#include "cli/options/fit_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "io/files/output.h"
#include "io/formats/read.h"

namespace brdf::cli {

void add_table_options(CLI::App& verb, SeveralTables& o, const std::string& description) {
  verb.add_option("SAMPLES", o.samples, description)->required();
  add_fit_options(verb, o.choice);
  verb.add_option("--report", o.page, "HTML report to write");
  verb.add_flag("--json", o.json, "JSON on stdout");
}

std::vector<fit::TableToFit> tables_to_fit(const SeveralTables& o, const std::string& verb) {
  text_stream({{"--report", o.page}}, o.json);  // throws before any file is read
  io::check_targets({{"--report", o.page}}, {o.samples.begin(), o.samples.end()});
  const fit::FitOptions options = fit_options(o.choice, 1);
  std::vector<fit::TableToFit> tables;
  for (const std::string& file : o.samples) {
    fit::Samples samples = fit::arranged(
        io::read_samples(file, io::supplied_for(options.supplied, options.arrangement)), options);
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
