#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/written_maps.h"
#include "cli/steps/written_table.h"
#include "cli/verb.h"
#include "interop/programs.h"
#include "interop/read_back.h"
#include "interop/rgl.h"
#include "interop/table_layouts.h"
#include "interop/told.h"
#include "io/columns/foreign_json.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/files/standard_input.h"
#include "io/formats/merl.h"
#include "io/formats/read.h"
#include "io/material/glsl.h"
#include "io/material/material_json.h"
#include "io/material/shader_texts.h"
#include "measured/cells.h"
#include "measured/on_sphere.h"
#include "synth/instrument.h"

namespace brdf::cli {
namespace {

struct ExportCall {
  MaterialOptions material;
  std::string measured, maps, loss_map, to, output, name, kernels = "own", table_layout = "brdf";
  bool include = false, naive = false, json = false, is_positional = false;
  std::optional<double> max_loss;
  io::Supplied supplied;
  std::uint64_t size = interop::kUsualTable;
  std::function<void(const std::string&)> step;  // shows the current step on a terminal
};

constexpr const char *kMerl = "merl", *kRgl = "rgl";

// Additional content of --json, and the exit code.
struct Made {
  io::Json json;
  Exit exit = Exit::good;
};

// Compares the loss with --max-loss.
Exit judged_loss(const ExportCall& o, const interop::Loss& loss) {
  if (!o.max_loss || loss.rms <= *o.max_loss) return Exit::good;
  Warning() << "brdf export: the loss is above --max-loss " << io::short_number(*o.max_loss);
  return Exit::failed;
}

// Reports the loss of a table as its users' programs read it back, and stores the loss in `json`.
Exit say_table_loss(const ExportCall& o, const Material& wanted, const Material& table, io::Json& json) {
  const std::optional<interop::Loss> loss = interop::loss_of_table(wanted, table);
  if (!loss) {
    Warning() << "brdf export: how much is lost is not known: the file has other channels than the material";
    if (!o.max_loss) return Exit::good;
    Warning() << "brdf export: --max-loss " << io::short_number(*o.max_loss) << " is not shown to hold";
    return Exit::failed;
  }
  Note() << "brdf export: read back as the file's users do: " << interop::in_words(*loss);
  json["loss"] = interop::to_json(*loss);
  return judged_loss(o, *loss);
}

void write(const ExportCall& o, const std::string& text) {
  erase_progress();
  if (o.output.empty())
    std::cout << text;
  else
    io::write_file_atomically(o.output, text);
}

// Returns the name of the exported material: the value of --name, or the material's own name, or the name of
// its file or form.
std::string exported_name(const ExportCall& o, const io::MaterialFile& file) {
  if (!o.name.empty()) return o.name;
  if (!file.name.empty()) return file.name;
  return o.material.form.empty() ? std::filesystem::path(o.material.material).stem().string()
                                 : o.material.form;
}

void check_measured(const ExportCall& o) {
  if (o.to != kMerl && o.to != kRgl)
    throw InputError(
        "--measured " + o.measured + " --to " + o.to +
        ": samples have no formula; --to merl and --to rgl write them as a table, and a shader is made "
        "of a fitted material");
  if (!o.material.form.empty() || !o.material.set.empty())
    throw InputError(
        "--measured: needs MATERIAL alone; the ratio of the samples to the material is interpolated");
}

void check_output(const ExportCall& o) {
  if (o.output.empty()) throw InputError("--to " + o.to + ": needs -o FILE");
  require_file({"-o", o.output}, "--to " + o.to + " writes a binary table");
  io::check_targets({{"-o", o.output}}, {o.measured, o.material.material, o.material.shader.file});
}

// Reads the samples and interpolates between them.
std::shared_ptr<const measured::MeasuredReflectance> seen(const ExportCall& o) {
  std::optional<Material> fitted;
  if (!o.material.material.empty()) fitted = io::read_material(o.material.material);
  io::SampleTable samples = io::read_samples(o.measured, o.supplied);
  for (const std::string& sentence : samples.assumptions)
    Warning() << "brdf export: " << io::input_name(o.measured) << ": " << sentence;
  return measured::seen_in_colour(std::move(samples), fitted ? &*fitted : nullptr,
                                  measured::MeasuredReflectance::Beside::likeliest);
}

io::SampleTable at_merl_cells(const Material& material) {
  if (is_anisotropic(material))
    throw interop::Refused("--to merl: the material is anisotropic, and MERL files are isotropic");
  synth::Instrument instrument;
  instrument.grid.parts = {kMerl};
  return synth::measure(material, instrument);
}

Made export_merl(const ExportCall& o) {
  check_output(o);
  const bool measured = !o.measured.empty();
  std::optional<Material> material;
  if (!measured) material = choose_material_file(o.material, "export").material;
  o.step("computing the values of the cells");
  const io::SampleTable cells = material ? at_merl_cells(*material) : measured::at_merl_cells(seen(o));
  const std::vector<std::string> lost = io::merl::write(o.output, cells);
  Note() << "brdf export: " << cells.rows() << " of " << io::merl::kCells << " cells to " << o.output
         << "; -1 " << (measured ? "where nothing was measured" : "below the horizon");
  for (const std::string& what : lost) Warning() << "brdf export: lost: " << what;
  Made made{{{"kind", "table"}, {"cells", cells.rows()}, {"lost", lost}}};
  o.step("comparing the file with the material");
  if (material)
    made.exit = say_table_loss(o, *material, interop::read_back_merl(io::read_content(o.output)), made.json);
  return made;
}

Made export_rgl(const ExportCall& o) {
  check_output(o);
  std::string bytes;
  std::optional<Material> material;
  o.step("computing the values of the table");
  if (o.measured.empty()) {
    const io::MaterialFile file = choose_material_file(o.material, "export");
    material = file.material;
    bytes = interop::rgl_of(file.material, exported_name(o, file), o.size);
  } else {
    const auto measurement = seen(o);
    if (measurement->turning() == measured::Turning::turned)
      throw InputError(io::input_name(o.measured) +
                       ": the samples were turned, and an RGL file is written for one azimuth");
    bytes = interop::rgl_of(measured::material_of(measurement),
                            std::filesystem::path(o.measured).stem().string(), o.size);
  }
  io::write_file_atomically(o.output, bytes);
  Note() << "brdf export: " << bytes.size() << " bytes to " << o.output;
  Made made{{{"kind", "table"}, {"bytes", bytes.size()}}};
  o.step("comparing the file with the material");
  if (material)
    made.exit = say_table_loss(o, *material, interop::read_back_rgl({o.output, bytes}), made.json);
  return made;
}

Made export_lookup_table(const ExportCall& o) {
  check_output(o);
  const Material material = choose_material(o.material, "export");
  o.step("computing the texels");
  const WrittenTable table = write_lookup_table(o.to, material, o.table_layout, o.output);
  for (const std::string& sentence : table.sentences) Note() << "brdf export: " << sentence;
  Made made{{{"kind", "table"}, {"table", table.json}}};
  if (table.not_converged > 0) {
    Warning() << "brdf export: " << table.not_converged
              << " texels did not converge, and their bounds are not known";
    made.exit = Exit::failed;
  }
  return made;
}

std::optional<io::ShaderLanguage> language_of(const std::string& to) {
  if (to == "hlsl") return io::ShaderLanguage::hlsl;
  if (to == "cpp") return io::ShaderLanguage::cpp;
  if (to == "explorer") return io::ShaderLanguage::explorer;
  return std::nullopt;
}

// Judges the formula itself, in float with the library's own functions.
Made formula(const ExportCall& o, const Material& material) {
  Made made{{{"kind", "formula"}}};
  if (!o.max_loss) return made;
  o.step("comparing the formula with the material");
  const interop::Loss loss = interop::Comparison(material).loss_of(interop::in_float(material));
  Note() << "brdf export: the formula in float: " << interop::in_words(loss);
  made.json["loss"] = interop::to_json(loss);
  made.exit = judged_loss(o, loss);
  return made;
}

Made export_formula(const ExportCall& o) {
  io::check_targets({{"-o", o.output}}, {o.material.material, o.material.shader.file});
  const io::MaterialFile file = choose_material_file(o.material, "export");
  const bool with_material = !o.material.material.empty() || !o.material.set.empty();
  if (!with_material && !o.name.empty() && o.to != "cpp")
    throw InputError("--name: --to " + o.to +
                     " of a form alone writes no material; --set or MATERIAL makes one");
  if (const auto language = language_of(o.to)) {
    if (o.include)
      throw InputError("--include: " + o.to + " always contains functions only: leave the option out");
    write(o, io::shader_text(file.material, *language, with_material, exported_name(o, file),
                             o.kernels == "builtin"));
    return formula(o, file.material);
  }
  write(o,
        io::glsl_source(file.material, {.material = with_material,
                                        .whole = !o.include,
                                        .dialect = o.to == "glsl-es" ? GlslDialect::es : GlslDialect::vulkan,
                                        .builtin_kernels = o.kernels == "builtin",
                                        // A whole shader has one material.
                                        .name = o.include ? exported_name(o, file) : o.name,
                                        .guarded = o.include}));
  return formula(o, file.material);
}

Made export_program(const ExportCall& o, const interop::Program& program) {
  io::check_targets({{"-o", o.output}}, {o.material.material, o.material.shader.file});
  const io::MaterialFile file = choose_material_file(o.material, "export");
  o.step("converting to " + std::string(program.title));
  const interop::Exported made = interop::export_to(program, file.material, exported_name(o, file), o.naive);
  write(o, made.text);
  Note() << "brdf export: " << made.target << ": " << interop::in_words(made);
  for (const std::string& sentence : made.not_held) Warning() << "brdf export: not held: " << sentence;
  return {to_json(program, made), judged_loss(o, made.loss)};
}

// Writes fitted maps as textures.
Made export_maps(const ExportCall& o, const interop::Program* program) {
  if (!o.measured.empty() || !o.material.form.empty() || !o.material.set.empty() ||
      !o.material.material.empty() || !o.material.shader.file.empty())
    throw InputError("--maps: is the only input; leave out the material, its options and --measured");
  if (!program)
    throw InputError("--maps --to " + o.to + ": textures are written for " + io::joined(textured_names()));
  if (o.naive) throw InputError("--naive: --maps always copies the parameters of each texel");
  const WrittenMaps written = write_maps(*program, {o.maps, o.loss_map, o.output, o.name});
  erase_progress();
  for (const std::string& sentence : written.sentences) Note() << "brdf export: " << sentence;
  Made made{written.json};
  if (o.max_loss && written.largest_loss > *o.max_loss) {
    Warning() << "brdf export: the loss of a texel, " << io::short_number(written.largest_loss)
              << ", is above --max-loss " << io::short_number(*o.max_loss);
    made.exit = Exit::failed;
  }
  return made;
}

Made made_by(const ExportCall& o, const interop::Program* program) {
  if (!o.maps.empty()) return export_maps(o, program);
  if (!o.loss_map.empty()) throw InputError("--loss-map: applies to --maps only");
  if (!o.measured.empty()) check_measured(o);
  if (o.measured.empty() && o.supplied != io::Supplied())
    throw InputError("--quantity, --mirror-side, --layout: apply to --measured only");
  if (o.to == kMerl) return export_merl(o);
  if (o.to == kRgl) return export_rgl(o);
  if (is_lookup_table(o.to)) return export_lookup_table(o);
  return program ? export_program(o, *program) : export_formula(o);
}

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
