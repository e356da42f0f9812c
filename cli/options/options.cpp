#include "cli/options/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/options/terminal.h"
#include "io/columns/stated_quantity.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"

namespace brdf::cli {
namespace {

template <class Integer>
bool is_integer(std::string_view text) {
  Integer value;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && stop == text.data() + text.size();
}

bool is_finite_number(std::string_view text) {
  double value;
  return io::parse_number(text, value) && std::isfinite(value);
}

// Returns the range that CLI11's name of a type states: "1 to 256" of "UINT:UINT in [1 - 256]". Empty
// without a range.
std::string range_of(const std::string& type) {
  constexpr std::string_view kBegin = "in [", kBetween = " - ";
  const std::size_t begin = type.find(kBegin), end = type.find(']', begin),
                    middle = type.find(kBetween, begin);
  if (begin == std::string::npos || end == std::string::npos || middle > end) return {};
  const std::size_t low = begin + kBegin.size(), high = middle + kBetween.size();
  return type.substr(low, middle - low) + " to " + type.substr(high, end - high);
}

// Returns the fault of the text as a value of this type (CLI11's name of the type), or an empty string if
// the text is valid.
std::string number_fault(const std::string& type, const std::string& text) {
  const std::string shown = "'" + text + "' ", range = range_of(type);
  if (type.starts_with("UINT") && !is_integer<std::uint64_t>(text))
    return shown + "must be a whole number from " + (range.empty() ? "0 to 18446744073709551615" : range);
  if (type.starts_with("INT") && !is_integer<std::int64_t>(text)) return shown + "must be a whole number";
  if (type.starts_with("FLOAT") && !is_finite_number(text)) return shown + "must be a finite number";
  return {};
}

// Replaces "500M" by the number of bytes in digits. Returns the fault, or an empty string.
std::string to_bytes(std::string& text) {
  const std::string fault = "'" + text + "' must be a whole number above 0, alone or with K, M or G";
  std::uint64_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(stop, std::size_t(text.data() + text.size() - stop));
  constexpr std::string_view kUnits = "KMG";
  const std::size_t power = unit.empty() ? 0 : kUnits.find(unit) + 1;
  if (error != std::errc() || number == 0 || (!unit.empty() && (unit.size() != 1 || power == 0)))
    return fault;
  const unsigned bits = 10 * unsigned(power);
  if (number > UINT64_MAX >> bits) return fault + ", below 2^64";
  text = std::to_string(number << bits);
  return {};
}

}  // namespace

void add_arrangement_options(CLI::App& verb, io::Arrangement& arrangement) {
  add_named_option(
      verb, "--polarisation", arrangement.polarisation,
      "Channels with a polarisation in their names (fr_s, 465nm p): all, their average, or one of the two");
  add_named_option(
      verb, "--repeats", arrangement.repeats,
      "Directions measured more than once: a row each, or their mean with its standard deviation");
}

void add_keep_fill_option(CLI::App& verb, bool& keep_fill) {
  verb.add_flag("--keep-fill", keep_fill,
                "Use rows of fill values, too: numbers that mark directions without a measurement");
}

void add_supplied_options(CLI::App& verb, io::Supplied& supplied) {
  add_word_option(
      verb, "--quantity", "",
      [&supplied](const std::string& words) {
        io::stated_by_option(words);  // throws before any file is read
        supplied.quantity = words;
      },
      "Quantity of the values if the file does not state it: " + io::known_quantities());
  add_named_option(verb, "--mirror-side", supplied.mirror_side,
                   "Tables of two signed angles: the sign of the viewer's angle on the mirror side");
  verb.add_option("--layout", supplied.layout,
                  "JSON that describes the columns of a table of text; describe-table proposes one");
}

void add_memory_option(CLI::App& verb, std::uint64_t& bytes, const std::string& name,
                       const std::string& description) {
  verb.add_option(name, bytes, description)->transform(CLI::Validator(to_bytes, "SIZE"));
}

void add_memory_option(CLI::App& verb, std::uint64_t& bytes, const std::string& of) {
  add_memory_option(verb, bytes, "--memory-limit", "Largest amount of " + of + ", for instance 500M or 1G");
}

void require_plain_numbers(CLI::App& app) {
  for (CLI::Option* option : app.get_options())
    option->check(CLI::Validator(
        [type = option->get_type_name()](const std::string& text) { return number_fault(type, text); }, ""));
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; })) require_plain_numbers(*verb);
}

CLI::Option* add_word_option(CLI::App& verb, const std::string& name, std::string_view initial,
                             std::function<void(const std::string&)> set, const std::string& description) {
  return verb.add_option_function<std::string>(name, std::move(set), description)
      ->default_str(std::string(initial));
}

void add_repeated_option(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                         const std::string& description) {
  verb.add_option(name, values, description)->allow_extra_args(false);
}

std::vector<Reflectance> forms_of(const std::vector<std::string>& names, bool all) {
  std::vector<Reflectance> forms;
  if (all) forms.assign(catalogue().begin(), catalogue().end());
  for (const std::string& name : names) forms.push_back(io::require_form(name));
  if (forms.empty()) throw InputError("no form is given: give --form or --all");
  return forms;
}

void add_material_options(CLI::App& verb, io::MaterialChoice& choice) {
  verb.add_option("--form", choice.form,
                  "A form by name (`brdf models` lists them), at its default parameters");
  verb.add_option("--material", choice.material, "The same as MATERIAL");
  add_repeated_option(verb, "--set", choice.set,
                      "Parameter: name=value, or one value per channel: name=v,v,v");
}

CLI::Option* add_material_argument(CLI::App& verb, std::string& file, const std::string& option,
                                   const std::string& description) {
  const CLI::Option* const older = verb.get_option(option);
  return verb.add_option_function<std::string>(
      "MATERIAL",
      [&file, older, option](const std::string& given) {
        if (older->count() > 0)
          throw InputError("MATERIAL " + io::input_name(given) + " and " + option + " " +
                           io::input_name(older->results().front()) + " are both given: give one of them");
        file = given;
      },
      description);
}

void refuse_empty_values(const CLI::App& verb) {
  for (const CLI::Option* option : verb.get_options())
    if (std::ranges::find(option->results(), "") != option->results().end())
      throw InputError(
          (option->get_lnames().empty() ? option->get_name() : "--" + option->get_lnames().front()) +
          ": the value is empty: give a value, or leave the option out");
}

void add_quiet_option(CLI::App& app) {
  for (CLI::App* verb : app.get_subcommands([](const CLI::App* a) { return !a->get_allow_extras(); }))
    verb->add_flag_callback("-q,--quiet", set_quiet,
                            "No progress, notes or next step on the terminal; warnings and errors stay");
}

}  // namespace brdf::cli
