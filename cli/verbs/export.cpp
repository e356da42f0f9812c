#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/program/exported.h"
#include "cli/program/written_maps.h"
#include "cli/program/written_table.h"
#include "cli/verb.h"
#include "interop/programs.h"
#include "interop/table_layouts.h"
#include "io/columns/foreign_json.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/provenance.h"

namespace brdf::cli {
namespace {

void print_json(const ExportCall& o, const io::Json& made) {
  erase_progress();
  io::Json json{{"to", o.to}};
  if (made["kind"] != "refused") json["output"] = o.output;
  json.update(made);
  json["provenance"] = io::to_json(io::provenance());
  std::cout << io::to_text(json);
}

// Throws for an option that has no effect on the target, instead of ignoring the option.
void check_use(const ExportCall& o, const interop::Program* program) {
  if ((program || o.to == kMerl || o.to == kRgl || is_lookup_table(o.to)) &&
      (o.include || o.kernels != "own"))
    throw InputError(std::string(o.include ? "--include" : "--kernels") + ": applies to shaders only");
  if (!o.name.empty() &&
      (o.to == kMerl || o.to == "explorer" || is_lookup_table(o.to) || !o.measured.empty()))
    throw InputError("--name: " + (o.measured.empty() ? "--to " + o.to : "--measured") +
                     " writes no name of a material");
  if (o.to != kRgl && o.size != interop::kUsualTable) throw InputError("--size: applies to --to rgl only");
  if (!program && o.naive)
    throw InputError("--naive: --to " + o.to + " has no parameters of another formula that could be copied");
  if (o.table_layout != "brdf" && (!is_lookup_table(o.to) || o.to == "ltc"))
    throw InputError("--table-layout: applies to --to dfg and albedo only");
  if (o.max_loss && is_lookup_table(o.to))
    throw InputError("--max-loss: --to " + o.to +
                     " states the difference of a reading, which is no loss of f");
  if (o.max_loss && !o.measured.empty())
    throw InputError("--max-loss: needs a material, because the values between samples are not known");
  if (o.max_loss && o.kernels != "own")
    throw InputError(
        "--max-loss: cannot be judged with --kernels builtin, because the accuracy of the driver's functions "
        "is not known");
}

// Samples that are given as MATERIAL are used like samples of --measured. A pipe can be read only once and is
// assumed to contain a material.
void take_samples(ExportCall& o) {
  const std::string& file = o.material.material;
  if (!o.is_positional || !o.measured.empty() || !std::filesystem::is_regular_file(file) ||
      io::may_be_material(io::read_content(file)))
    return;
  o.measured = file;
  o.material.material.clear();
}

Exit run_export(ExportCall& o) {
  const interop::Program* program = interop::find_program(o.to);
  take_samples(o);
  check_use(o, program);
  o.step = step_line("brdf export");
  if (!o.json) {
    const Exit exit = made_by(o, program).exit;
    erase_progress();
    if (o.to == kMerl || o.to == kRgl) print_next_step({view_command(o.output)}, TextStream::error);
    return exit;
  }
  if (o.output.empty() || is_stream(o.output))
    throw InputError("--json: needs -o FILE for the exported text");
  try {
    const Made made = made_by(o, program);
    print_json(o, made.json);
    return made.exit;
  } catch (const interop::Refused& refused) {
    print_json(o, {{"kind", "refused"}, {"refused", {{{"reason", refused.what()}}}}});
    throw;
  }
}

std::vector<std::string> target_names() {
  std::vector<std::string> names{"glsl", "glsl-es", "hlsl", "cpp", "explorer", kMerl, kRgl};
  names.insert(names.end(), std::begin(kTables), std::end(kTables));
  for (const interop::Program& program : interop::programs()) names.emplace_back(program.name);
  return names;
}

std::vector<std::string> layout_names() {
  std::vector<std::string> names;
  for (const interop::TableLayout& layout : interop::table_layouts()) names.emplace_back(layout.name);
  return names;
}

}  // namespace

void add_export(CLI::App& app) {
  auto options = std::make_shared<ExportCall>();
  CLI::App* verb = add_verb(app, Purpose::ship, "export",
                            "Write a material for another program or as a shader, or samples as a table");
  add_material_options(*verb, options->material);
  add_material_argument(*verb, options->material);
  verb->add_option("--measured", options->measured,
                   "Samples to export, with interpolated values between them; MATERIAL is the fit that "
                   "guides the interpolation");
  verb->add_option(
          "--to", options->to,
          "glsl (4.50, Vulkan), glsl-es (3.00, WebGL 2), hlsl, cpp (a header) or explorer (a .brdf with "
          "sliders); merl (a .binary) and rgl (a .bsdf, which Mitsuba and pbrt import); dfg, albedo and "
          "ltc (lookup tables, .exr); "
          "or a program")
      ->required()
      ->check(CLI::IsMember(target_names()));
  verb->add_option(
      "--maps", options->maps,
      "Fitted maps to export as textures: maps.exr of brdf fit STACK, for " + io::joined(textured_names()));
  verb->add_option("--loss-map", options->loss_map,
                   "OpenEXR image to write with the losses of every texel of --maps");
  verb->add_option("-o,--output", options->output, "File to write (default: stdout)");
  verb->add_option("--kernels", options->kernels,
                   "exp, log and similar functions: own (of the library, bit for bit) or builtin (of the "
                   "language, easier to read)")
      ->check(CLI::IsMember({"own", "builtin"}))
      ->capture_default_str();
  verb->add_flag("--include", options->include,
                 "Write only functions, for an #include: without #version and main()");
  verb->add_option("--name", options->name,
                   "The material's name there (default: its own name, its file's or the form's); two in one "
                   "shader need two");
  verb->add_flag("--naive", options->naive,
                 "Copy the parameters, as one does by hand, instead of refitting them");
  verb->add_option("--max-loss", options->max_loss,
                   "Largest loss, the rms difference of ln(1 + f cos_i), about a relative error; exit code 1 "
                   "if the loss is larger")
      ->check(CLI::NonNegativeNumber);
  verb->add_option("--table-layout", options->table_layout,
                   "Program whose axes, size and channels the table of --to dfg or albedo has")
      ->check(CLI::IsMember(layout_names()))
      ->capture_default_str();
  verb->add_flag("--json", options->json,
                 "JSON on stdout: the loss, the loss of copied parameters, and refused properties");
  add_supplied_options(*verb, options->supplied);
  add_memory_option(*verb, options->size, "--size", "Approximate size of the file of --to rgl (default 4M)");
  verb->footer(
      "A program (blender, mitsuba, pbrt, materialx, ...) gets the material in its own formula: exactly, if "
      "the\n"
      "library has the same formula, otherwise refitted. The loss is printed and written into the file. A\n"
      "property that the program cannot hold is refused (docs/interop.md).\n"
      "A shader is written whole, for any stage, with an empty main(); glsl-es has the precision highp.\n"
      "With --form alone the functions take the parameters as arguments. With --set or MATERIAL a function\n"
      "brdf_material(wi, wo) with constant parameters is added. With --include, in HLSL and in C++, several\n"
      "texts can be combined: each material is brdf_material_NAME, in C++ NAME::brdf_material.\n"
      "Examples: brdf export --form ward --to glsl -o ward.glsl\n"
      "          brdf export --form ward --set alpha=0.1 --to glsl\n"
      "          brdf export --form ward --to glsl --kernels builtin\n"
      "          brdf export copper.json --to glsl-es --include -o copper.glsl\n"
      "          brdf export gold.json --name inlay --to glsl-es --include -o inlay.glsl\n"
      "          brdf export --form ward --to explorer -o ward.brdf\n"
      "          brdf export copper.json --to blender --max-loss 0.01 -o copper.py\n"
      "          brdf export copper.json --to gltf --naive\n"
      "          brdf export copper.json --to materialx -o copper.mtlx --json\n"
      "          brdf export copper.json --to merl -o copper.binary\n"
      "          brdf export copper.json --to rgl --size 25M -o copper.bsdf\n"
      "          brdf export --form cook_torrance --to dfg --table-layout filament -o dfg.exr\n"
      "          brdf export --form cook_torrance_beckmann --to ltc -o ltc.exr\n"
      "          brdf export copper.json --measured copper.csv --to merl -o copper.binary\n"
      "          brdf export --maps maps/maps.exr --to gltf --loss-map loss.exr -o painting.glb\n"
      "          brdf export plane.csv --quantity BRF --mirror-side negative --to merl -o "
      "plane.binary");
  on_run(*verb, [options, verb] {
    options->is_positional = verb->count("MATERIAL") > 0;
    return run_export(*options);
  });
}

}  // namespace brdf::cli
