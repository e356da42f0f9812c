#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options.h"
#include "cli/verbs.h"
#include "io/any_table.h"
#include "io/output.h"
#include "synth/instrument.h"

namespace brdf::cli {
namespace {

Exit run(const std::string& in, const std::string& out, const io::Arrangement& arrangement) {
  io::check_table_format(out);
  io::check_targets({{"OUT", out}}, {in});
  io::SampleTable table = synth::table_of_file(in);
  io::arrange(table, arrangement);
  for (const std::string& warning : table.warnings)
    std::cerr << "brdf convert: " << in << ": " << warning << '\n';
  const std::vector<std::string> lost = io::write_table(out, table);
  std::cerr << "brdf convert: " << table.rows() << " rows of " << table.format << " to " << out << '\n';
  for (const std::string& what : lost) std::cerr << "brdf convert: lost: " << what << '\n';
  return Exit::good;
}

}  // namespace

void add_convert(CLI::App& app) {
  struct Options {
    std::string in, out;
    io::Arrangement arrangement;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      add_verb(app, Purpose::measure, "convert", "Convert samples between formats; says what is lost");
  verb->add_option("IN", options->in,
                   "CSV, MERL .binary, RGL or lens-design .bsdf, ASTM E1392 text; or a material's JSON, "
                   "evaluated at the "
                   "MERL cells")
      ->required();
  verb->add_option(
          "OUT", options->out,
          "File to write: .csv, .binary (MERL), .exr, .astm (ASTM E1392) or .zemax (lens-design text)")
      ->required();
  add_arrangement_options(*verb, options->arrangement);
  verb->footer(
      "Examples: brdf convert paper.bsdf paper.csv\n"
      "          brdf convert scan.csv scan.zemax\n"
      "          brdf convert polarised.csv mean.csv --polarisation average --repeats average");
  on_run(*verb, [options] { return run(options->in, options->out, options->arrangement); });
}

}  // namespace brdf::cli
