// The command line as a table, read from the parser's own tables. Man pages, completions and a list for
// programs are generated from it, which ensures that each of them has every option.
#pragma once

#include <string>
#include <vector>

#include "cli/surface/values.h"

namespace CLI {
class App;
}

namespace brdf::cli {

struct OptionSurface {
  std::vector<std::string> names;  // "-o", "--output"; for a positional argument its only name, in capitals
  bool positional = false, flag = false, required = false, repeats = false;
  std::string value;  // name of the value in the help: "FLOAT"; empty for a flag
  std::string description, initial;
  std::string group;  // heading in the help; empty for a positional argument
  Value takes = Value::text;
  std::vector<std::string> words;  // permitted words, if they are known
};

struct VerbSurface {
  std::string name, description, footer;
  std::vector<OptionSurface> options;  // positional options first, then by group
};

// Returns the verbs of this build, in the order of `brdf --help`.
std::vector<VerbSurface> surface_of(const CLI::App& app);

// The description of the program as text: a man(7) page for every verb and one for the program, scripts for
// three shells, and JSON.
struct Page {
  std::string name, text;  // "brdf-fit.1" for example
};
// Return the man pages, the completion scripts of bash, zsh and fish, and the list in JSON.
std::vector<Page> man_pages(const CLI::App& app);
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);
std::string surface_json(const CLI::App& app);

}  // namespace brdf::cli
