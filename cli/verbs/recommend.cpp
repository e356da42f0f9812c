#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/terminal.h"
#include "cli/verb.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/material/settings.h"
#include "trade/recommend/recommend.h"

namespace brdf::cli {
namespace {

struct RecommendArguments {
  trade::RecommendOptions options;
  std::string metric = "image", output;
  ShaderOptions shader;
  std::vector<std::string> set;
  std::string reference;
  std::string compare;  // the folder with scenes and materials
  bool json = false;
};

Exit run_comparison(const RecommendArguments& a) {
  const std::filesystem::path data = a.compare;
  const auto rows = trade::compare_held_out(data / "scenes", data / "materials", a.options.progress);
  io::Json json = io::Json::array();
  std::size_t better = 0;
  const auto print = [&](const char* format, auto... columns) {
    char line[256];
    std::snprintf(line, sizeof line, format, columns...);
    if (!a.json) std::cout << line << '\n';
  };
  print("%-22s %-20s %-14s %14s %14s", "scene", "material", "form", "scene-weighted", "hemisphere");
  for (const trade::HeldOut& row : rows) {
    better += row.scene_weighted < row.hemisphere_wide;
    json.push_back({{"scene", row.scene},
                    {"material", row.material},
                    {"form", row.form},
                    {"scene_weighted", row.scene_weighted},
                    {"hemisphere_wide", row.hemisphere_wide}});
    print("%-22s %-20s %-14s %14.4f %14.4f", row.scene.c_str(), row.material.c_str(), row.form.c_str(),
          row.scene_weighted, row.hemisphere_wide);
  }
  if (a.json) std::cout << io::to_text({{"rows", json}, {"better", better}}) << '\n';
  print("image error at held-out light and camera positions: the scene's weighting is better in %zu of %zu",
        better, rows.size());
  return Exit::good;
}

// Uses a shader's material as the reference for the candidates.
void choose_shader(RecommendArguments& a) {
  const auto shader = load(a.shader, "recommend");
  if (!shader && !a.set.empty()) throw InputError("--set " + a.set.front() + ": needs --shader FILE");
  if (!shader) return;
  if (!a.options.reference.empty()) throw InputError("give one of MATERIAL and --shader");
  io::MaterialChoice choice;
  choice.made = shader->material;
  choice.set = a.set;
  a.options.made = io::choose_material(choice);
}

Exit run_recommendation(const RecommendArguments& a) {
  const trade::Recommendation r = trade::recommend(a.options);
  if (!a.output.empty()) trade::write_recommendation(a.output, r);
  if (a.json) {
    std::cout << io::to_text(trade::to_json(r)) << '\n';
  } else {
    PlainText() << trade::to_text(r);
    if (!a.output.empty())
      print_next_step({open_page((std::filesystem::path(a.output) / "report.html").string())});
  }
  return r.chosen ? Exit::good : Exit::failed;
}

}  // namespace

void add_recommend(CLI::App& app) {
  auto a = std::make_shared<RecommendArguments>();
  CLI::App* verb = add_verb(app, Purpose::judge, "recommend", "Find the cheapest model that a scene needs");
  verb->add_option("--scene", a->options.scene, "Scene file");
  verb->add_option("--reference", a->reference, "The same as MATERIAL");
  add_material_argument(*verb, a->reference, "--reference", "Material file, or samples (interpolated)");
  add_shader_options(*verb, a->shader);
  add_repeated_option(*verb, "--set", a->set, "Parameter of --shader, name=value");
  verb->add_option("--tolerance", a->options.tolerance, "Largest allowed error")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  verb->add_option("--metric", a->metric,
                   "Error: image (mean |dL| / mean L over lit pixels) or brdf (the same over hemispheres)")
      ->capture_default_str()
      ->check(CLI::IsMember({"image", "brdf"}));
  verb->add_option("--max-cost", a->options.max_cost_ns, "Largest cost, ns per evaluation")
      ->check(CLI::PositiveNumber);
  verb->add_option(
      "--ledger", a->options.ledger,
      "Ledger of `brdf trade -o`; costs that are not in it, or all costs without a ledger, are measured now");
  verb->add_option("--compare-weightings", a->compare,
                   "Recommend nothing; compare scene-weighted with hemisphere-wide fits for the scenes/ and "
                   "materials/ of this folder");
  verb->add_option("-o,--output", a->output,
                   "Folder for material, pictures and report; the report is written last");
  verb->add_flag("--json", a->json, "JSON on stdout");
  verb->footer(
      "Examples: brdf recommend data/materials/ivory_plastic.json --scene "
      "data/scenes/recommend_grazing.json --tolerance 0.05 -o out\n"
      "          brdf recommend paint.json --scene scene.json --metric brdf --ledger ledger.json "
      "--max-cost 2 --json\n"
      "          brdf recommend --scene scene.json --shader disney.brdf --set roughness=0.3 --tolerance "
      "0.02\n"
      "          brdf recommend --compare-weightings data\n"
      "Exit code 1 if no model meets the "
      "tolerance.");
  on_run(*verb, [a] {
    a->options.progress = percent_line();
    a->options.reference = a->reference;
    a->options.judge = a->metric == "image" ? trade::Judge::image : trade::Judge::brdf;
    if (!a->compare.empty() && !a->output.empty())
      throw InputError("-o " + a->output + ": --compare-weightings writes to stdout");
    if (!a->compare.empty()) return run_comparison(*a);
    choose_shader(*a);
    if (a->options.scene.empty() || (a->options.reference.empty() && !a->options.made))
      throw InputError("recommend needs --scene, and a MATERIAL or --shader (see brdf recommend --help)");
    if (!a->output.empty())
      io::check_folder_target({"-o", a->output}, trade::recommendation_files(),
                              {a->options.scene, a->options.reference, a->options.ledger, a->shader.file});
    return run_recommendation(*a);
  });
}

}  // namespace brdf::cli
