#include "cli/program/exported.h"

#include <iostream>
#include <memory>

#include "cli/options/progress.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/program/written_maps.h"
#include "cli/program/written_table.h"
#include "interop/read_back.h"
#include "interop/told.h"
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
// its file, shader or form.
std::string exported_name(const ExportCall& o, const io::MaterialFile& file) {
  if (!o.name.empty()) return o.name;
  if (!file.name.empty()) return file.name;
  if (!o.material.form.empty()) return o.material.form;
  const std::string& shader = o.material.shader.file;
  return std::filesystem::path(shader.empty() ? o.material.material : shader).stem().string();
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
  io::check_targets({{"-o", o.output}});
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
  io::check_targets({{"-o", o.output}});
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
  io::check_targets({{"-o", o.output}});
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

}  // namespace

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

}  // namespace brdf::cli
