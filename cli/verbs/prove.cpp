#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "io/files/output.h"
#include "io/files/standard_input.h"
#include "io/files/text.h"
#include "io/material/material_file.h"
#include "io/material/settings.h"
#include "prove/check/judge.h"
#include "prove/report.h"
#ifdef BRDF_HAS_PROVE_SHADER
#include "io/files/content.h"
#include "prove/shader/self_test.h"
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
  bool self_test = false;
  std::uint64_t seed = 1;
  ShaderOptions shader;
};

// Refuses other options with --self-test, which makes its own shaders.
void refuse_beside_self_test(const CLI::App& verb) {
  if (verb.count("--seed") > 0 && verb.count("--self-test") == 0)
    throw InputError("--seed: applies to --self-test only");
  if (verb.count("--self-test") == 0) return;
  for (const char* other :
       {"--output", "--check", "--gap", "--shader", "--param", "--entry", "--returns", "--define", "-I",
        "--texture", "--form", "--all", "--property", "--require", "MATERIALS"})
    if (verb.count(other) > 0)
      throw InputError(std::string(other) + ": has no effect with --self-test: leave it out");
}

// Refuses options that have no effect with --check: the user would assume that they had one.
void refuse_beside_check(const CLI::App& verb) {
  if (verb.count("--check") == 0) return;
  for (const char* other : {"--output", "--seconds", "--gap", "--shader", "--param", "--entry", "--returns",
                            "--define", "-I", "--texture"})
    if (verb.count(other) > 0)
      throw InputError(std::string(other == std::string_view("--output") ? "-o" : other) +
                       ": has no effect with --check: leave it out");
}

Exit run_check(const ProveCall& o) {
  prove::Asked asked;
  asked.required = prove::properties_named("--require", o.require);
  asked.properties = prove::properties_named("--property", o.properties);
  if (o.all || !o.forms.empty())
    for (const Reflectance& form : forms_of(o.forms, o.all)) asked.forms.emplace_back(form.info().name);
  for (const std::string& file : o.materials)
    asked.materials.push_back({io::input_name(file), io::read_material(file)});
  const prove::Judged judged = prove::judge(io::read_content(o.check), asked);
  if (o.json) {
    io::Json json = io::to_json(io::provenance());
    json["checked"] = prove::to_json(judged);
    std::cout << io::to_text(json) << '\n';
  } else {
    prove::print(std::cout, judged);
  }
  return judged.good ? Exit::good : Exit::failed;
}

// Throws if a certificate is requested for a subject that --check cannot enclose again.
void check_certificate_target(const ProveCall& o, const std::vector<prove::NamedMaterial>& materials) {
  if (o.output.empty()) return;
  if (is_given(o.shader))
    throw InputError("-o " + o.output + ": a certificate covers forms and materials, not a shader (" +
                     o.shader.file + "): leave -o out; --json has the same results");
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const auto& [file, material] = materials[k];
    for (std::size_t j = 0; j < k; ++j)
      if (materials[j].file == file) throw InputError("-o " + o.output + ": " + file + " is named twice");
    for (const Term& term : material.terms)
      if (catalogue_index(term.form) < 0)
        throw InputError("-o " + o.output + ": a certificate covers forms of the catalogue, and " + file +
                         " has " + std::string(term.form.info().name));
  }
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

#ifdef BRDF_HAS_PROVE_SHADER
Exit run_self_test(const ProveCall& o) {
  prove::SelfTestOptions options;
  options.seed = o.seed;
  if (o.seconds) options.seconds = *o.seconds;
  const prove::SelfTest t = prove::self_test(options, progress_line("brdf prove: random shaders"));
  if (o.json) {
    io::Json json = io::to_json(io::provenance());
    json["self_test"] = {{"seed", o.seed},
                         {"planted", t.planted},
                         {"falsely_proved", t.falsely_proved},
                         {"sound", t.sound},
                         {"sound_proved", t.sound_proved},
                         {"samples_float", t.samples_float},
                         {"samples_double", t.samples_double},
                         {"outside", t.outside},
                         {"undefined_inside", t.undefined_inside},
                         {"faults", t.faults}};
    std::cout << io::to_text(json) << '\n';
  } else {
    std::cout << t.planted << " random shaders with a planted violation: " << t.falsely_proved
              << " verdicts that it contradicts\n"
              << t.sound << " sound random shaders: " << t.sound_proved << " proved in both precisions\n"
              << t.samples_float << " samples in float and " << t.samples_double
              << " in double: " << t.outside << " outside their enclosure, " << t.undefined_inside
              << " undefined where it is finite\nseed " << o.seed << '\n';
    for (const std::string& fault : t.faults) std::cout << fault << '\n';
  }
  return t.good() ? Exit::good : Exit::failed;
}
#endif

