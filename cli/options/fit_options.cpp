#include "cli/options/fit_options.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>

#include "cli/options/options.h"
#include "cli/options/terminal.h"
#include "io/files/error.h"

namespace brdf::cli {
namespace {

std::atomic<bool> interrupted = false;

}  // namespace

void add_fit_options(CLI::App& verb, fit::FitChoice& choice) {
  std::vector<std::string> models = names_for(Value::form);
  models.insert(models.end(), {"all", "every", "auto"});
  offer(verb.add_option("--form", choice.form,
                        "all, every, a form, a sum as in oren_nayar+ward, a list of these separated by "
                        "commas, or auto: terms are added as long as the samples support them")
            ->capture_default_str()
            ->join(','),
        std::move(models));
  add_named_option(
      verb, "--metric", choice.options.metric,
      "Residual; auto: the residual with the most uniform noise on the data, log if the noise is not known");
  verb.add_flag("--anisotropic", choice.options.anisotropic, "Fit two widths and the azimuth of the tangent");
  verb.add_flag("--per-channel", choice.options.per_channel,
                "Fit a shape for every channel, as --shape free");
  offer(verb.add_option("--shape", choice.shape,
                        "Shape over the channels: shared (default), free, or smooth[:DEGREE], a polynomial "
                        "in 1/wavelength (default degree 2)"),
        {"shared", "free", "smooth"});
  verb.add_flag("--free-scale", choice.options.free_scale,
                "Divide uncalibrated samples by a scale, which is reported; weights are then relative");
  add_keep_fill_option(verb, choice.options.keep_fill);
  add_arrangement_options(verb, choice.options.arrangement);
  add_supplied_options(verb, choice.options.supplied);
  verb.add_option("--max-theta", choice.options.max_theta,
                  "Largest polar angle in degrees; rows with a larger angle are left out")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 90.0));
  add_repeated_option(verb, "--fix", choice.fix,
                      "Hold a parameter: name=value, one value per channel, or FILE, a table of refractive "
                      "indices (f0=gold.yml)");
  add_repeated_option(verb, "--start", choice.start,
                      "Additional starting point: name=value, or FILE as for --fix");
  add_repeated_option(verb, "--bounds", choice.bounds, "Restrict a parameter: name=low:high");
  add_repeated_option(verb, "--tie", choice.options.tie,
                      "Parameter with one value for all channels: the name of a weight, f0 or shape");
  verb.add_flag(
      "--physical", choice.physical,
      "Keep the weights of each channel within the limits of energy conservation: their sum at most 1, or a "
      "dielectric's f0 and kd; near grazing angles the albedo may still exceed 1");
  verb.add_option("--robust", choice.robust, "Robust loss: huber or cauchy, optionally with :SCALE");
  add_named_option(verb, "--weights", choice.options.weighting,
                   "Weights of the residuals (auto: from sigma columns if the table has any)");
  verb.add_option("--starts", choice.options.random_starts,
                  "Number of random starting points in addition to the grid")
      ->check(CLI::Range(0, 100000));
  verb.add_option("--seed", choice.options.seed, "Seed of the random starts")->capture_default_str();
  verb.add_option("--aperture", choice.options.aperture,
                  "Full angular width of the detector in degrees; the model is averaged over this width "
                  "(default: the width that the samples' file states, otherwise 0)")
      ->check(CLI::Range(0.0, 90.0));
}

void add_budget_option(CLI::App& verb, fit::FitChoice& choice) {
  verb.add_option("--budget", choice.budget,
                  "Uncertainty budget of the instrument, a table: its sources enter every interval (default: "
                  "the budget that the samples' file names, otherwise the scatter of the rows only)");
}

void add_bootstrap_option(CLI::App& verb, fit::FitChoice& choice) {
  verb.add_option("--bootstrap", choice.options.bootstrap,
                  "Number of replicates: fits to incidences drawn with replacement; their spread is reported")
      ->check(CLI::Range(0, 100000));
}

void add_tolerance_option(CLI::App& verb, std::string& tolerance) {
  verb.add_option("--tolerance", tolerance,
                  "Largest median error (fitted) that is accepted: 5% or 0.05; above it the exit code is 1");
}

void add_pictures_option(CLI::App& verb, bool& no_pictures) {
  verb.add_flag("--no-pictures", no_pictures, "Leave out the spheres, which take most of the time");
}

fit::FitOptions fit_options(const fit::FitChoice& choice, unsigned jobs) {
  return work::fit_options(choice, jobs, &interrupted);
}

void keep_budget(const std::vector<io::Target>& outputs, const fit::Samples& samples) {
  if (samples.budget) io::check_targets(outputs, {samples.budget->file});
}

void add_normals_option(CLI::App& verb, work::StackOptions& options) {
  verb.add_option("--normals", options.normals,
                  "Normals of a stack: flat, fit (two more parameters for each texel), or an EXR with "
                  "normal.x, normal.y and normal.z")
      ->capture_default_str();
}

void add_task_options(CLI::App& verb, work::TaskOptions& options) {
  add_fit_options(verb, options.choice);
  add_budget_option(verb, options.choice);
  add_bootstrap_option(verb, options.choice);
  add_normals_option(verb, options.stack);
  add_pictures_option(verb, options.no_pictures);
}

work::TaskOptions task_options_of(const std::vector<std::string>& words) {
  CLI::App app;
  work::TaskOptions options;
  add_task_options(app, options);
  try {
    // CLI11 expects the words in reverse order.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    throw InputError("the plan's options cannot be read: " + std::string(error.what()));
  }
  return options;
}

work::Caller this_program() {
  return {&interrupted, [](const std::string& sentence) { Warning() << sentence; }};
}

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

bool was_interrupted() {
  return interrupted;
}

}  // namespace brdf::cli
