// What the command line offers, read from the parser's own tables: of it man pages, completions and a list
// for programs are made, so that none of them can lack an option.
#pragma once

#include <string>
#include <vector>

#include "cli/surface/values.h"

namespace CLI {
class App;
}

namespace brdf::cli {

struct OptionSurface {
  std::vector<std::string> names;  // "-o", "--output"; of a positional argument its one name in capitals
  bool positional = false, flag = false, required = false, repeats = false;
  std::string value;  // what its help calls the value: "FLOAT"; empty for a flag
  std::string description, initial;
  Value takes = Value::text;
  std::vector<std::string> words;  // that it may be, where they are known
};

struct VerbSurface {
  std::string name, description, footer;
  std::vector<OptionSurface> options;  // positional ones first
};

// The verbs of this build, in the order of `brdf --help`.
std::vector<VerbSurface> surface_of(const CLI::App& app);

// The program as text: a page in man(7) for every verb and one for the program, scripts for two shells, and
// JSON.
struct Page {
  std::string name, text;  // "brdf-fit.1"
};
std::vector<Page> man_pages(const CLI::App& app);
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string surface_json(const CLI::App& app);

}  // namespace brdf::cli
