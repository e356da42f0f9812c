#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "brdf/trace.h"
#include "cli/options.h"
#include "cli/verbs.h"
#include "io/error.h"
#include "io/output.h"
#include "io/provenance.h"
#include "io/text.h"

namespace brdf::cli {
namespace {

std::string glsl_number(double value) {
  std::string text = io::to_text(static_cast<double>(static_cast<float>(value)));
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

// One parameter of all channels as a vec3; one channel stands for all three.
std::string glsl_vector(const Term& term, std::size_t parameter) {
  const auto value = [&](std::size_t channel) {
    return glsl_number(term.weights[term.weights.size() == 1 ? 0 : channel][parameter]);
  };
  return "vec3(" + value(0) + ", " + value(1) + ", " + value(2) + ")";
}

std::string call(const Term& term, const std::string& wi, const std::string& wo) {
  const ReflectanceInfo& form = info(term.form);
  std::string text = "brdf_eval_" + std::string(form.name) + "(" + wi + ", " + wo;
  for (std::size_t k = 0; k < form.shape.size(); ++k) text += ", " + glsl_number(term.shape[0][k]);
  for (std::size_t k = 0; k < form.weights.size(); ++k) text += ", " + glsl_vector(term, k);
  return text + ")";
}

// vec3 brdf_material(wi, wo): the sum of the terms with their parameters as constants.
std::string material_function(const Material& material) {
  const std::size_t channels = material.channels.size();
  if (channels != 1 && channels != 3)
    throw InputError("--to glsl needs 1 or 3 channels, the material has " + std::to_string(channels));
  std::string text = "vec3 brdf_material(vec3 wi, vec3 wo) {\n  vec3 f = vec3(0.0);\n";
  for (const Term& term : material.terms) {
    if (term.shape.size() > 1) throw InputError("--to glsl needs one shape for all channels");
    if (term.tangent_phi == Angle{}) {
      text += "  f += " + call(term, "wi", "wo") + ";\n";
      continue;
    }
    const std::string c = glsl_number(std::cos(term.tangent_phi.radians())),
                      s = glsl_number(std::sin(term.tangent_phi.radians()));
    const auto turned = [&](const std::string& w) {
      return "vec3(" + w + ".x * " + c + " + " + w + ".y * " + s + ", " + w + ".y * " + c + " - " + w +
             ".x * " + s + ", " + w + ".z)";
    };
    text += "  f += " + call(term, turned("wi"), turned("wo")) + ";\n";
  }
  return text + "  return f;\n}\n";
}

// A whole shader, so that it compiles as it is; `include` leaves out what only a whole shader may have.
std::string glsl(const Material& material, bool is_form, bool include) {
  std::string text = "// Written by brdf " BRDF_VERSION ": " + io::provenance().command +
                     "\n// Unit vectors in the local frame: normal +z, tangent +x; values are f_r in 1/sr.\n";
  if (!include) text += "#version 450\n";
  text += glsl_kernels();
  std::vector<Reflectance> written;
  for (const Term& term : material.terms) {
    if (std::find(written.begin(), written.end(), term.form) != written.end()) continue;
    written.push_back(term.form);
    text += term.form->glsl();
  }
  if (!is_form) text += material_function(material);
  if (!include) text += "void main() {}\n";
  return text;
}

}  // namespace

void add_export(CLI::App& app) {
  struct Options {
    MaterialChoice material;
    std::string to, output;
    bool include = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("export", "Write a form or a material as shader source");
  add_material_options(*verb, options->material);
  verb->add_option("--to", options->to, "glsl")->required()->check(CLI::IsMember({"glsl"}));
  verb->add_option("-o,--output", options->output, "File to write (default: stdout)");
  verb->add_flag("--include", options->include,
                 "Functions only, for an #include: without #version and main()");
  verb->footer(
      "The output is a whole shader of any stage (GLSL 4.50, Vulkan) with an empty main().\n"
      "With --form alone the functions take the parameters as arguments; with --set or --material a "
      "function\n"
      "brdf_material(wi, wo) with the parameters as constants is added.\n"
      "Example: brdf export --form ward --to glsl -o ward.glsl");
  on_run(*verb, [options] {
    const Material material = choose_material(options->material);
    const std::string text =
        glsl(material, options->material.material.empty() && options->material.set.empty(), options->include);
    if (options->output.empty())
      std::cout << text;
    else
      io::write_file_atomically(options->output, text);
    return Exit::good;
  });
}

}  // namespace brdf::cli
