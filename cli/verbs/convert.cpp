#include <CLI/CLI.hpp>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "interop/rgl.h"
#include "io/columns/foreign_json.h"
#include "io/columns/supplied.h"
#include "io/csv/csv.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/standard_input.h"
#include "io/formats/any_table.h"
#include "io/formats/read.h"
#include "io/material/material_file.h"
#include "measured/measured.h"
#include "sheet/data_sheet.h"
#include "synth/instrument.h"

namespace brdf::cli {
namespace {

struct ConvertCall {
  std::string in, out;
  io::Arrangement arrangement;
  io::Supplied supplied;
  bool keep_fill = false;
};

void arrange(const ConvertCall& o, io::SampleTable& table) {
  if (!o.keep_fill) sheet::leave_out(sheet::not_measured(table), table);
  io::arrange(table, o.arrangement);
}

// Returns a material, or samples with interpolated values between them.
Material between_samples(const ConvertCall& o) {
  const std::string& in = o.in;
  io::Content content = io::read_content(in);
  if (io::may_be_material(content)) return io::read_material(content);
  io::SampleTable table = io::read_samples(std::move(content), io::supplied_for(o.supplied, o.arrangement));
  arrange(o, table);
  const auto seen = std::make_shared<const measured::MeasuredReflectance>(std::move(table));
  if (seen->turning() == measured::Turning::turned)
    throw InputError(io::input_name(in) +
                     ": the samples were turned, and an RGL file is written for one azimuth");
  return measured::material_of(seen);
}

Exit to_rgl(const ConvertCall& o) {
  const std::string& out = o.out;
  io::check_targets({{"OUT", out}});
  const std::string bytes = interop::rgl_of(between_samples(o), std::filesystem::path(o.in).stem().string());
  io::write_file_atomically(out, bytes);
  Note() << "brdf convert: " << bytes.size() << " bytes to " << out;
  Warning() << "brdf convert: lost: the measured directions; values between them are interpolated "
               "(export --to rgl --measured interpolates with the help of a fit)";
  print_next_step({view_command(out)}, TextStream::error);
  return Exit::good;
}

Exit run_convert(const ConvertCall& o) {
  const std::string &in = o.in, &out = o.out;
  if (out.ends_with(".bsdf")) return to_rgl(o);
  if (!is_stream(out)) io::check_table_format(out);
  io::check_targets({{"OUT", out}});
  io::SampleTable table =
      synth::table_of_file(in, io::supplied_for(o.supplied, o.arrangement), synth::cells_for(out));
  arrange(o, table);
  for (const std::string& warning : table.warnings)
    Warning() << "brdf convert: " << io::input_name(in) << ": " << warning;
  std::vector<std::string> lost;
  if (is_stream(out))
    io::write_samples(out, table);
  else
    lost = io::write_table(out, table);
  Note() << "brdf convert: " << io::plural(table.rows(), "row") << " of " << table.format << " to " << out;
  for (const std::string& what : lost) Warning() << "brdf convert: lost: " << what;
  print_next_step({view_command(out)}, TextStream::error);
  return Exit::good;
}

}  // namespace

void add_convert(CLI::App& app) {
  auto options = std::make_shared<ConvertCall>();
  CLI::App* verb =
      add_verb(app, Purpose::measure, "convert", "Convert samples between formats and report the losses");
  verb->add_option(
          "IN", options->in,
          "Samples in any format that is read (docs/formats.md lists them); or a material's JSON, evaluated "
          "at the MERL cells, for .xml as means over the patches")
      ->required();
  verb->add_option(
          "OUT", options->out,
          "File to write: .csv, .binary (MERL), .exr, .bsdf (RGL), .astm (ASTM E1392), .zemax (lens-design "
          "text), .xompt (OpenMATERIAL), .brdf (BiRD) or .xml (Klems matrices); - for CSV on standard output")
      ->required();
  add_keep_fill_option(*verb, options->keep_fill);
  add_arrangement_options(*verb, options->arrangement);
  add_supplied_options(*verb, options->supplied);
  verb->add_option(
      "--matrix", options->supplied.matrix,
      "Klems XML: words of the matrix to read, such as 'back visible', 'solar' or 'nm' (default: "
      "front, visible)");
  verb->footer(
      "Examples: brdf convert paper.bsdf paper.csv\n"
      "          brdf convert paper.csv paper.bsdf\n"
      "          zcat paper.csv.gz | brdf convert - - --repeats average\n"
      "          brdf convert scan.csv scan.zemax --keep-fill\n"
      "          brdf convert copper.json copper.xml\n"
      "          brdf convert window.xml back.csv --matrix 'back solar'\n"
      "          brdf convert polarised.csv mean.csv --polarisation average --repeats average\n"
      "          brdf convert reflectance_factors.csv f_r.csv --quantity 'BRF %' --mirror-side negative\n"
      "          brdf convert lab.txt f_r.csv --layout lab.json");
  on_run(*verb, [options] { return run_convert(*options); });
}

}  // namespace brdf::cli
