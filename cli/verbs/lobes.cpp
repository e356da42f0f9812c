#include <CLI/CLI.hpp>
#include <memory>

#include "cli/options/products.h"
#include "cli/options/progress.h"
#include "cli/steps/shown_shader.h"
#include "cli/verb.h"
#include "render/job.h"

namespace brdf::cli {
namespace {

struct LobesCall {
  render::Job job;
  ShownShader shader;
  bool body = false;
};

enum LobesProduct : unsigned { kPlot = 1, kBody = 2, kAnyLobe = kPlot | kBody };
constexpr OptionOf kLobesOptions[] = {
    {"MATERIAL --state --output --width --measured --theta --shader", kAnyLobe},
    {"--compare --solo", kPlot},
    {"--body", kBody},
    {"--param --entry --returns --define --include-folder --texture --set", kAnyLobe, "--shader"},
};

Exit run_lobes(const CLI::App& verb, LobesCall& o) {
  refuse_without_effect(verb, kLobesOptions, o.body ? kBody : kPlot,
                        o.body ? "a lobe's body" : "a lobe's plot");
  show_shader(o.shader, "lobes", o.job);
  const auto step = step_line("brdf lobes");
  step(o.body ? "drawing the body" : "drawing the plot");
  render::write_lobes(o.job, o.body ? render::LobeView::body : render::LobeView::plane);
  return Exit::good;
}

}  // namespace

void add_lobes(CLI::App& app) {
  auto o = std::make_shared<LobesCall>();
  render::Job& job = o->job;
  CLI::App* verb =
      add_verb(app, Purpose::look, "lobes", "Draw the lobe of a material, as a polar plot or as a body");
  verb->add_option("MATERIAL", job.materials, "A material's JSON file; a sample table is used as --measured");
  verb->add_option("--state", job.state, "Saved state of the viewer");
  verb->add_option("-o,--output", job.output, "Picture to write: .png")->required();
  verb->add_option("--width", job.width, "Width in pixels (default 640)")->check(CLI::Range(1, 16384));
  verb->add_option("--compare", job.compare, "A second material's JSON file, in the same plot");
  verb->add_option("--measured", job.measured, "Sample table; its points are drawn");
  verb->add_option("--theta", job.plot_theta,
                   "Angle of incidence in degrees (default 45; with --measured the nearest measured one)")
      ->check(CLI::Range(0.0, 90.0));
  verb->add_option("--solo", job.solo, "Draw only one curve, for instance \"A r\"");
  verb->add_flag("--body", o->body, "Draw the whole lobe as a body; its radius is the cube root of f_r");
  add_shown_shader(*verb, o->shader);
  require_every_option(*verb, kLobesOptions);
  verb->footer(
      "Examples: brdf lobes a.json --compare b.json --theta 60 -o lobes.png\n"
      "          brdf lobes fitted.json --measured samples.csv --body --theta 30 -o lobe.png\n"
      "          brdf lobes a.json --compare b.json --solo \"A r\" --width 480 -o curve.png\n"
      "          brdf lobes --state brdf-view.json -o as_viewed.png\n"
      "          brdf lobes --shader ggx.glsl --set roughness=0.3 -o ggx.png");
  on_run(*verb, [o, verb] { return run_lobes(*verb, *o); });
}

}  // namespace brdf::cli
