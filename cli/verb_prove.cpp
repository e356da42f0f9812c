#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/options.h"
#include "cli/progress.h"
#include "cli/shader_options.h"
#include "cli/terminal.h"
#include "cli/verbs.h"
#include "io/material_file.h"
#include "io/output.h"
#include "io/settings.h"
#include "io/text.h"
#include "prove/check/certificate.h"
#include "prove/report.h"
#ifdef BRDF_HAS_PROVE_SHADER
#include "prove/shader/shader_proof.h"
#endif

namespace brdf::cli {
namespace {

struct ProveCall {
  std::vector<std::string> materials, forms, properties, require;
  bool all = false, json = false;
  std::optional<double> seconds;
  double gap = prove::Options().gap;
  std::string output, check;
  ShaderOptions shader;
};

std::vector<prove::Property> properties_of(const std::string& option, const std::vector<std::string>& names) {
  std::vector<prove::Property> properties;
  for (const std::string& name : names) {
    const auto found = find_named<prove::Property>(name);
    if (!found) throw InputError(option + " " + name + ": must be one of " + known_names<prove::Property>());
    properties.push_back(*found);
  }
  return properties;
}

Exit run_check(const ProveCall& o) {
  if (o.all || !o.forms.empty() || !o.materials.empty() || is_given(o.shader))
    throw InputError("--check " + o.check + ": takes no material, no --form, no --shader and no --all");
  const prove::Checked checked = prove::check(io::read_content(o.check));
  if (o.json) {
    io::Json json = io::to_json(io::provenance());
    json["checked"] = {{"results", checked.results}, {"leaves", checked.leaves}, {"faults", checked.faults}};
    std::cout << io::to_text(json) << '\n';
  } else {
    for (const std::string& fault : checked.faults) std::cout << io::printable(fault) << '\n';
    std::cout << checked.results << " results, " << checked.leaves
              << " leaves: " << (checked.faults.empty() ? "all hold" : "rejected") << '\n';
  }
  return checked.faults.empty() ? Exit::good : Exit::failed;
}

void prove_shader(const ShaderOptions& options, bool quiet, const prove::Options& how,
                  std::vector<prove::Proof>& proofs) {
#ifdef BRDF_HAS_PROVE_SHADER
  const auto model = shader::load_shader(choice_of(options));
  for (const std::string& note : model->function().notes)
    if (!quiet) Note() << "brdf prove: " << options.file << ": " << note;
  const std::string words = " " + shader::command_words(choice_of(options));
  for (prove::Proof& p : prove::prove(*model, model->material(model), words, how))
    proofs.push_back(std::move(p));
#else
  (void)options, (void)quiet, (void)how, (void)proofs;
#endif
}

Exit run_prove(const ProveCall& o) {
  if (!o.check.empty()) return run_check(o);
  io::check_targets({{"-o", o.output}});
  prove::Options options;
  const auto required = properties_of("--require", o.require);
  if (!o.properties.empty()) options.properties = properties_of("--property", o.properties);
  for (const prove::Property p : required)
    if (std::ranges::find(options.properties, p) == options.properties.end()) options.properties.push_back(p);
  if (o.seconds && !(*o.seconds > 0)) throw InputError("--seconds: must be above 0");
  if (!(o.gap > 0)) throw InputError("--gap: must be above 0");
  options.search.seconds = o.seconds.value_or(20);
  options.gap = o.gap;
  if (!o.output.empty() && !o.materials.empty())
    throw InputError("-o " + o.output + ": a certificate is of forms, not of materials (" +
                     o.materials.front() + ")");
  if (!o.output.empty() && is_given(o.shader))
    throw InputError("-o " + o.output + ": a certificate is of forms, not of a shader (" + o.shader.file +
                     ")");
  std::vector<Material> materials;
  for (const std::string& file : o.materials) materials.push_back(io::read_material(file));
  prove::Options of_materials = options;
  of_materials.search.seconds = o.seconds.value_or(60);
  std::vector<prove::Proof> proofs;
  for (std::size_t k = 0; k < materials.size(); ++k)
    for (prove::Proof& p : prove::prove(materials[k], o.materials[k], of_materials))
      proofs.push_back(std::move(p));
  std::vector<Reflectance> forms;
  if (is_given(o.shader)) prove_shader(o.shader, o.json, options, proofs);
  if (o.all || !o.forms.empty() || (materials.empty() && proofs.empty())) forms = forms_of(o.forms, o.all);
  const auto progress = progress_line("brdf prove: forms");
  for (const Reflectance& form : forms) {
    for (prove::Proof& p : prove::prove(form, options)) proofs.push_back(std::move(p));
    progress(int(&form - forms.data()) + 1, int(forms.size()));
  }
  if (!o.output.empty()) io::write_file_atomically(o.output, prove::to_certificate(proofs));
  if (o.json)
    std::cout << io::to_text(prove::to_json(proofs)) << '\n';
  else
    prove::print(std::cout, proofs);
  const bool failed = std::ranges::any_of(proofs, [&](const prove::Proof& p) {
    return p.verdict == prove::Verdict::refuted ||
           (p.verdict != prove::Verdict::proved &&
            std::ranges::find(required, p.claim.property) != required.end());
  });
  return failed ? Exit::failed : Exit::good;
}

}  // namespace

void add_prove(CLI::App& app) {
  auto o = std::make_shared<ProveCall>();
  CLI::App* verb =
      add_verb(app, Purpose::judge, "prove", "Prove properties of forms over their whole domain");
  verb->add_option("MATERIALS", o->materials, "materials (JSON), each channel at its parameters");
  add_repeated_option(*verb, "--form", o->forms, "a form over its whole parameter domain");
  verb->add_flag("--all", o->all, "every form");
  add_shader_options(*verb, o->shader);
  offer_names<prove::Property>(
      verb->add_option("--property", o->properties, "which properties, separated by commas (default: all)")
          ->delimiter(',')
          ->allow_extra_args(false));
  offer_names<prove::Property>(
      verb->add_option("--require", o->require, "properties that must be proved, else exit 1")
          ->delimiter(',')
          ->allow_extra_args(false));
  verb->add_option("--seconds", o->seconds, "of search for each property (default: 20, of a material 60)")
      ->capture_default_str();
  verb->add_option("--gap", o->gap, "how far above the largest albedo that is known its bound may lie")
      ->capture_default_str();
  verb->add_option("-o,--output", o->output, "certificate of what is proved (JSON)");
  verb->add_option("--check", o->check, "a certificate to verify, without any search");
  verb->add_flag("--json", o->json, "JSON on stdout");
  verb->footer(
      "Exit code 1 where a property is refuted, a required one is not proved, or a certificate is rejected.\n"
      "Examples: brdf prove --all --property finite,non_negative -o certificate.json\n"
      "          brdf prove --check certificate.json\n"
      "          brdf prove --form oren_nayar --property energy --gap 1e-3\n"
      "          brdf prove material.json --property energy\n"
      "          brdf prove --form cook_torrance --property rounding\n"
      "          brdf prove --shader paint.glsl --property finite,non_negative\n"
      "          brdf prove --form ward --require finite,reciprocity --seconds 5 --json");
  on_run(*verb, [o] { return run_prove(*o); });
}

}  // namespace brdf::cli
