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

// text: nothing that could be offered; word: one of a list.
enum class Value {
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
  report,
  file,
  folder
};

// The words that this option may be; returns it.
CLI::Option* offer(CLI::Option* option, std::vector<std::string> words);
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
inline constexpr std::array<std::string_view, 14> brdf::kNames<brdf::cli::Value>{
    "text",   "number", "word", "form",    "parameter", "samples", "material",
    "either", "scene",  "json", "picture", "report",    "file",    "folder"};
