#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/options/fit_options.h"
#include "cli/options/products.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/fit_files.h"
#include "cli/steps/fit_stack.h"
#include "cli/steps/fit_table.h"
#include "cli/verb.h"
#include "fit/fit.h"
#include "fit/report/first_screen.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/standard_input.h"
#include "work/files.h"

namespace brdf::cli {
namespace {

enum Fitted : unsigned { kOneTable = 1, kManyFiles = 2, kOneStack = 4 };
constexpr unsigned kSamples = kOneTable | kManyFiles, kAnyFit = kSamples | kOneStack;
constexpr OptionOf kFitOptions[] = {
    {"SAMPLES --form --metric --anisotropic --per-channel --shape --free-scale --max-theta "
     "--fix --start --bounds --tie --physical --robust --weights --starts --aperture "
     "--bootstrap --output --jobs --json",
     kAnyFit},
    {"--keep-fill --polarisation --repeats --quantity --mirror-side --layout --budget", kSamples},
    {"--seed", kAnyFit, "--starts --bootstrap"},
    {"--shader", kOneTable},
    {"--param --entry --returns --define --include-folder --texture --embed", kOneTable, "--shader"},
    {"--report", kOneTable | kOneStack},
    {"--tolerance", kOneTable},
    {"--no-pictures", kManyFiles},
    {"--normals --share --memory-limit", kOneStack},
    {"--regions", kOneStack, "--share"},
};

struct FitCall {
  std::vector<std::string> samples;
  std::string output, report, tolerance;
  bool json = false, no_pictures = false;
  unsigned jobs = 1;
  fit::FitChoice choice;
  work::StackOptions stack;
  ShaderOptions shader;
  bool form_given = false;
};

// Returns the requested forms. With a shader, returns the shader alone unless forms are named, too.
std::vector<std::vector<Reflectance>> models_of(const FitCall& o) {
  const auto shader = load(o.shader, "fit");
  if (!shader) return fit::models_of(o.choice.form);
  if (!info(shader->reflectance).fittable())
    throw InputError(
        "--shader " + o.shader.file +
        ": its value is linear in none of its parameters, or not in a colour; a fit takes a sum of terms, "
        "each times a weight: "
        "give the function a parameter that multiplies its value, as `//: param scale 0 10 1` and `return "
        "scale * f`");
  std::vector<std::vector<Reflectance>> models{{shader->reflectance}};
  if (o.form_given)
    for (auto& model : fit::models_of(o.choice.form)) models.push_back(std::move(model));
  return models;
}

Exit run_one(const FitCall& o, const fit::FitOptions& options) {
  if (o.shader.embed && o.output.empty())
    throw InputError("--embed: needs -o: the material file holds the text");
  const std::vector<io::Target> outputs{{"-o", o.output}, {"--report", o.report}};
  text_stream(outputs, o.json);  // throws before any file is read
  io::check_targets(outputs);
  std::optional<double> tolerance;
  if (!o.tolerance.empty()) tolerance = fit::tolerance_of(o.tolerance);
  const fit::Samples samples = work::samples_to_fit(o.samples[0], options, this_program());
  keep_budget(outputs, samples);
  const auto models = models_of(o);
  watch_for_interrupt();
  const fit::FitResult result = fit::fit(samples, models, options, step_line("brdf fit"));
  // The window reads samples without --quantity, --mirror-side and --layout.
  const bool is_readable = o.choice.options.supplied == io::Supplied();
  return write_fit(result, samples.table, options,
                   {o.output, o.report, is_readable ? o.samples[0] : "", o.json, tolerance});
}

// With --quiet, progress does not report the faults and assumptions of each file.
void warn_of(const fit::BatchRow& row) {
  if (!is_quiet()) return;
  if (!row.error.empty() && row.error != fit::kInterrupted) Warning() << "brdf fit: " << row.error;
  for (const std::string& sentence : row.assumptions)
    Warning() << io::input_name(row.file) << ": " << sentence;
}

Exit run_many(const FitCall& o, const std::vector<std::string>& files, const fit::FitOptions& options) {
  if (o.output.empty()) throw InputError("several sample files need -o FOLDER");
  require_file({"-o", o.output}, "the results of several files are a folder");
  watch_for_interrupt();
  const auto progress = [](const std::string& message) { Note() << message; };
  const std::vector<fit::BatchRow> rows =
      work::fit_files({files, o.output, o.jobs, !o.no_pictures}, o.choice, options, this_program(), progress);
  const auto left = std::ranges::count(rows, fit::kInterrupted, &fit::BatchRow::error);
  for (const fit::BatchRow& row : rows) warn_of(row);
  if (left > 0) Warning() << "brdf fit: interrupted: " << left << " of " << rows.size() << " not processed";
  return summarise(rows, o.output, o.json);
}

Exit run_fit(const CLI::App& verb, FitCall& o) {
  const fit::FitOptions options = fit_options(o.choice, o.jobs);
  const auto refuse = [&](Fitted made, const char* what) {
    refuse_without_effect(verb, kFitOptions, made, what);
  };
  if (o.samples.size() == 1 && texel::is_stack(o.samples[0])) {
    refuse(kOneStack, "a stack of photographs");
    return fit_a_stack({o.samples[0], o.output, o.report, o.jobs, o.json}, o.stack, o.choice, options);
  }
  const std::vector<std::string> files = work::sample_files(o.samples);
  const bool folder = files.size() > 1 || work::names_folder(o.samples) || o.output.ends_with('/') ||
                      std::filesystem::is_directory(o.output);
  refuse(folder ? kManyFiles : kOneTable, folder ? "several sample files" : "one table of samples");
  return folder ? run_many(o, files, options) : run_one(o, options);
}

}  // namespace

void add_fit(CLI::App& app) {
  auto options = std::make_shared<FitCall>();
  FitCall& o = *options;
  CLI::App* verb = add_verb(app, Purpose::begin, "fit", "Fit forms to samples");
  verb->add_option("SAMPLES", o.samples,
                   "Sample tables (CSV, MERL, ...; - for standard input), folders of them, or one stack of "
                   "photographs")
      ->required();
  add_fit_options(*verb, o.choice);
  add_budget_option(*verb, o.choice);
  add_bootstrap_option(*verb, o.choice);
  add_shader_options(*verb, o.shader);
  verb->add_flag("--embed", o.shader.embed,
                 "Store the shader's text with its includes in the material, in place of the name of its "
                 "file (of --shader, with -o)");
  verb->add_option("-o,--output", o.output,
                   "Material file to write (- for standard output); for several sample files or a stack, the "
                   "folder of the results");
  verb->add_option("--report", o.report, "HTML report to write");
  add_tolerance_option(*verb, o.tolerance);
  verb->add_option("--jobs", o.jobs, "Files, or parts of a stack, fitted at the same time")
      ->check(CLI::Range(1u, 256u));
  verb->add_flag("--no-pictures", o.no_pictures,
                 "With several files: do not draw spheres, which take most of the time");
  verb->add_flag("--json", o.json, "JSON on stdout");
  add_normals_option(*verb, o.stack);
  add_share_options(*verb, o.stack);
  add_stack_memory_option(*verb, o.stack.memory);
  verb->footer(
      "Examples: brdf fit samples.csv --form all -o material.json\n"
      "          brdf fit samples.csv --shader walter.brdf --embed -o walter.json\n"
      "          brdf fit samples.csv --shader walter.brdf --form cook_torrance\n"
      "          brdf fit samples.csv --form auto --json --quiet\n"
      "          zcat samples.csv.gz | brdf fit - --form ward -o - > ward.json\n"
      "          brdf fit paint.csv --form cook_torrance --physical --tie f0\n"
      "          brdf fit paint.csv --form ward --per-channel --max-theta 75 --aperture 1 --weights "
      "solid_angle\n"
      "          brdf fit paint.csv --form ward --robust huber:0.1 --bounds alpha=0.01:0.5 --start "
      "alpha=0.1\n"
      "          brdf fit metal.csv --form cook_torrance --start f0=Johnson.yml\n"
      "          brdf fit paint.csv --form ward --budget goniometer.csv --report certificate.html\n"
      "          brdf fit bands.csv --form cook_torrance --shape smooth:1\n"
      "          brdf fit paint.csv --tolerance 5% --report paint.html\n"
      "          brdf fit paint.csv --form ward --starts 40 --seed 2\n"
      "          brdf fit paint.csv --form ward --bootstrap 200 --seed 3\n"
      "          brdf fit brushed.csv --form ward --anisotropic --metric cube_root --fix kd=0.1 --report "
      "brushed.html\n"
      "          brdf fit polarised.csv --polarisation average --repeats average\n"
      "          brdf fit plane.csv --quantity BRF --mirror-side negative\n"
      "          brdf fit a.csv b.csv --free-scale --keep-fill --jobs 2 --no-pictures -o fits\n"
      "          brdf fit stack --form cook_torrance --normals fit --memory-limit 1G --jobs 2 --report "
      "maps.html -o maps/\n"
      "          brdf fit stack --form cook_torrance --share alpha --regions parts.exr -o maps/");
  require_every_option(*verb, kFitOptions);
  on_run(*verb, [options, verb] {
    options->form_given = verb->get_option("--form")->count() > 0;
    return run_fit(*verb, *options);
  });
}

}  // namespace brdf::cli
