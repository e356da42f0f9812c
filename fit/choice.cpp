#include "fit/choice.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "fit/model/smooth.h"
#include "io/files/error.h"
#include "io/files/shell.h"
#include "io/files/text.h"
#include "io/material/settings.h"

namespace brdf::fit {
namespace {

// Parses a loss, or a loss and its scale: "huber", "cauchy:0.1".
void parse_robust(const std::string& text, FitOptions& options) {
  const std::size_t colon = text.find(':');
  const auto loss = find_named<Loss>(text.substr(0, colon));
  if (!loss) throw InputError("--robust " + text + ": must be one of " + known_names<Loss>());
  options.loss = *loss;
  if (colon == std::string::npos) return;
  if (!io::parse_number(text.substr(colon + 1), options.loss_scale) || !(options.loss_scale > 0) ||
      !std::isfinite(options.loss_scale))
    throw InputError("--robust " + text + ": the scale must be a number above 0");
}

// Parses name=low:high.
NamedRange parse_range(const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.find(':', equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || colon == std::string::npos)
    throw InputError("--bounds " + text + ": must be NAME=LOW:HIGH");
  const std::string name = text.substr(0, equals);
  const std::string low = text.substr(equals + 1, colon - equals - 1), high = text.substr(colon + 1);
  const auto values = io::parse_settings({name + "=" + low + "," + high}, "--bounds")[0].values;
  if (!(values[0] < values[1])) throw InputError("--bounds " + text + ": low must be below high");
  return {name, values[0], values[1]};
}

constexpr int kUsualDegree = 2;

// Parses the variation of shapes over the channels.
void parse_shape(const std::string& text, FitOptions& f) {
  const std::string smooth = "smooth", given = "--shape " + text;
  double degree = kUsualDegree;
  if (f.per_channel && text != "free")
    throw InputError(given + ": --per-channel means --shape free; give one of the two options");
  if (text == "shared") return;
  if (text == "free") {
    f.per_channel = true;
    return;
  }
  if (text != smooth && !text.starts_with(smooth + ":"))
    throw InputError(given + ": must be shared, free, smooth or smooth:DEGREE");
  if (text != smooth && (!io::parse_number(text.substr(smooth.size() + 1), degree) ||
                         degree != std::floor(degree) || degree < 1 || degree > kHighestDegree))
    throw InputError(given + ": the degree must be a whole number from 1 to " +
                     std::to_string(kHighestDegree));
  f.smooth = int(degree);
}

// Returns the text after the equals sign if it names a file: "gold.yml", "metals.csv:Au". Returns "" if it
// holds numbers.
std::string file_in(const std::string& text, const char* option) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) return "";
  const std::string value = text.substr(equals + 1), file = value.substr(0, value.rfind(':'));
  for (const std::string& name : {value, file})
    if (std::filesystem::is_regular_file(name)) return value;
  const std::string suffix = std::filesystem::path(file).extension();
  double number;
  if (suffix.size() < 2 || file.find(',') != std::string::npos || io::parse_number(file, number)) return "";
  throw InputError(std::string(option) + " " + text + ": " + file + " is neither a number nor a file");
}

// Adds name=value,... or name=FILE, a table of refractive indices.
void add_values(const std::vector<std::string>& texts, const char* option, std::vector<NamedValues>& out) {
  std::vector<std::string> numbers;
  for (const std::string& text : texts) {
    const std::string file = file_in(text, option);
    if (file.empty()) {
      numbers.push_back(text);
      continue;
    }
    auto constants = std::make_shared<io::OpticalConstants>(io::read_optical_constants(file));
    out.push_back({text.substr(0, text.find('=')), {}, std::move(constants)});
  }
  for (const io::Setting& s : io::parse_settings(numbers, option)) out.push_back({s.name, s.values});
}

template <class Number>
void check_range(const char* option, Number value, Number low, Number high) {
  if (!(value >= low && value <= high))
    throw InputError(std::string(option) + ": " + io::to_text(double(value)) + ": must be a " +
                     (std::is_integral_v<Number>
                          ? "whole number from " + std::to_string(low) + " to " + std::to_string(high)
                          : "number from " + io::to_text(double(low)) + " to " + io::to_text(double(high))));
}

// Returns the models of "all", "every", "ward" or "oren_nayar+ward".
std::vector<std::vector<Reflectance>> models_of_word(std::string_view word) {
  if (word == "all") return canonical_models();
  if (word == "every") return every_model();
  std::vector<Reflectance> forms;
  std::vector<std::string_view> names;
  io::split(word, '+', names);
  for (const std::string_view name : names) forms.push_back(io::require_form(std::string(name)));
  return {forms};
}

}  // namespace

