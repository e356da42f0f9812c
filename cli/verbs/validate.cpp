#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/products.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/microsurface.h"
#include "cli/steps/shader_proof.h"
#include "cli/steps/shader_subject.h"
#include "cli/verb.h"
#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/png.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"
#include "io/material/settings.h"
#include "study/proofs.h"
#include "validate/form/against.h"
#include "validate/joint/catalogue_sampler.h"
#include "validate/numerics/error_bounds.h"
#include "validate/numerics/integrators.h"
#include "validate/numerics/numerics.h"
#include "validate/report/judged.h"

namespace brdf::cli {
namespace {

// The subjects of a validation: functions over their domain, materials, tables, or the library itself.
enum Judged : unsigned {
  kDomain = 1,
  kMaterial = 2,
  kTable = 4,
  kIntegrators = 8,
  kTraced = 16,
  kNumerics = 32,
  kOnDevice = 64
};
constexpr unsigned kFunctions = kDomain | kMaterial, kFindings = kFunctions | kTable, kEverything = 127;
constexpr OptionOf kValidateOptions[] = {
    {"FILES", kMaterial | kTable},
    {"--form --all", kDomain | kNumerics | kOnDevice},
    {"--shader", kDomain | kOnDevice},
    {"--param --entry --returns --define --include-folder --texture", kDomain | kOnDevice, "--shader"},
    {"--sample --pdf", kDomain, "--shader"},
    {"--samplers", kDomain, "--form --all"},
    {"--such-that --against", kDomain},
    {"--map", kDomain, "--against"},
    {"--effort", kFunctions | kIntegrators | kTraced | kNumerics},
    {"--seconds", kFunctions},
    {"--require --max-theta --picture --output", kFindings},
    {"--keep-fill --quantity --mirror-side --layout", kTable},
    {"--seed", kFunctions | kIntegrators | kTraced | kNumerics | kOnDevice},
    {"--json", kEverything},
    {"--integrators", kIntegrators},
    {"--microsurface", kTraced},
    {"--numerics", kNumerics},
    {"--gpu", kOnDevice},
};

struct ValidateCall {
  std::vector<std::string> files, forms, pictures, require;
  bool all = false, json = false, keep_fill = false, samplers = false;
  std::string effort = "quick", output;
  double max_theta = 89.5;
  std::uint64_t seed = 1;
  double seconds = 0;
  ShaderOptions shader;
  io::Supplied supplied;
  std::string such_that, against;
  std::vector<std::string> maps;
  bool integrators = false, microsurface = false, numerics = false, gpu = false;
};

// Reads the pictures of the report, which are PNG files.
std::vector<validate::Picture> read_pictures(const ValidateCall& o) {
  std::vector<validate::Picture> pictures;
  for (const std::string& path : o.pictures) {
    std::string bytes = io::read_content(path).bytes;
    if (!io::is_png(bytes)) throw InputError("--picture " + path + ": is no PNG file");
    if (!io::is_whole_png(bytes)) throw InputError("--picture " + path + ": the PNG file ends too soon");
    pictures.push_back({path, std::move(bytes)});
  }
  return pictures;
}

// Applies --such-that to all subjects that are judged over a domain.
void restrict_all(const ValidateCall& o, std::vector<validate::Subject>& subjects) {
  if (o.such_that.empty()) return;
  const io::Condition condition(o.such_that, "--such-that");
  for (validate::Subject& subject : subjects) subject.restrict_to(condition);
}

// Returns the findings for forms, materials and tables.
validate::ReportContent judged(const CLI::App& verb, const ValidateCall& o,
                               const validate::CheckOptions& options) {
  validate::ReportContent content;
  content.max_theta = o.max_theta;
  content.keep_fill = o.keep_fill;
  if (o.all)
    for (const Reflectance& form : catalogue()) content.subjects.push_back(validate::Subject::form(form));
  for (const std::string& name : o.forms)
    content.subjects.push_back(validate::Subject::form(io::require_form(name)));
  if (o.samplers)
    for (validate::Subject& subject : content.subjects)
      subject.judge_also(validate::catalogue_sampler(*subject.of_form()));
  if (const auto shader = load(o.shader, "validate", o.json))
    content.subjects.push_back(subject_of(*shader, o.shader.file));
  restrict_all(o, content.subjects);
  const std::size_t whole_domain = content.subjects.size();
  for (const std::string& file : o.files) {
    const std::string name = io::input_name(file);
    validate::add_file(content, file, o.supplied);
    if (!content.subjects.empty() && content.subjects.back().name() == name)
      if (const auto shader = shader_in(content.subjects.back().own()))
        content.subjects.back() =
            validate::Subject::material(name, content.subjects.back().own(), facts_of(*shader));
    if (!content.tables.empty() && content.tables.back().table.source == name)
      for (const std::string& sentence : content.tables.back().table.assumptions)
        Warning() << "brdf validate: " << name << ": " << sentence;
  }
  if (content.subjects.empty() && content.tables.empty())
    throw InputError("nothing to validate: give materials, samples, --form, --all or --shader");
  unsigned made = 0;
  if (whole_domain > 0) made |= kDomain;
  if (content.subjects.size() > whole_domain) made |= kMaterial;
  if (!content.tables.empty()) made |= kTable;
  refuse_without_effect(verb, kValidateOptions, made,
                        made == kTable      ? "tables of samples"
                        : made == kMaterial ? "materials"
                                            : "what is judged here");
  std::vector<validate::Against> against;  // throws before the work begins
  for (std::size_t k = 0; !o.against.empty() && k < whole_domain; ++k)
    against.push_back(validate::parse_against(content.subjects[k], o.against, o.maps));
  validate::judge_all(content, options, progress_line("brdf validate: checks"));
  for (std::size_t k = 0; k < against.size(); ++k)
    content.findings.push_back(validate::within_seconds(options, [&](const validate::CheckOptions& own) {
      return validate::check_against(content.subjects[k], against[k], own);
    }));
  return content;
}

void check_output(const ValidateCall& o) {
  text_stream({{"-o", o.output}}, o.json);  // throws before any file is read
  if (!o.output.empty() && !is_stream(o.output) && !o.output.ends_with(".html") && !o.output.ends_with(".md"))
    throw InputError("-o " + o.output + ": must end in .html or .md");
  if (!o.pictures.empty() && !o.output.ends_with(".html"))
    throw InputError("--picture " + o.pictures.front() + ": needs -o with a name that ends in .html");
  io::check_targets({{"-o", o.output}});
}

void write_report(const ValidateCall& o, const validate::ReportContent& content) {
  if (o.output.empty()) return;
  io::write_file_atomically(o.output, o.output.ends_with(".html") ? validate::to_html(content)
                                                                  : validate::to_markdown(content.findings));
}

Exit run_integrators(const ValidateCall& o) {
  io::Json rows = io::Json::array();
  bool honest = true;
  const auto report = [&](const validate::IntegratorRow& row) {
    honest = honest && row.wrong == 0;
    rows.push_back({{"set", row.set},
                    {"tolerance", row.tolerance},
                    {"cases", row.cases},
                    {"wrong", row.wrong},
                    {"unconverged", row.unconverged},
                    {"mean_evaluations", row.mean_evaluations},
                    {"worst_over_allowed", row.worst},
                    {"worst_case", row.worst_case}});
    if (!o.json)
      std::cout << row.set << " at " << row.tolerance << ": " << row.cases << " cases, " << row.wrong
                << " wrong, " << row.unconverged << " unconverged, " << row.mean_evaluations
                << " evaluations each\n"
                << std::flush;
  };
  validate::check_integrators(o.seed, report);
  validate::check_bounds(o.seed, o.effort == "full" ? 20000 : 4000, report);
  if (o.json) std::cout << io::to_text(io::Json{{"rows", rows}}) << '\n';
  return honest ? Exit::good : Exit::failed;
}

// Throws if more than one mode that judges the library itself is requested.
void require_one_mode(const CLI::App& verb, const ValidateCall& o) {
  const std::tuple<bool, Judged, const char*> modes[] = {{o.integrators, kIntegrators, "--integrators"},
                                                         {o.microsurface, kTraced, "--microsurface"},
                                                         {o.numerics, kNumerics, "--numerics"},
                                                         {o.gpu, kOnDevice, "--gpu"}};
  if (o.integrators + o.microsurface + o.numerics + o.gpu > 1)
    throw InputError("--integrators, --microsurface, --numerics, --gpu: give one of them");
  for (const auto& [is, mode, name] : modes)
    if (is) refuse_without_effect(verb, kValidateOptions, mode, name);
}

void print(const std::vector<validate::Finding>& findings, TextStream stream) {
  PlainText out(stream);
  validate::print_findings(out, findings, colours_on(descriptor_of(stream)));
}

Exit run_validate(const CLI::App& verb, const ValidateCall& o) {
  require_one_mode(verb, o);
  if (o.microsurface)
    return validate_microsurface({.seed = o.seed, .effort = o.effort == "full" ? 8 : 1}, o.json);
  if (o.integrators) return run_integrators(o);
  if (o.numerics) {
    const auto quiet = [](int, int) {};  // the table itself grows as forms are measured
    const bool good = validate::report_numerics(
        forms_of(o.forms, o.all), {.evaluations = o.effort == "full" ? 1'000'000u : 10'000u, .seed = o.seed},
        o.json, std::cout, o.json ? progress_line("brdf validate: forms measured") : quiet);
    return good ? Exit::good : Exit::failed;
  }
  if (o.gpu && !o.shader.file.empty()) {
    if (!o.forms.empty() || o.all) throw InputError("--shader and --gpu: without --form and --all");
    const auto shader = load(o.shader, "validate", o.json);
    return validate_gpu(std::vector{with_room(shader->material)}, o.seed, o.json, &*shader);
  }
  if (o.gpu) return validate_gpu(forms_of(o.forms, o.all), o.seed, o.json);
  validate::check_max_theta(o.max_theta);
  check_output(o);
  std::vector<validate::Picture> pictures = read_pictures(o);
  validate::check_required(o.require);
  validate::CheckOptions options;
  options.effort = o.effort == "full" ? validate::Effort::full : validate::Effort::quick;
  options.max_theta = o.max_theta;
  options.seed = o.seed;
  options.seconds = o.seconds;
  validate::ReportContent content = judged(verb, o, options);
  study::mark_proofs(content.subjects, content.findings);
  content.pictures = std::move(pictures);
  write_report(o, content);
  if (o.json) {
    std::cout << io::to_text(validate::to_json(content.findings)) << '\n';
  } else {
    print(content.findings, text_stream({{"-o", o.output}}));
    if (o.output.ends_with(".html")) print_next_step({open_page(o.output)});
  }
  return validate::holds(content.findings, o.require) ? Exit::good : Exit::failed;
}

}  // namespace

void add_validate(CLI::App& app) {
  auto o = std::make_shared<ValidateCall>();
  CLI::App* verb = add_verb(app, Purpose::begin, "validate", "Judge forms, materials and measured samples");
  verb->add_option("FILES", o->files, "Materials (JSON) and sample tables");
  add_repeated_option(*verb, "--form", o->forms, "Form to judge over its whole parameter domain");
  verb->add_flag("--all", o->all, "Every form");
  verb->add_flag("--samplers", o->samplers,
                 "Judge the importance sampler of each form as well (of --form, --all; a shader's sampler is "
                 "always judged)");
  add_shader_options(*verb, o->shader);
  add_sampler_options(*verb, o->shader);
  verb->add_option("--such-that", o->such_that,
                   "Condition on the parameters, for instance \"kd + ks <= 1\" (of --form, --all, --shader)");
  verb->add_option("--against", o->against, "Form to compare with: the largest difference and its place");
  add_repeated_option(
      *verb, "--map", o->maps,
      "Parameter of the form of --against as a formula of the own parameters: alpha=roughness*roughness");
  verb->add_option("--effort", o->effort, "Effort of the search for the worst case")
      ->check(CLI::IsMember({"quick", "full"}))
      ->capture_default_str();
  verb->add_option("--seconds", o->seconds,
                   "Longest time of each check in seconds; an unfinished check is undecided")
      ->check(CLI::NonNegativeNumber);
  offer(verb->add_option("--require", o->require, "Checks that must pass; otherwise the exit code is 1")
            ->delimiter(','),
        validate::required_names());
  verb->add_option("--max-theta", o->max_theta,
                   "Largest angle of the energy check in degrees; rows of samples beyond this angle are "
                   "judged separately")
      ->capture_default_str();
  add_keep_fill_option(*verb, o->keep_fill);
  add_supplied_options(*verb, o->supplied);
  verb->add_option("--seed", o->seed, "Seed of the search and of random cases")->capture_default_str();
  add_repeated_option(*verb, "--picture", o->pictures, "PNG to include in the HTML report");
  verb->add_option("-o,--output", o->output,
                   "Report to write, .html or .md; - for Markdown on standard output");
  verb->add_flag("--json", o->json, "Findings as JSON on stdout");
  verb->add_flag("--integrators", o->integrators, "Check the error bounds of the integrals on random cases");
  verb->add_flag(
      "--microsurface", o->microsurface,
      "Compare theory with rays traced on explicit microgeometry (a minute; --effort full: eight)");
  verb->add_flag(
      "--numerics", o->numerics,
      "Search for the largest errors of the forms (--form or --all) in float and double against 50 "
      "digits, and for NaN, infinite and negative values; exit code 1 if an error is larger than stated "
      "(--all: half a minute; --effort full, a million evaluations each: half an hour)");
  verb->add_flag("--gpu", o->gpu,
                 "Compare the shaders of the forms with the library bit for bit; with --shader: the driver's "
                 "values of that function with correctly rounded values");
  verb->footer(
      "Examples: brdf validate material.json --require energy,reciprocity -o report.html\n"
      "          brdf validate samples.csv --max-theta 80 --keep-fill --picture photograph.png -o "
      "sheet.html\n"
      "          brdf validate reflectance_factors.csv --quantity BRF --mirror-side negative\n"
      "          brdf validate --form ward --effort full --seed 2\n"
      "          brdf fit samples.csv --form ward -o - | brdf validate - --quiet\n"
      "          brdf validate --all --json\n"
      "          brdf validate --form ward --samplers --require jacobian,sample_mean\n"
      "          brdf validate --shader disney.brdf --param roughness=0.05:1 --require finite,non_negative\n"
      "          brdf validate --shader ggx.glsl --such-that \"albedo + f0 <= 1\" --against cook_torrance "
      "--map "
      "alpha=roughness*roughness\n"
      "          brdf validate --shader car_paint.glsl --seconds 5\n"
      "          brdf validate --shader ggx.glsl --sample sampleGgx --pdf pdfGgx --require jacobian\n"
      "          brdf validate --all --numerics\n"
      "          brdf validate --integrators\n"
      "          brdf validate --microsurface\n"
      "          brdf validate --form ward --gpu\n"
      "          brdf validate --shader ggx.glsl --gpu");
  require_every_option(*verb, kValidateOptions);
  on_run(*verb, [o, verb] { return run_validate(*verb, *o); });
}

}  // namespace brdf::cli
