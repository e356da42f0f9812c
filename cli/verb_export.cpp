#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options.h"
#include "cli/verbs.h"
#include "io/error.h"
#include "io/glsl.h"
#include "io/material_file.h"
#include "io/merl.h"
#include "io/output.h"
#include "measured/cells.h"
#include "measured/on_sphere.h"

namespace brdf::cli {
namespace {

struct Options {
  io::MaterialChoice material;
  std::string measured, to, output;
  bool include = false;
};

constexpr const char* kMerl = "merl";

// Samples, with what lies between them, as a MERL file.
Exit export_measured(const Options& o) {
  if (o.to != kMerl)
    throw InputError("--measured " + o.measured + " --to " + o.to +
                     ": samples have no formula; --to merl writes them as a table, and a shader is made of a "
                     "fitted material");
  if (o.output.empty()) throw InputError("--to merl: needs -o FILE");
  if (!o.material.form.empty() || !o.material.set.empty() || o.include)
    throw InputError("--measured: goes with --material alone, whose ratio to the samples is interpolated");
  io::check_targets({{"-o", o.output}}, {o.measured, o.material.material});
  std::optional<Material> fitted;
  if (!o.material.material.empty()) fitted = io::read_material(o.material.material);
  const auto seen = measured::seen_in_colour(io::read_samples(o.measured), fitted ? &*fitted : nullptr,
                                             measured::MeasuredReflectance::Beside::likeliest);
  const io::SampleTable cells = measured::at_merl_cells(seen);
  const std::vector<std::string> lost = io::merl::write(o.output, cells);
  std::cerr << "brdf export: " << cells.rows() << " of " << io::merl::kCells << " cells to " << o.output
            << "; -1 where nothing was measured\n";
  for (const std::string& what : lost) std::cerr << "brdf export: lost: " << what << '\n';
  return Exit::good;
}

Exit export_formula(const Options& o) {
  if (o.to == kMerl)
    throw InputError("--to merl: needs --measured SAMPLES; brdf convert writes a material's cells");
  io::check_targets({{"-o", o.output}}, {o.material.material});
  const Material material = io::choose_material(o.material);
  const std::string text =
      io::glsl_source(material, {.material = !o.material.material.empty() || !o.material.set.empty(),
                                 .whole = !o.include,
                                 .dialect = o.to == "glsl-es" ? GlslDialect::es : GlslDialect::vulkan});
  if (o.output.empty())
    std::cout << text;
  else
    io::write_file_atomically(o.output, text);
  return Exit::good;
}

}  // namespace

void add_export(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_verb(app, Purpose::ship, "export",
                            "Write a form or a material as shader source, or samples as a table");
  add_material_options(*verb, options->material);
  verb->add_option("--measured", options->measured,
                   "Samples, with what lies between them; --material: the fit that they are interpolated "
                   "beside");
  verb->add_option("--to", options->to,
                   "glsl (4.50, Vulkan) or glsl-es (3.00, WebGL 2); merl (a .binary) of --measured")
      ->required()
      ->check(CLI::IsMember({"glsl", "glsl-es", kMerl}));
  verb->add_option("-o,--output", options->output, "File to write (default: stdout)");
  verb->add_flag("--include", options->include,
                 "Functions only, for an #include: without #version and main()");
  verb->footer(
      "The output is a whole shader of any stage with an empty main(); of glsl-es with highp as its "
      "precision.\n"
      "With --form alone the functions take the parameters as arguments; with --set or --material a "
      "function\n"
      "brdf_material(wi, wo) with the parameters as constants is added.\n"
      "Examples: brdf export --form ward --to glsl -o ward.glsl\n"
      "          brdf export --form ward --set alpha=0.1 --to glsl\n"
      "          brdf export --material copper.json --to glsl-es --include -o copper.glsl\n"
      "          brdf export --measured copper.csv --material copper.json --to merl -o copper.binary");
  on_run(*verb, [options] {
    return options->measured.empty() ? export_formula(*options) : export_measured(*options);
  });
}

}  // namespace brdf::cli