FitOptions options_of(const FitChoice& o) {
  FitOptions f = o.options;
  check_range("--max-theta", f.max_theta, 0.0, 90.0);
  check_range("--starts", f.random_starts, 0, 100000);
  check_range("--bootstrap", f.bootstrap, 0, 100000);
  if (f.aperture) check_range("--aperture", *f.aperture, 0.0, 90.0);
  if (!o.robust.empty()) parse_robust(o.robust, f);
  if (!o.shape.empty()) parse_shape(o.shape, f);
  add_values(o.fix, "--fix", f.fix);
  add_values(o.start, "--start", f.start);
  for (const std::string& b : o.bounds) f.bounds.push_back(parse_range(b));
  if (o.physical) f.physical = Physical::either;
  if (!o.budget.empty()) f.budget = std::make_shared<const io::Budget>(io::read_budget(o.budget));
  return f;
}

std::vector<std::vector<Reflectance>> models_of(const std::string& text) {
  if (text == "auto") return {};
  std::vector<std::vector<Reflectance>> out;
  std::vector<std::string_view> words;
  io::split(text, ',', words);
  for (const std::string_view word : words) {
    if (word == "auto")
      throw InputError("--form " + text + ": auto builds a model by itself: leave the other forms out");
    for (std::vector<Reflectance>& model : models_of_word(word)) {
      if (std::ranges::find(out, model) != out.end())
        throw InputError("--form " + text + ": " + std::string(word) +
                         " is named twice: name each form once");
      out.push_back(std::move(model));
    }
  }
  return out;
}

std::string words_of(const FitChoice& o) {
  std::string text;
  for (const std::string& word : arguments_of(o)) text += " " + io::shell_word(word);
  return text;
}

std::vector<std::string> arguments_of(const FitChoice& o) {
  const FitChoice plain;
  std::vector<std::string> words;
  const auto add = [&](const char* option, const std::string& value) {
    words.emplace_back(option);
    words.push_back(value);
  };
  const auto add_number = [&](const char* option, double value, double left_out) {
    if (value != left_out) add(option, io::to_text(value));
  };
  add("--form", o.form);
  if (o.options.metric != plain.options.metric) add("--metric", std::string(name_of(o.options.metric)));
  if (o.options.weighting != plain.options.weighting)
    add("--weights", std::string(name_of(o.options.weighting)));
  if (!o.robust.empty()) add("--robust", o.robust);
  if (!o.shape.empty()) add("--shape", o.shape);
  for (const auto& [option, list] : {std::pair{"--fix", &o.fix}, std::pair{"--start", &o.start},
                                     std::pair{"--bounds", &o.bounds}, std::pair{"--tie", &o.options.tie}})
    for (const std::string& word : *list) add(option, word);
  for (const auto& [option, flag] :
       {std::pair{"--anisotropic", o.options.anisotropic}, std::pair{"--per-channel", o.options.per_channel},
        std::pair{"--free-scale", o.options.free_scale}, std::pair{"--keep-fill", o.options.keep_fill},
        std::pair{"--physical", o.physical}})
    if (flag) words.emplace_back(option);
  if (o.options.arrangement.polarisation != plain.options.arrangement.polarisation)
    add("--polarisation", std::string(name_of(o.options.arrangement.polarisation)));
  if (o.options.arrangement.repeats != plain.options.arrangement.repeats)
    add("--repeats", std::string(name_of(o.options.arrangement.repeats)));
  if (!o.options.supplied.quantity.empty()) add("--quantity", o.options.supplied.quantity);
  if (o.options.supplied.mirror_side != plain.options.supplied.mirror_side)
    add("--mirror-side", std::string(name_of(o.options.supplied.mirror_side)));
  if (!o.options.supplied.layout.empty()) add("--layout", o.options.supplied.layout);
  add_number("--max-theta", o.options.max_theta, plain.options.max_theta);
  if (!o.budget.empty()) add("--budget", o.budget);
  if (o.options.aperture) add("--aperture", io::to_text(*o.options.aperture));
  add_number("--starts", o.options.random_starts, plain.options.random_starts);
  add_number("--bootstrap", o.options.bootstrap, plain.options.bootstrap);
  if (o.options.seed != plain.options.seed) add("--seed", std::to_string(o.options.seed));
  return words;
}

}  // namespace brdf::fit
