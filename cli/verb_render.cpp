#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/verbs.h"
#include "io/error.h"
#include "io/json.h"
#include "render/job.h"

namespace brdf::cli {
namespace {

void print(const render::JobReport& report, const render::Job& job, bool json) {
  if (!json) {
    std::cout << job.output.string() << ": " << report.width << " x " << report.height << " on "
              << report.device;
    if (report.clipped > 0) std::cout << ", " << 100 * report.clipped << " % of the surface clipped";
    std::cout << '\n';
    if (report.difference) {
      std::cout << "against Embree: relative MSE " << report.difference->rel_mse << ", PSNR "
                << report.difference->psnr << " dB, coverage mismatch "
                << 100 * report.difference->coverage_mismatch << " %\n";
    }
    return;
  }
  io::Json out;
  out["provenance"] = io::to_json(io::provenance());
  out["output"] = job.output.string();
  out["device"] = report.device;
  out["width"] = report.width;
  out["height"] = report.height;
  out["clipped"] = report.clipped;
  if (report.difference) {
    out["rel_mse"] = report.difference->rel_mse;
    out["psnr"] = report.difference->psnr;
    out["coverage_mismatch"] = report.difference->coverage_mismatch;
  }
  if (job.validation) out["validation_messages"] = report.validation_messages;
  std::cout << io::to_text(out);
}

}  // namespace

void add_render(CLI::App& app) {
  struct Options {
    render::Job job;
    std::string compare;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  render::Job& job = options->job;
  CLI::App* verb = app.add_subcommand("render", "Render materials or a scene with the deferred renderer");
  verb->add_option("MATERIAL", job.materials, "Material JSON files, one sphere each");
  verb->add_option("--scene", job.scene, "A scene's JSON file; a MATERIAL is then put on every object");
  verb->add_option("-o,--output", job.output,
                   "Picture to write: .exr (linear, layers) or .png (as displayed)")
      ->required();
  verb->add_option("--width", job.width, "Pixels across, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  verb->add_option("--height", job.height, "Pixels down, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  verb->add_option("--gbuffer-bits", job.gbuffer_bits, "Bits per channel of the seven targets: 8, 16 or 32")
      ->check(CLI::IsMember({8, 16, 32}))
      ->capture_default_str();
  verb->add_option("--tone-map", job.tone_map, "none, srgb, reinhard or thesis, instead of the scene's");
  verb->add_option("--exposure", job.exposure, "Stops, instead of the scene's")
      ->check(CLI::Range(-20.0f, 20.0f));
  verb->add_flag("--forward", job.forward, "Light every fragment as it is drawn, without the seven targets");
  verb->add_flag("--gbuffer", job.gbuffer, "PNG: the seven targets side by side; EXR: as layers too");
  verb->add_option(
          "--compare", options->compare,
          "embree: measure against the reference; PNG: picture, reference and difference side by side; "
          "EXR: as layers")
      ->check(CLI::IsMember({"embree"}));
  verb->add_flag("--split", job.split, "With --compare and PNG: left half rendered, right half the reference")
      ->needs("--compare");
  verb->add_option("--memory-limit", job.memory_limit, "Most device memory, for instance 500M or 1G")
      ->transform(CLI::AsSizeValue(false));
  verb->add_flag("--validation", job.validation, "Run under Vulkan's validation and synchronisation layers");
  verb->add_flag("--json", options->json, "Measures as JSON on stdout");
  verb->footer("Example: brdf render fitted.json --compare embree -o fitted.png");
  on_run(*verb, [options] {
    options->job.compare = !options->compare.empty();
    const render::JobReport report = render::run(options->job);
    print(report, options->job, options->json);
    return report.validation_messages > 0 ? Exit::kFailed : Exit::kGood;
  });
}

}  // namespace brdf::cli
