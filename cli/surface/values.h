// What an option takes beyond its type: which words or files a shell offers for it.
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

// unnamed: text of which nothing is said, which the test of the surface refuses; text: nothing that could be
// offered; word: one of a list.
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

// The words that this option may be, of one that takes files besides them; returns it.
CLI::Option* offer(CLI::Option* option, std::vector<std::string> words);
// The enum's names.
template <class Enum>
CLI::Option* offer_names(CLI::Option* option) {
  return offer(option, {kNames<Enum>.begin(), kNames<Enum>.end()});
}
std::vector<std::string> offered(const CLI::Option& option);

// What it takes, by its name and type.
Value value_of(const CLI::Option& option);

// The names that are offered for a form, or for a parameter ("alpha="); none for other values.
std::vector<std::string> names_for(Value value);
// The usual suffixes of such files; none: any file.
std::vector<std::string> suffixes_of(Value value);
bool is_file(Value value);

}  // namespace brdf::cli

template <>
inline constexpr std::array<std::string_view, 16> brdf::kNames<brdf::cli::Value>{
    "unnamed", "text",  "number", "word",    "form",  "parameter", "samples", "material",
    "either",  "scene", "json",   "picture", "light", "report",    "file",    "folder"};