Exit run_prove(const ProveCall& o) {
  if (!o.check.empty()) return run_check(o);
  if (o.self_test) {
#ifdef BRDF_HAS_PROVE_SHADER
    return run_self_test(o);
#else
    throw EnvironmentError("--self-test: this build has no shader compiler (glslang)");
#endif
  }
  const TextStream stream = text_stream({{"-o", o.output}}, o.json);
  io::check_targets({{"-o", o.output}});
  prove::Options options;
  const auto required = prove::properties_named("--require", o.require);
  if (!o.properties.empty()) options.properties = prove::properties_named("--property", o.properties);
  for (const prove::Property p : required)
    if (std::ranges::find(options.properties, p) == options.properties.end()) options.properties.push_back(p);
  if (o.seconds && !(*o.seconds > 0)) throw InputError("--seconds: must be above 0");
  if (!(o.gap > 0)) throw InputError("--gap: must be above 0");
  options.search.seconds = o.seconds.value_or(20);
  options.gap = o.gap;
  std::vector<prove::NamedMaterial> materials;
  for (const std::string& file : o.materials)
    materials.push_back({io::input_name(file), io::read_material(file)});
  check_certificate_target(o, materials);
  prove::Options of_materials = options;
  of_materials.search.seconds = o.seconds.value_or(60);
  std::vector<prove::Proof> proofs;
  const auto material_progress = progress_line("brdf prove: materials");
  for (const prove::NamedMaterial& m : materials) {
    material_progress(int(&m - materials.data()), int(materials.size()));
    for (prove::Proof& p : prove::prove(m.material, m.file, of_materials)) proofs.push_back(std::move(p));
  }
  erase_progress();
  std::vector<Reflectance> forms;
  if (is_given(o.shader)) prove_shader(o.shader, o.json, options, proofs);
  if (o.all || !o.forms.empty() || (materials.empty() && proofs.empty())) forms = forms_of(o.forms, o.all);
  const auto progress = progress_line("brdf prove: forms");
  for (const Reflectance& form : forms) {
    progress(int(&form - forms.data()), int(forms.size()));
    for (prove::Proof& p : prove::prove(form, options)) proofs.push_back(std::move(p));
  }
  erase_progress();
  if (!o.output.empty()) io::write_file_atomically(o.output, prove::to_certificate(proofs, materials));
  if (o.json) {
    std::cout << io::to_text(prove::to_json(proofs)) << '\n';
  } else {
    if (stream == TextStream::out) prove::print(std::cout, proofs);
    if (stream == TextStream::error && !is_quiet()) prove::print(std::cerr, proofs);
    print_next_step({check_command(o.output)}, TextStream::out, "check it");
  }
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
  verb->add_option("MATERIALS", o->materials, "Materials (JSON); each channel is judged at its parameters");
  add_repeated_option(*verb, "--form", o->forms, "Form to judge over its whole parameter domain");
  verb->add_flag("--all", o->all, "Every form");
  add_shader_options(*verb, o->shader);
  offer_names<prove::Property>(
      verb->add_option("--property", o->properties, "Properties to prove, separated by commas (default: all)")
          ->delimiter(',')
          ->allow_extra_args(false));
  offer_names<prove::Property>(
      verb->add_option("--require", o->require,
                       "Properties that must be proved; otherwise the exit code is 1")
          ->delimiter(',')
          ->allow_extra_args(false));
  verb->add_option("--seconds", o->seconds,
                   "Time of the search for each property in seconds (default: 20; for a material 60)")
      ->capture_default_str();
  verb->add_option("--gap", o->gap,
                   "Largest distance between the bound of an albedo and the largest known albedo")
      ->capture_default_str();
  verb->add_option("-o,--output", o->output,
                   "Certificate of the proofs of forms and materials to write (JSON)");
  verb->add_option("--check", o->check,
                   "Certificate to verify, without any search; --require, --property, --form, --all and "
                   "MATERIALS give the properties that it must prove");
  verb->add_flag("--self-test", o->self_test,
                 "Attack the prover with random shaders that have planted violations, which must never be "
                 "proved, and with a million samples of enclosures (a minute)");
  verb->add_option("--seed", o->seed, "Seed of --self-test")->capture_default_str();
  verb->add_flag("--json", o->json, "JSON on stdout");
  verb->footer(
      "Exit code 1 if a property is refuted, a required property is not proved, or a certificate is "
      "rejected, "
      "empty, or without a requested property.\n"
      "Examples: brdf prove --all --property finite,non_negative -o certificate.json\n"
      "          brdf prove --check certificate.json --require finite\n"
      "          brdf prove --form oren_nayar --property energy --gap 1e-3\n"
      "          brdf prove material.json --property energy -o energy.json\n"
      "          brdf prove --form cook_torrance --property rounding\n"
      "          brdf prove --shader paint.glsl --property finite,non_negative\n"
      "          brdf prove --self-test --seed 7\n"
      "          brdf prove --form ward --require finite,reciprocity --seconds 5 --json");
  on_run(*verb, [o, verb] {
    refuse_beside_check(*verb);
    refuse_beside_self_test(*verb);
    return run_prove(*o);
  });
}

}  // namespace brdf::cli
