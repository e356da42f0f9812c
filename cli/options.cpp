#include "cli/options.h"

#include <CLI/CLI.hpp>

namespace brdf::cli {

void add_word_option(CLI::App& verb, const std::string& name, std::string_view initial,
                     std::function<void(const std::string&)> set, const std::string& description) {
  verb.add_option_function<std::string>(name, std::move(set), description)->default_str(std::string(initial));
}

void add_repeated_option(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                         const std::string& description) {
  verb.add_option(name, values, description)->allow_extra_args(false);
}

void add_material_options(CLI::App& verb, MaterialChoice& choice) {
  verb.add_option("--form", choice.form,
                  "A form by name (`brdf models` lists them), at its default parameters");
  verb.add_option("--material", choice.material, "A material's JSON file");
  add_repeated_option(verb, "--set", choice.set, "name=value, or one value per channel: name=v,v,v");
}

}  // namespace brdf::cli
