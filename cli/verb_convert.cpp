#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/verbs.h"
#include "io/content.h"
#include "io/error.h"
#include "io/exr_table.h"
#include "io/material_file.h"
#include "io/merl.h"
#include "io/output.h"
#include "io/samples.h"
#include "synth/instrument.h"

namespace brdf::cli {
namespace {

// The table of a sample file; a material is evaluated at the centres of the MERL cells.
io::SampleTable table_of(const std::string& path) {
  io::Content content = io::read_content(path);
  if (!io::is_json(content)) return io::read_samples(std::move(content));
  synth::Instrument instrument;
  instrument.grid.parts = {"merl"};
  io::SampleTable table = synth::measure(io::read_material(content), instrument);
  table.source = path;
  table.format = "material";
  return table;
}

Exit run(const std::string& in, const std::string& out) {
  const std::string suffix = std::filesystem::path(out).extension();
  if (suffix != ".csv" && suffix != ".binary" && suffix != ".exr")
    throw InputError(out + ": unknown output format (known: .csv, .binary for MERL, .exr)");
  io::check_targets({{"OUT", out}}, {in});
  const io::SampleTable table = table_of(in);
  for (const std::string& warning : table.warnings)
    std::cerr << "brdf convert: " << in << ": " << warning << '\n';
  std::vector<std::string> lost;
  if (suffix == ".csv")
    io::write_samples(out, table);
  else if (suffix == ".exr")
    lost = io::write_exr_table(out, table);
  else
    lost = io::merl::write(out, table);
  std::cerr << "brdf convert: " << table.rows() << " rows of " << table.format << " to " << out << '\n';
  for (const std::string& what : lost) std::cerr << "brdf convert: lost: " << what << '\n';
  return Exit::good;
}

}  // namespace

void add_convert(CLI::App& app) {
  struct Options {
    std::string in, out;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("convert", "Convert samples between formats; says what is lost");
  verb->add_option("IN", options->in,
                   "CSV, MERL .binary, RGL or lens-design .bsdf, ASTM E1392 text; or a material's JSON, "
                   "evaluated at the "
                   "MERL cells")
      ->required();
  verb->add_option("OUT", options->out, "File to write: .csv, .binary (MERL) or .exr")->required();
  verb->footer("Example: brdf convert paper.bsdf paper.csv");
  on_run(*verb, [options] { return run(options->in, options->out); });
}

}  // namespace brdf::cli
