// The options of all verbs in one table: the heading under which the help lists each option, and the kind of
// its value.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "brdf/names.h"
#include "cli/surface/values.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace brdf::cli {

// Headings of the help, in the order in which they are printed.
enum class Group {
  input,
  model,
  shader,
  checks,
  measurements,
  directions,
  instrument,
  photographs,
  microsurface,
  scene,
  shading,
  comparison,
  pictures,
  window,
  accuracy,
  output,
  general
};

struct OptionRow {
  // "--seed", or the capitals of a positional argument. "maps --size" applies to one verb and precedes the
  // row of the name alone.
  std::string_view name;
  Group group;
  Value value = Value::unnamed;  // unnamed: determined by the type of the option or by its words
};

// Returns the name of an option in the table: its long name, or the capitals of a positional argument.
std::string table_name(const CLI::Option& option);

// Returns the row of the option, or null if the table has no such row.
const OptionRow* find_row(std::string_view verb, std::string_view name);

// Puts every option of all verbs under its heading. Throws std::logic_error for an option without a row,
// which ensures that no new option is left out of the groups.
void group_options(CLI::App& app);

}  // namespace brdf::cli

template <>
inline constexpr std::array<std::string_view, 17> brdf::kNames<brdf::cli::Group>{
    "Input",           "Model",        "Shader",
    "Checks",          "Measurements", "Directions",
    "Instrument",      "Photographs",  "Traced microsurface",
    "Scene and light", "Shading",      "Comparison",
    "Pictures",        "Window",       "Accuracy and time",
    "Output",          "General"};
