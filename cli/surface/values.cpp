#include "cli/surface/values.h"

#include <CLI/CLI.hpp>
#include <map>
#include <set>

#include "brdf/targets.h"
#include "cli/surface/option_table.h"

namespace brdf::cli {
namespace {

std::map<const CLI::Option*, std::vector<std::string>>& offers() {
  static std::map<const CLI::Option*, std::vector<std::string>> all;
  return all;
}

}  // namespace

CLI::Option* offer(CLI::Option* option, std::vector<std::string> words) {
  offers()[option] = std::move(words);
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

Value value_of(std::string_view verb, const CLI::Option& option) {
  const OptionRow* const row = find_row(verb, table_name(option));
  const Value named = row ? row->value : Value::unnamed;
  if (is_file(named)) return named;
  if (!offered(option).empty()) return Value::word;
  if (named != Value::unnamed) return named;
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
