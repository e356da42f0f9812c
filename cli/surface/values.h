// The kind of value that an option takes beyond its type, which determines the words or files that a shell
// offers.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/names.h"

namespace CLI {
class Option;
}

namespace brdf::cli {

// - unnamed: text without a declared kind, which the test of the surface rejects
// - text: text for which no words can be offered
// - word: one of a list
enum class Value {
  unnamed,
  text,
  number,
  word,
  form,
  parameter,
  samples,
  material,
  either,
  scene,
  json,
  picture,
  light,
  report,
  file,
  folder
};

// Declares words that this option accepts, in addition to files if it takes files. Returns the option.
CLI::Option* offer(CLI::Option* option, std::vector<std::string> words);
// Declares the enum's names.
template <class Enum>
CLI::Option* offer_names(CLI::Option* option) {
  return offer(option, {kNames<Enum>.begin(), kNames<Enum>.end()});
}
// Returns the words that were declared, or the list of a CLI11 check.
std::vector<std::string> offered(const CLI::Option& option);

// Returns the kind of the value of a verb's option: from its row in option_table.cpp, or from its words or
// type.
Value value_of(std::string_view verb, const CLI::Option& option);

// Returns the names offered for a form or for a parameter ("alpha="). Empty for other kinds.
std::vector<std::string> names_for(Value value);
// Returns the usual suffixes of such files. Empty: any file.
std::vector<std::string> suffixes_of(Value value);
// Returns true if values of this kind are files or folders.
bool is_file(Value value);

}  // namespace brdf::cli

template <>
inline constexpr std::array<std::string_view, 16> brdf::kNames<brdf::cli::Value>{
    "unnamed", "text",  "number", "word",    "form",  "parameter", "samples", "material",
    "either",  "scene", "json",   "picture", "light", "report",    "file",    "folder"};
