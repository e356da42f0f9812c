#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/options.h"
#include "cli/progress.h"
#include "cli/verbs.h"
#include "fit/file_batch.h"
#include "fit/fit.h"
#include "fit/report/html.h"
#include "fit/report/report.h"
#include "fit/stepwise.h"
#include "io/error.h"
#include "io/material_json.h"
#include "io/numbers.h"
#include "io/output.h"
#include "io/provenance.h"
#include "io/relative_scale.h"
#include "io/text.h"
#ifdef BRDF_HAS_RENDER
#include "render/job.h"
#endif

namespace brdf::cli {
namespace {

std::atomic<bool> interrupted = false;

struct Options {
  std::vector<std::string> samples, fix, start, bounds;
  std::string form = "all", robust, output, report;
  bool json = false, physical = false;
  unsigned jobs = 1;
  fit::FitOptions fit{.metric = fit::Metric::automatic};
};

// "all", "every", "ward" or "oren_nayar+ward"; none for "auto", which chooses by itself.
std::vector<std::vector<Reflectance>> models_of(const std::string& text) {
  if (text == "auto") return {};
  if (text == "all") return fit::canonical_models();
  if (text == "every") return fit::every_model();
  std::vector<Reflectance> forms;
  std::vector<std::string_view> names;
  io::split(text, '+', names);
  for (const std::string_view name : names) forms.push_back(require_form(std::string(name)));
  return {forms};
}

// A loss, or a loss and its scale: "huber", "cauchy:0.1".
void parse_robust(const std::string& text, fit::FitOptions& options) {
  const std::size_t colon = text.find(':');
  const auto loss = find_named<fit::Loss>(text.substr(0, colon));
  if (!loss) throw InputError("--robust " + text + ": must be one of " + known_names<fit::Loss>());
  options.loss = *loss;
  if (colon == std::string::npos) return;
  if (!io::parse_number(text.substr(colon + 1), options.loss_scale) || !(options.loss_scale > 0) ||
      !std::isfinite(options.loss_scale))
    throw InputError("--robust " + text + ": the scale must be a number above 0");
}

// name=low:high
fit::NamedRange parse_range(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.find(':', equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || colon == std::string::npos)
    throw InputError("--bounds " + text + ": must be NAME=LOW:HIGH");
  const std::string name = text.substr(0, equals);
  const std::string low = text.substr(equals + 1, colon - equals - 1), high = text.substr(colon + 1);
  const auto values = parse_settings({name + "=" + low + "," + high}, "--bounds")[0].values;
  if (!(values[0] < values[1])) throw InputError("--bounds " + text + ": low must be below high");
  return {name, values[0], values[1]};
}

fit::FitOptions fit_options(Options& o) {
  fit::FitOptions f = o.fit;
  if (!o.robust.empty()) parse_robust(o.robust, f);
  for (const Setting& s : parse_settings(o.fix, "--fix")) f.fix.push_back({s.name, s.values});
  for (const Setting& s : parse_settings(o.start, "--start")) f.start.push_back({s.name, s.values});
  for (const std::string& b : o.bounds) f.bounds.push_back(parse_range(b));
  if (o.physical) f.physical = fit::Physical::either;
  f.interrupted = &interrupted;
  return f;
}

// Ctrl-C asks for the best so far; a second one ends the program. Where it is ignored it stays so.
void watch_for_interrupt() {
  static struct sigaction before;
  struct sigaction action = {};
  action.sa_handler = [](int) {
    interrupted = true;
    sigaction(SIGINT, &before, nullptr);
  };
  if (sigaction(SIGINT, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    sigaction(SIGINT, &action, nullptr);
}

Exit run_one(const Options& o, const fit::FitOptions& options) {
  io::check_targets({{"-o", o.output}, {"--report", o.report}}, {o.samples[0]});
  io::SampleTable table = io::read_samples(o.samples[0]);
  if (options.free_scale) io::make_relative(table);
  watch_for_interrupt();
  fit::Progress progress;
  if (shows_progress()) progress = [](const std::string& what) { std::cerr << "brdf fit: " << what << '\n'; };
  const auto models = models_of(o.form);
  const fit::FitResult result =
      models.empty() ? fit::fit_stepwise(table, options, progress) : fit::fit(table, models, options);
  const fit::FormFit& best = result.ranking.front();
  if (result.interrupted && !o.output.empty() && std::filesystem::is_regular_file(o.output))
    std::cerr << "brdf fit: interrupted: " << o.output << " is kept as it was\n";
  else if (!o.output.empty() && best.solved())
    io::write_material_file(o.output, {best.material, fit::material_block(best, result, table, options)});
  else if (!o.output.empty())
    std::cerr << "brdf fit: no form could be fitted: " << o.output << " is not written\n";
  if (!o.report.empty()) io::write_file_atomically(o.report, fit::html_report(result, table, options));
  if (o.json)
    std::cout << io::to_text(fit::to_json(result, table, options));
  else
    fit::print(std::cout, result, table, options);
  return fit::usable(best.verdict) && !result.interrupted ? Exit::good : Exit::failed;
}

// A sphere of every new material, where this build and this machine can draw.
void draw_spheres(const std::vector<fit::BatchRow>& rows, const std::filesystem::path& folder) {
#ifdef BRDF_HAS_RENDER
  for (const fit::BatchRow& row : rows) {
    const std::filesystem::path picture = folder / (row.name + ".png");
    if (!row.error.empty() || interrupted || (row.reused && std::filesystem::exists(picture))) continue;
    render::Job job;
    job.materials = {folder / (row.name + ".json")};
    job.output = picture;
    job.width = job.height = 256;
    try {
      for (const std::string& note : render::run(job).notes)
        std::cerr << picture.string() << ": " << note << '\n';
    } catch (const EnvironmentError& error) {
      std::cerr << "brdf: no pictures: " << error.what() << '\n';
      return;
    }
  }
#else
  (void)rows, (void)folder;
#endif
}

// What decides the results of a batch: the options as given, without the files and the number of jobs.
std::string settings_of(const Options& o) {
  std::string text = io::joined({io::provenance().version, o.form, std::string(name_of(o.fit.metric)),
                                 o.robust, std::string(name_of(o.fit.weighting))},
                                " ");
  for (const auto* list : {&o.fix, &o.start, &o.bounds, &o.fit.tie}) {
    text += " |";
    for (const std::string& item : *list) text += " " + item;
  }
  for (const double x :
       {o.fit.max_theta, o.fit.aperture, double(o.fit.anisotropic), double(o.fit.per_channel),
        double(o.physical), double(o.fit.free_scale), double(o.fit.random_starts), double(o.fit.seed)})
    text += " " + std::to_string(x);
  return text;
}

Exit run_many(const Options& o, const fit::FitOptions& options) {
  if (o.output.empty()) throw InputError("several sample files need -o FOLDER");
  if (!o.report.empty()) throw InputError("--report is for one sample file: a batch writes one for each");
  const std::filesystem::path folder = o.output;
  watch_for_interrupt();
  const auto progress = [](const std::string& message) { std::cerr << message << '\n'; };
  const std::vector<fit::BatchRow> rows =
      fit::run_batch(o.samples, models_of(o.form), options, {folder, o.jobs, settings_of(o), progress});
  draw_spheres(rows, folder);
  fit::write_summary(rows, folder);
  bool good = true;
  io::Json list = io::Json::array();
  for (const fit::BatchRow& row : rows) {
    good = good && fit::usable(row);
    io::Json j{
        {"file", row.file}, {"material", (folder / (row.name + ".json")).string()}, {"kept", row.reused}};
    if (row.error.empty())
      j["best"] = row.best;
    else
      j = {{"file", row.file}, {"error", row.error}};
    list.push_back(std::move(j));
  }
  if (o.json)
    std::cout << io::to_text(io::Json{{"files", list}});
  else
    std::cout << (folder / "summary.csv").string() << ", " << (folder / "summary.html").string() << '\n';
  if (std::ranges::any_of(rows, &fit::BatchRow::environment_failed)) return Exit::environment;
  return good ? Exit::good : Exit::failed;
}

Exit run(Options& o) {
  const fit::FitOptions options = fit_options(o);
  const bool folder =
      o.samples.size() > 1 || o.output.ends_with('/') || std::filesystem::is_directory(o.output);
  return folder ? run_many(o, options) : run_one(o, options);
}

}  // namespace

void add_fit(CLI::App& app) {
  auto options = std::make_shared<Options>();
  Options& o = *options;
  CLI::App* verb = app.add_subcommand("fit", "Fit forms to samples");
  verb->add_option("SAMPLES", o.samples, "Sample tables (CSV, MERL, ...)")->required();
  verb->add_option("--form", o.form,
                   "all, every, a form, a sum as in oren_nayar+ward, or auto: terms as the samples ask for")
      ->capture_default_str();
  add_named_option(
      *verb, "--metric", o.fit.metric,
      "Residual; auto: the one whose noise is the most even on the data, log where it is not known");
  verb->add_flag("--anisotropic", o.fit.anisotropic, "Two widths and the tangent's azimuth");
  verb->add_flag("--per-channel", o.fit.per_channel, "A shape for every channel");
  verb->add_flag(
      "--free-scale", o.fit.free_scale,
      "Uncalibrated samples: divide them by a scale, which is reported; weights are relative then");
  verb->add_option("--max-theta", o.fit.max_theta, "Degrees; rows with a steeper angle are left out")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 90.0));
  add_repeated_option(*verb, "--fix", o.fix, "Hold a parameter: name=value (or one value per channel)");
  add_repeated_option(*verb, "--start", o.start, "One more start: name=value");
  add_repeated_option(*verb, "--bounds", o.bounds, "Restrict a parameter: name=low:high");
  add_repeated_option(*verb, "--tie", o.fit.tie,
                      "One value for all channels: the name of a weight, f0 or shape");
  verb->add_flag("--physical", o.physical, "Weights that keep energy: a channel's add up to at most 1");
  verb->add_option("--robust", o.robust, "huber or cauchy, with :SCALE to give its scale");
  add_named_option(*verb, "--weights", o.fit.weighting,
                   "Weights of the residuals (auto: sigma columns where there are any)");
  verb->add_option("--starts", o.fit.random_starts, "Random starts besides the grid")
      ->check(CLI::Range(0, 100000));
  verb->add_option("--seed", o.fit.seed, "Of the random starts")->capture_default_str();
  verb->add_option("--aperture", o.fit.aperture,
                   "Full width of the detector's field in degrees: the model is averaged over it")
      ->check(CLI::Range(0.0, 90.0));
  verb->add_option("-o,--output", o.output,
                   "Material file to write; with several sample files: the folder of the results");
  verb->add_option("--report", o.report, "HTML report to write");
  verb->add_option("--jobs", o.jobs, "Files fitted at the same time")->check(CLI::Range(1u, 256u));
  verb->add_flag("--json", o.json, "JSON on stdout");
  verb->footer(
      "Examples: brdf fit samples.csv --form all -o material.json\n"
      "          brdf fit samples.csv --form auto --json\n"
      "          brdf fit paint.csv --form cook_torrance --physical --tie f0");
  on_run(*verb, [options] { return run(*options); });
}

}  // namespace brdf::cli
