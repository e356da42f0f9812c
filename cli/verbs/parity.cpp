#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/steps/shown_shader.h"
#include "cli/verb.h"
#include "io/files/json.h"
#include "io/material/settings.h"
#include "render/proof/parity.h"

namespace brdf::cli {
namespace {

struct ParityCall {
  std::vector<std::string> forms;
  ShownShader shader;
  bool all = false, validation = false, json = false;
};

// Returns the requested forms and the form of the shader.
std::vector<Reflectance> asked_for(const ParityCall& o) {
  std::vector<Reflectance> forms;
  for (const std::string& name : o.forms) forms.push_back(io::require_form(name));
  if (o.all) forms.assign(catalogue().begin(), catalogue().end());
  if (const auto material = shown_material(o.shader, "parity")) forms.push_back(material->terms.front().form);
  if (forms.empty()) throw InputError("parity needs --all, --form or --shader");
  return forms;
}

io::Json row_json(const render::ParityRow& row) {
  io::Json json;
  json["form"] = row.form;
  json["parameters"] = row.parameters;
  json["gbuffer_bits"] = row.gbuffer_bits;
  json["rel_mse"] = row.difference.rel_mse;
  json["bound"] = render::parity_bound(row.gbuffer_bits);
  json["coverage_mismatch"] = row.difference.coverage_mismatch;
  return json;
}

Exit run_parity(const ParityCall& o) {
  const std::vector<Reflectance> forms = asked_for(o);
  render::Device device({.validation = o.validation});
  const auto progress = progress_line("brdf parity: forms");
  std::size_t done = 0;
  const auto print_row = [&](const render::ParityRow& row) {
    if (o.json) return;
    erase_progress();
    std::cout << row.form << ", " << row.parameters << ", " << row.gbuffer_bits << " bits: relative MSE "
              << row.difference.rel_mse << ", coverage mismatch " << 100 * row.difference.coverage_mismatch
              << " %" << (render::passes(row) ? "" : "  FAILS") << std::endl;
    progress(int(done), int(forms.size()));
  };
  bool good = true;
  io::Json out;
  out["provenance"] = io::to_json(io::provenance());
  out["rows"] = io::Json::array();
  for (; done < forms.size(); ++done) {
    progress(int(done), int(forms.size()));
    for (const render::ParityRow& row : render::parity(device, {forms[done]}, 512, print_row)) {
      out["rows"].push_back(row_json(row));
      good = good && render::passes(row);
    }
  }
  erase_progress();
  if (o.json) std::cout << io::to_text(out);
  return good ? Exit::good : Exit::failed;
}

}  // namespace

void add_parity(CLI::App& app) {
  auto o = std::make_shared<ParityCall>();
  CLI::App* verb = add_verb(app, Purpose::judge, "parity",
                            "Measure the deferred renderer against the ray-traced reference");
  add_repeated_option(*verb, "--form", o->forms, "Form to measure");
  verb->add_flag("--all", o->all, "Every form");
  add_shown_shader(*verb, o->shader);
  verb->add_flag("--validation", o->validation, "Run under Vulkan's validation and synchronisation layers");
  verb->add_flag("--json", o->json, "Rows as JSON on stdout");
  verb->footer(
      "Exit code 1 if a row is beyond its bound.\n"
      "Examples: brdf parity --all --json\n"
      "          brdf parity --form ward --validation\n"
      "          brdf parity --shader ggx.glsl --param roughness=0.05:1");
  on_run(*verb, [o] { return run_parity(*o); });
}

}  // namespace brdf::cli
