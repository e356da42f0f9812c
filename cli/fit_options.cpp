#include "cli/fit_options.h"

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <csignal>

#include "cli/options.h"
#include "io/error.h"
#include "io/shell.h"
#include "io/text.h"

namespace brdf::cli {
namespace {

std::atomic<bool> interrupted = false;

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

}  // namespace

void add_fit_options(CLI::App& verb, FitChoice& choice) {
  std::vector<std::string> models = names_for(Value::form);
  models.insert(models.end(), {"all", "every", "auto"});
  offer(verb.add_option(
                "--form", choice.form,
                "all, every, a form, a sum as in oren_nayar+ward, or auto: terms as the samples ask for")
            ->capture_default_str(),
        std::move(models));
  add_named_option(
      verb, "--metric", choice.fit.metric,
      "Residual; auto: the one whose noise is the most even on the data, log where it is not known");
  verb.add_flag("--anisotropic", choice.fit.anisotropic, "Two widths and the tangent's azimuth");
  verb.add_flag("--per-channel", choice.fit.per_channel, "A shape for every channel");
  verb.add_flag("--free-scale", choice.fit.free_scale,
                "Uncalibrated samples: divide them by a scale, which is reported; weights are relative then");
  verb.add_option("--max-theta", choice.fit.max_theta, "Degrees; rows with a steeper angle are left out")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 90.0));
  add_repeated_option(verb, "--fix", choice.fix, "Hold a parameter: name=value (or one value per channel)");
  add_repeated_option(verb, "--start", choice.start, "One more start: name=value");
  add_repeated_option(verb, "--bounds", choice.bounds, "Restrict a parameter: name=low:high");
  add_repeated_option(verb, "--tie", choice.fit.tie,
                      "One value for all channels: the name of a weight, f0 or shape");
  verb.add_flag("--physical", choice.physical, "Weights that keep energy: a channel's add up to at most 1");
  verb.add_option("--robust", choice.robust, "huber or cauchy, with :SCALE to give its scale");
  add_named_option(verb, "--weights", choice.fit.weighting,
                   "Weights of the residuals (auto: sigma columns where there are any)");
  verb.add_option("--starts", choice.fit.random_starts, "Random starts besides the grid")
      ->check(CLI::Range(0, 100000));
  verb.add_option("--seed", choice.fit.seed, "Of the random starts")->capture_default_str();
  verb.add_option("--aperture", choice.fit.aperture,
                  "Full width of the detector's field in degrees: the model is averaged over it")
      ->check(CLI::Range(0.0, 90.0));
}

fit::FitOptions fit_options(const FitChoice& o) {
  fit::FitOptions f = o.fit;
  if (!o.robust.empty()) parse_robust(o.robust, f);
  for (const Setting& s : parse_settings(o.fix, "--fix")) f.fix.push_back({s.name, s.values});
  for (const Setting& s : parse_settings(o.start, "--start")) f.start.push_back({s.name, s.values});
  for (const std::string& b : o.bounds) f.bounds.push_back(parse_range(b));
  if (o.physical) f.physical = fit::Physical::either;
  f.interrupted = &interrupted;
  return f;
}

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

std::string words_of(const FitChoice& o) {
  const FitChoice plain;
  std::string text;
  const auto add = [&](const char* option, const std::string& value) {
    text += std::string(" ") + option + " " + io::shell_word(value);
  };
  const auto add_number = [&](const char* option, double value, double left_out) {
    if (value != left_out) add(option, io::to_text(value));
  };
  add("--form", o.form);
  if (o.fit.metric != plain.fit.metric) add("--metric", std::string(name_of(o.fit.metric)));
  if (o.fit.weighting != plain.fit.weighting) add("--weights", std::string(name_of(o.fit.weighting)));
  if (!o.robust.empty()) add("--robust", o.robust);
  for (const auto& [option, list] : {std::pair{"--fix", &o.fix}, std::pair{"--start", &o.start},
                                     std::pair{"--bounds", &o.bounds}, std::pair{"--tie", &o.fit.tie}})
    for (const std::string& word : *list) add(option, word);
  for (const auto& [option, flag] :
       {std::pair{" --anisotropic", o.fit.anisotropic}, std::pair{" --per-channel", o.fit.per_channel},
        std::pair{" --free-scale", o.fit.free_scale}, std::pair{" --physical", o.physical}})
    if (flag) text += option;
  add_number("--max-theta", o.fit.max_theta, plain.fit.max_theta);
  add_number("--aperture", o.fit.aperture, plain.fit.aperture);
  add_number("--starts", o.fit.random_starts, plain.fit.random_starts);
  if (o.fit.seed != plain.fit.seed) add("--seed", std::to_string(o.fit.seed));
  return text;
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
