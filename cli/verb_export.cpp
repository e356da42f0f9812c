#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options.h"
#include "cli/verbs.h"
#include "io/glsl.h"
#include "io/output.h"

namespace brdf::cli {

void add_export(CLI::App& app) {
  struct Options {
    MaterialChoice material;
    std::string to, output;
    bool include = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("export", "Write a form or a material as shader source");
  add_material_options(*verb, options->material);
  verb->add_option("--to", options->to, "glsl (4.50, Vulkan) or glsl-es (3.00, WebGL 2)")
      ->required()
      ->check(CLI::IsMember({"glsl", "glsl-es"}));
  verb->add_option("-o,--output", options->output, "File to write (default: stdout)");
  verb->add_flag("--include", options->include,
                 "Functions only, for an #include: without #version and main()");
  verb->footer(
      "The output is a whole shader of any stage with an empty main(); of glsl-es with highp as its "
      "precision.\n"
      "With --form alone the functions take the parameters as arguments; with --set or --material a "
      "function\n"
      "brdf_material(wi, wo) with the parameters as constants is added.\n"
      "Example: brdf export --form ward --to glsl -o ward.glsl\n"
      "         brdf export --material copper.json --to glsl-es --include -o copper.glsl");
  on_run(*verb, [options] {
    io::check_targets({{"-o", options->output}}, {options->material.material});
    const Material material = choose_material(options->material);
    const std::string text = io::glsl_source(
        material, {.material = !options->material.material.empty() || !options->material.set.empty(),
                   .whole = !options->include,
                   .dialect = options->to == "glsl-es" ? GlslDialect::es : GlslDialect::vulkan});
    if (options->output.empty())
      std::cout << text;
    else
      io::write_file_atomically(options->output, text);
    return Exit::good;
  });
}

}  // namespace brdf::cli
