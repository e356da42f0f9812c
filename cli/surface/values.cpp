#include "cli/surface/values.h"

#include <CLI/CLI.hpp>
#include <map>
#include <set>

#include "brdf/targets.h"

namespace brdf::cli {
namespace {

std::map<const CLI::Option*, std::vector<std::string>>& offers() {
  static std::map<const CLI::Option*, std::vector<std::string>> all;
  return all;
}

// The kinds of options that have another meaning in another verb (takes()).
std::map<const CLI::Option*, Value>& own_kinds() {
  static std::map<const CLI::Option*, Value> all;
  return all;
}

// The kinds of values, by option name, for options that have the same meaning in every verb. An option
// that takes text must be listed here or offer its words; otherwise its value is `unnamed`.
const std::map<std::string, Value, std::less<>> kByName{
    {"FORM", Value::form},
    {"--form", Value::form},
    {"--set", Value::parameter},
    {"--fix", Value::parameter},
    {"--start", Value::parameter},
    {"--bounds", Value::parameter},
    {"--tie", Value::text},
    {"SAMPLES", Value::samples},
    {"DIRECTIONS", Value::samples},
    {"--measured", Value::samples},
    {"MATERIAL", Value::either},
    {"MATERIALS", Value::material},
    {"FILES", Value::either},
    {"IN", Value::either},
    {"--reference", Value::either},
    {"OUT", Value::samples},
    {"--material", Value::material},
    {"--compare", Value::json},
    {"--scene", Value::scene},
    {"--state", Value::json},
    {"--save-as", Value::json},
    {"--ledger", Value::json},
    {"--screenshot", Value::picture},
    {"--picture", Value::picture},
    {"--report", Value::report},
    {"--output", Value::file},
    {"--compare-weightings", Value::folder},
    {"--robust", Value::text},
    {"--grid", Value::text},
    {"--solo", Value::text},
    {"--only", Value::text},
    {"--memory-limit", Value::text},
    {"--environment", Value::light},
    {"--shape", Value::file},
    {"--over", Value::parameter},
    {"--microsurface", Value::text},
    {"--texels", Value::text},
    {"--vary", Value::parameter},
    {"--normals", Value::picture},
    {"--share", Value::text},
    {"--regions", Value::picture},
    {"JOB", Value::folder},
    {"--unit-size", Value::text},
    {"--shader", Value::file},
    {"--param", Value::text},
    {"--entry", Value::text},
    {"--define", Value::text},
    {"--include-folder", Value::folder},
    {"--against", Value::form},
    {"--map", Value::text},
    {"--such-that", Value::text},
    {"--size", Value::text},
    {"--name", Value::text},
    {"--quantity", Value::text},
    {"--check", Value::json},
};

}  // namespace

CLI::Option* offer(CLI::Option* option, std::vector<std::string> words) {
  offers()[option] = std::move(words);
  return option;
}

CLI::Option* takes(CLI::Option* option, Value value) {
  own_kinds()[option] = value;
  return option;
}

// Returns the words passed to offer(), or the list of a CLI11 check: {8,16,32}.
std::vector<std::string> offered(const CLI::Option& option) {
  if (const auto found = offers().find(&option); found != offers().end()) return found->second;
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

Value value_of(const CLI::Option& option) {
  if (const auto own = own_kinds().find(&option); own != own_kinds().end()) return own->second;
  const std::string name = option.get_positional()       ? option.get_name(true)
                           : option.get_lnames().empty() ? "-" + option.get_snames()[0]
                                                         : "--" + option.get_lnames()[0];
  const auto found = kByName.find(name);
  const bool named = found != kByName.end();
  if (named && is_file(found->second)) return found->second;
  if (!offered(option).empty()) return Value::word;
  if (named) return found->second;
  return option.get_type_name().starts_with("TEXT") ? Value::unnamed : Value::number;
}

std::vector<std::string> names_for(Value value) {
  if (value == Value::parameter) {
    std::set<std::string> names;
    for (const auto list : {catalogue(), targets()})
      for (const Reflectance& form : list)
        for (const auto table : {info(form).weights, info(form).shape})
          for (const ParameterInfo& p : table) names.insert(std::string(p.name) + "=");
    return {names.begin(), names.end()};
  }
  if (value != Value::form) return {};
  std::vector<std::string> names;
  for (const auto list : {catalogue(), targets()})
    for (const Reflectance& form : list) names.emplace_back(info(form).name);
  return names;
}

std::vector<std::string> suffixes_of(Value value) {
  const std::vector<std::string> tables{"csv", "binary", "bsdf", "exr", "txt", "astm"};
  switch (value) {
    case Value::samples:
      return tables;
    case Value::either: {
      std::vector<std::string> both = tables;
      both.push_back("json");
      return both;
    }
    case Value::material:
    case Value::scene:
    case Value::json:
      return {"json"};
    case Value::picture:
      return {"png", "exr"};
    case Value::light:
      return {"hdr", "exr"};
    case Value::report:
      return {"html", "md"};
    default:
      return {};
  }
}

bool is_file(Value value) {
  return value >= Value::samples;
}

}  // namespace brdf::cli
