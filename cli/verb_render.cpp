#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/verbs.h"
#include "io/error.h"
#include "io/json.h"
#include "render/job.h"
#include "render/parity.h"

#include "cli/parameters.h"

namespace brdf::cli {
namespace {

void print(const render::JobReport& report, const render::Job& job, bool json) {
  if (!json) {
    std::cout << job.output.string() << ": " << report.width << " x " << report.height << " on "
              << report.device;
    if (report.clipped > 0) std::cout << ", " << 100 * report.clipped << " % of the surface clipped";
    std::cout << '\n';
    if (report.difference) {
      std::cout << (job.compare ? "against Embree" : "against the samples") << ": relative MSE "
                << report.difference->rel_mse << ", PSNR " << report.difference->psnr
                << " dB, coverage mismatch " << 100 * report.difference->coverage_mismatch << " %\n";
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

Exit run_parity(const std::vector<std::string>& names, bool all, bool json) {
  std::vector<AnyForm> forms;
  for (const std::string& name : names) forms.push_back(require_form(name));
  if (all) for_each_form([&](auto form) { forms.emplace_back(form); });
  if (forms.empty()) throw InputError("--parity needs --all or --form");
  render::Device device;
  const auto print_row = [&](const render::ParityRow& row) {
    if (json) return;
    std::cout << row.form << ", " << row.parameters << ", " << row.gbuffer_bits << " bits: relative MSE "
              << row.difference.rel_mse << " (all pixels " << row.rel_mse_all << "), coverage mismatch "
              << 100 * row.difference.coverage_mismatch << " %" << (render::passes(row) ? "" : "  FAILS")
              << std::endl;
  };
  bool good = true;
  io::Json out;
  out["provenance"] = io::to_json(io::provenance());
  out["rows"] = io::Json::array();
  for (const render::ParityRow& row : render::parity(device, forms, 512, print_row)) {
    io::Json r;
    r["form"] = row.form;
    r["parameters"] = row.parameters;
    r["gbuffer_bits"] = row.gbuffer_bits;
    r["rel_mse"] = row.difference.rel_mse;
    r["bound"] = render::parity_bound(row.gbuffer_bits);
    r["rel_mse_all"] = row.rel_mse_all;
    r["near_horizon"] = row.near_horizon;
    r["coverage_mismatch"] = row.difference.coverage_mismatch;
    out["rows"].push_back(r);
    good = good && render::passes(row);
  }
  if (json) std::cout << io::to_text(out);
  return good ? Exit::kGood : Exit::kFailed;
}

}  // namespace

void add_render(CLI::App& app) {
  struct Options {
    render::Job job;
    std::string compare, maps;
    std::vector<std::string> forms;
    bool json = false, parity = false, all = false, lookup_pictures = false;
    int map_size = 256;
    std::uint64_t seed = 1;
  };
  auto options = std::make_shared<Options>();
  render::Job& job = options->job;
  CLI::App* verb = app.add_subcommand("render", "Render materials or a scene with the deferred renderer");
  verb->add_option("MATERIAL", job.materials, "Material JSON files, one sphere each");
  verb->add_option("--scene", job.scene, "A scene's JSON file; a MATERIAL is then put on every object");
  verb->add_option("-o,--output", job.output,
                   "Picture to write: .exr (linear, layers) or .png (as displayed)");
  verb->add_option("--width", job.width, "Pixels across, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  verb->add_option("--height", job.height, "Pixels down, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  verb->add_option("--gbuffer-bits", job.gbuffer_bits, "Bits per channel of the seven targets: 8, 16 or 32")
      ->check(CLI::IsMember({8, 16, 32}))
      ->capture_default_str();
  verb->add_option("--shading", job.shading,
                   "brdf, vertex_color, flat, gouraud, phong, phong_blinn or lookup, instead of the scene's");
  verb->add_flag("--per-vertex", job.per_vertex,
                 "phong, phong_blinn, lookup: once per vertex instead of per pixel");
  verb->add_flag("--as-coded", job.as_coded, "With the articles' slips");
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
  verb->add_option("--measured", job.measured,
                   "A sample table, rendered beside the material with the same lights (no ambient)");
  verb->add_flag("--split", job.split,
                 "PNG: left half the material, right half the reference or the samples");
  verb->add_flag("--parity", options->parity, "Measure deferred against Embree, form by form; no picture");
  verb->add_flag("--all", options->all, "With --parity: every form");
  verb->add_option("--form", options->forms, "With --parity: these forms");
  verb->add_option("--maps", options->maps,
                   "Write seeded texture maps into the folder -o: rusty_metal or tiles")
      ->check(CLI::IsMember({"rusty_metal", "tiles"}));
  verb->add_option("--size", options->map_size, "With --maps: pixels")
      ->check(CLI::Range(8, 4096))
      ->capture_default_str();
  verb->add_option("--seed", options->seed, "With --maps: of the random numbers")->capture_default_str();
  verb->add_flag("--lookup-pictures", options->lookup_pictures,
                 "Write the lookup article's tables and their factors as PNG into the folder -o");
  verb->add_option("--memory-limit", job.memory_limit, "Most device memory, for instance 500M or 1G")
      ->transform(CLI::AsSizeValue(false));
  verb->add_flag("--validation", job.validation, "Run under Vulkan's validation and synchronisation layers");
  verb->add_flag("--json", options->json, "Measures as JSON on stdout");
  verb->footer("Example: brdf render fitted.json --compare embree -o fitted.png");
  on_run(*verb, [options] {
    if (options->parity) return run_parity(options->forms, options->all, options->json);
    if (options->job.output.empty()) throw InputError("-o is required (see brdf render --help)");
    if (!options->maps.empty()) {
      render::write_maps(options->maps, options->map_size, options->seed, options->job.output);
      return Exit::kGood;
    }
    if (options->lookup_pictures) {
      render::write_lookup_pictures(options->job.output);
      return Exit::kGood;
    }
    options->job.compare = !options->compare.empty();
    const render::JobReport report = render::run(options->job);
    print(report, options->job, options->json);
    return report.validation_messages > 0 ? Exit::kFailed : Exit::kGood;
  });
}

}  // namespace brdf::cli
