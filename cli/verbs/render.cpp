#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>

#include "cli/options/environment_options.h"
#include "cli/options/options.h"
#include "cli/options/parameter_row.h"
#include "cli/options/products.h"
#include "cli/options/progress.h"
#include "cli/options/terminal.h"
#include "cli/steps/shown_shader.h"
#include "cli/steps/solver_beside.h"
#include "cli/verb.h"
#include "io/files/error.h"
#include "io/files/json.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/material/material_file.h"
#include "render/compare/supersample.h"
#include "render/job.h"
#include "render/light/points.h"

namespace brdf::cli {
namespace {

// `says_target`: the noise was requested, and the words state whether it was reached.
std::string noise_words(const render::JobReport& report, const render::Job& job, bool says_target) {
  if (report.not_finite > 0)
    return "the remaining noise is not known, because not all values of the picture are finite";
  if (report.noise < 0)
    return "the remaining noise is not known, because all samples are one run of " +
           std::to_string(render::kRun);
  std::string text = "remaining noise at most about " + io::percent(report.noise) + " of the mean";
  if (!says_target || !job.noise) return text;
  if (report.noise <= *job.noise) return text + " (requested: " + io::percent(*job.noise) + ")";
  return text + "; the requested " + io::percent(*job.noise) + " is not reached within the limit of " +
         std::to_string(job.most_samples) + " samples";
}

void print_text(const render::JobReport& report, const render::Job& job, bool times, bool says_target) {
  std::cout << (job.output.empty() ? "not written" : io::printable(job.output.string())) << ": "
            << report.width << " x " << report.height;
  if (job.turntable) std::cout << ", " << io::plural(std::size_t(*job.turntable), "frame");
  std::cout << " on " << report.device;
  if (report.clipped > 0) std::cout << ", " << 100 * report.clipped << " % of the surface clipped";
  if (report.not_finite > 0)
    std::cout << ", " << io::percent(report.not_finite, 2) << " of the surface without a finite value";
  std::cout << '\n';
  if (job.exposure_from_picture)
    std::cout << "exposure " << io::short_number(double(report.exposure), 4) << " stops, from the picture\n";
  if (report.difference) {
    std::cout << "against " << io::printable(report.other) << ": ";
    if (std::isfinite(report.difference->rel_mse))
      std::cout << "relative MSE " << report.difference->rel_mse << ", PSNR " << report.difference->psnr
                << " dB";
    else
      std::cout << "relative MSE and PSNR not known, because not all values are finite";
    std::cout << ", coverage mismatch " << 100 * report.difference->coverage_mismatch << " %";
    if (report.difference->not_measured > 0)
      std::cout << ", not measured " << io::short_number(100 * report.difference->not_measured, 3)
                << " % of the surface";
    std::cout << '\n';
    if (report.deviation)
      std::cout << "against the measurements themselves: median relative error "
                << io::percent(*report.deviation) << '\n';
  }
  if (report.samples > 0) {
    std::cout << io::plural(std::size_t(report.samples), "sample")
              << " of the environment's light per pixel: " << noise_words(report, job, says_target) << '\n';
  }
  for (const auto& [pass, ms] : report.passes) {
    if (times) std::cout << pass << ' ' << ms << " ms\n";
  }
  if (!report.probe) return;
  const auto print = [](const char* side, const glm::vec4& v) {
    std::cout << side << " (" << v.r << ", " << v.g << ", " << v.b << ")\n";
  };
  for (const std::string& line : lines(*report.probe)) std::cout << line << '\n';
  print("picture", report.probed_a);
  if (report.difference) print(io::printable(report.other).c_str(), report.probed_b);
}

io::Json json_of(const glm::vec3& v) {
  return io::Json::array({v.x, v.y, v.z});
}

io::Json json_of(const render::PixelProbe& probe, const render::JobReport& report) {
  io::Json out;
  out["hit"] = probe.hit;
  out["picture"] = json_of(glm::vec3(report.probed_a));
  if (report.difference) out["other"] = json_of(glm::vec3(report.probed_b));
  if (!probe.hit) return out;
  out["object"] = probe.object;
  for (const auto& [name, value] :
       {std::pair{"position", &probe.position}, std::pair{"normal", &probe.normal},
        std::pair{"wi", &probe.wi}, std::pair{"wo", &probe.wo}, std::pair{"f_r", &probe.value}})
    out[name] = json_of(*value);
  return out;
}

void print_json(const render::JobReport& report, const render::Job& job) {
  io::Json out;
  out["provenance"] = io::to_json(io::provenance());
  out["output"] = job.output.string();
  out["device"] = report.device;
  out["width"] = report.width;
  out["height"] = report.height;
  out["exposure"] = report.exposure;
  if (job.turntable) out["frames"] = *job.turntable;
  out["clipped"] = report.clipped;
  if (report.not_finite > 0) out["not_finite"] = report.not_finite;
  out["passes"] = io::Json::array();
  for (const auto& [pass, ms] : report.passes) out["passes"].push_back({{"pass", pass}, {"ms", ms}});
  if (report.difference) {
    out["other"] = report.other;
    out["rel_mse"] = io::finite_or_null(report.difference->rel_mse);
    out["psnr"] = report.difference->psnr;
    out["coverage_mismatch"] = report.difference->coverage_mismatch;
    out["not_measured"] = report.difference->not_measured;
    if (report.scatter) out["scatter_removed"] = *report.scatter;
    if (report.deviation) out["measurements_median_error"] = *report.deviation;
  }
  if (report.samples > 0) out["samples"] = report.samples;
  if (report.noise >= 0 && report.not_finite == 0) out["noise"] = report.noise;
  if (report.samples > 0 && job.noise) out["noise_wanted"] = *job.noise;
  if (report.probe) out["probe"] = json_of(*report.probe, report);
  if (job.validation) out["validation_messages"] = report.validation_messages;
  std::cout << io::to_text(out);
}

struct RenderCall {
  render::Job job;
  ShownShader shader;
  std::vector<int> probe;
  bool json = false, times = false, split = false, no_labels = false;
  std::string over;
  int balls = 6;
};

// The products: a picture of one subject or of two side by side, in display values or as linear layers; an
// animation; or measures without a file.
enum Product : unsigned { kPng = 1, kPngOfTwo = 2, kExr = 4, kExrOfTwo = 8, kAnimation = 16, kMeasures = 32 };
constexpr unsigned kOfTwo = kPngOfTwo | kExrOfTwo, kShown = kPng | kPngOfTwo | kAnimation, kAll = 63;
constexpr OptionOf kRenderOptions[] = {
    {"MATERIAL --scene --state --output --width --height --shading "
     "--per-vertex --as-coded --exposure --environment --rotate --samples "
     "--forward --memory-limit --validation --shape --over --shader --probe "
     "--times --json",
     kAll},
    {"--tone-map", kShown | kMeasures},
    {"--no-dither --show --no-labels", kShown},
    {"--hard-light", kAll & ~(kOfTwo | kMeasures)},
    {"--noise", kAll & ~kOfTwo},
    {"--gbuffer-bits", kAll},
    {"--supersample", kAll & ~kMeasures},
    {"--balls", kAll, "--over"},
    {"--turntable --fps --quality", kAnimation},
    {"--param --entry --returns --define --include-folder --texture --set", kAll, "--shader"},
    {"--compare --measured", kOfTwo | kMeasures},
    {"--split --split-at", kPngOfTwo},
    {"--gbuffer", kPng | kPngOfTwo | kExr | kExrOfTwo},
};

void read_exposure(const std::string& text, render::Job& job) {
  job.exposure_from_picture = text == "auto";
  if (job.exposure_from_picture) return;
  double stops = 0;
  if (!io::parse_number(text, stops) || !std::isfinite(stops))
    throw CLI::ValidationError("--exposure", "'" + text + "' must be a finite number, or auto");
  if (std::abs(stops) > 20)
    throw CLI::ValidationError("--exposure", text + ": must be a number from -20 to 20");
  job.exposure = float(stops);
}

void read_noise(const std::string& text, render::Job& job) {
  double percent = 0;
  const bool marked = !text.empty() && text.back() == '%';
  if (!marked || !io::parse_number(text.substr(0, text.size() - 1), percent) ||
      !(percent > 0 && percent <= 100))
    throw CLI::ValidationError("--noise", "'" + text + "' must be a percentage above 0%, for example 1%");
  job.noise = percent / 100;
}

void add_scene_options(CLI::App& verb, render::Job& job) {
  verb.add_option("MATERIAL", job.materials,
                  "Material JSON files, one sphere each; a sample table is used as --measured");
  verb.add_option("--scene", job.scene, "A scene's JSON file; a MATERIAL is then put on every object");
  verb.add_option("--state", job.state, "Saved state of the viewer; its picture is rendered");
  verb.add_option("-o,--output", job.output,
                  "Picture to write: .exr (linear, layers) or .png (as displayed)");
  verb.add_option("--width", job.width, "Width in pixels, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  verb.add_option("--height", job.height, "Height in pixels, instead of the scene's")
      ->check(CLI::Range(1, 16384));
  verb.add_option("--gbuffer-bits", job.gbuffer_bits, "Bits per channel of the seven targets: 8, 16 or 32")
      ->check(CLI::IsMember({8, 16, 32}))
      ->capture_default_str();
  offer_names<render::Shading>(verb.add_option(
      "--shading", job.shading, "Shading, instead of the scene's: " + known_names<render::Shading>()));
  verb.add_flag("--per-vertex", job.per_vertex,
                "Compute phong, phong_blinn and lookup once per vertex instead of per pixel");
  verb.add_flag("--as-coded", job.as_coded, "Shade with the errors of the articles' code");
  offer_names<render::ToneMap>(verb.add_option(
      "--tone-map", job.tone_map, "Tone map, instead of the scene's: " + known_names<render::ToneMap>()));
  verb.add_option_function<std::string>(
          "--exposure", [&job](const std::string& text) { read_exposure(text, job); },
          "Exposure in stops (-20 to 20), instead of the scene's; auto: from the picture, 95 % of the "
          "surface below 0.7")
      ->type_name("STOPS|auto");
  verb.add_option("--supersample", job.supersample,
                  "Samples across a pixel, N x N averaged (default 4; EXR with other layers: 1)")
      ->check(CLI::Range(1, render::kMostSupersample));
  verb.add_flag_callback(
      "--no-dither", [&job] { job.rounding = render::Rounding::nearest; },
      "PNG: round to the nearest byte instead of spreading the rounding as blue noise");
  add_environment_options(verb, job, job.samples);
  verb.add_option_function<std::string>(
          "--noise", [&job](const std::string& text) { read_noise(text, job); },
          "Draw samples until the remaining noise is at most this, in place of --samples; at most " +
              std::to_string(render::kMostNoiseSamples) +
              " samples (default for materials in an environment: " + io::percent(render::kDefaultNoise) +
              ", at most " + std::to_string(render::kMostDefaultSamples) + ")")
      ->type_name("PERCENT%")
      ->excludes("--samples");
  verb.add_flag("--forward", job.forward, "Light every fragment as it is drawn, without the seven targets");
  add_memory_option(verb, job.memory_limit);
  verb.add_flag("--validation", job.validation, "Run under Vulkan's validation and synchronisation layers");
}

void add_show_options(CLI::App& verb, RenderCall& o) {
  render::Job& job = o.job;
  verb.add_option("--shape", job.shape,
                  "Object that shows a MATERIAL instead of a sphere: shader_ball, cloth, vase, sedan, any "
                  "mesh of a scene or a model's file");
  CLI::Option* over = verb.add_option("--over", o.over,
                                      "Row of spheres with one MATERIAL over a parameter, NAME=FIRST:LAST, "
                                      "each labelled with the value; spaced in the scale of the parameter");
  verb.add_option("--balls", o.balls, "Number of spheres of --over")
      ->needs(over)
      ->check(CLI::Range(2, 12))
      ->capture_default_str();
  CLI::Option* turntable =
      verb.add_option("--turntable", job.turntable,
                      "Number of frames of one turn of the camera round its target; -o: an animation.webp, "
                      "or PNG files named by the number of the frame (frames/%03d.png)")
          ->check(CLI::Range(2, 9999));
  verb.add_option("--fps", job.frames_per_second, "Frames per second of an animation")
      ->needs(turntable)
      ->check(CLI::Range(1.0, 100.0))
      ->capture_default_str();
  verb.add_option("--quality", job.quality, "Quality of an animation: 0 to 99, or 100 without loss")
      ->needs(turntable)
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
}

void add_comparison_options(CLI::App& verb, RenderCall& o) {
  render::Job& job = o.job;
  offer(verb.add_option("--compare", job.compare,
                        "Compare the picture with embree (the reference) or with a material's JSON file. "
                        "PNG: picture, other and difference side by side; EXR: as layers"),
        {std::string(name_of(render::Other::embree))});
  verb.add_option("--measured", job.measured,
                  "Compare with a sample table, rendered with the same lights (no ambient)");
  offer_names<render::Display>(
      verb.add_option("--show", job.show,
                      "PNG: picture, split (A|B), flip (B alone), difference (false colours with numbers) or "
                      "gbuffer (the seven targets and the lighting)"));
  verb.add_flag("--split", o.split, "The same as --show split");
  verb.add_option("--split-at", job.split,
                  "With --show split: share of the width that shows A (default: through the highlight)")
      ->check(CLI::Range(0.0f, 1.0f));
  verb.add_flag("--gbuffer", job.gbuffer, "The same as --show gbuffer; EXR: the seven targets as layers too");
  verb.add_flag("--no-labels", o.no_labels, "PNG: leave out names and numbers");
  verb.add_option("--probe", o.probe, "Print the values at this pixel, counted from the upper left: X,Y")
      ->delimiter(',')
      ->expected(2);
  verb.add_flag("--times", o.times, "Print the time of each pass");
  verb.add_flag("--json", o.json, "Measures as JSON on stdout");
}

// Replaces the job's material by the row that --over requests.
void make_row(RenderCall& o) {
  render::Job& job = o.job;
  if (job.materials.size() != 1 || !job.scene.empty() || !job.state.empty())
    throw InputError("--over takes one MATERIAL and no scene");
  job.row_source = job.materials[0];
  job.materials.clear();
  job.row = parameter_row(io::read_material(job.row_source), o.over, o.balls);
}

unsigned product_of(const RenderCall& o) {
  const render::Job& job = o.job;
  if (job.turntable) return kAnimation;
  if (job.output.empty()) return kMeasures;
  const bool two = !job.compare.empty() || !job.measured.empty() || !job.state.empty() ||
                   !render::with_samples_told(job).measured.empty();
  if (job.output.extension() == ".exr") return two ? kExrOfTwo : kExr;
  return two ? kPngOfTwo : kPng;
}

std::string words_for(unsigned product) {
  switch (product) {
    case kAnimation:
      return "an animation";
    case kMeasures:
      return "measures without a file";
    case kPng:
    case kExr:
      return "a picture without --compare, --measured and --state";
    default:
      return "this kind of picture";
  }
}

Exit run_render(const CLI::App& verb, RenderCall& o) {
  render::Job& job = o.job;
  refuse_without_effect(verb, kRenderOptions, product_of(o), words_for(product_of(o)));
  if (verb.count("--samples") > 0 && !job.environment && (product_of(o) & (kOfTwo | kMeasures)) &&
      job.scene.empty() && job.state.empty())
    throw InputError("--samples: has no effect on " + words_for(product_of(o)) +
                     " without --environment: leave it out");
  if (job.forward && verb.count("--gbuffer-bits") > 0)
    throw InputError("--gbuffer-bits: has no effect on --forward, which has no targets: leave it out");
  show_shader(o.shader, "render", job);
  if (o.split && !job.show) job.show = "split";
  job.labels = !o.no_labels;
  if (!o.probe.empty()) job.probe = glm::ivec2(o.probe[0], o.probe[1]);
  // A run that prints only measures needs no file.
  if (job.output.empty() && o.probe.empty() && !o.times)
    throw InputError("-o is required (see brdf render --help)");
  if (!o.over.empty()) make_row(o);
  const bool says_noise = verb.count("--noise") > 0;
  if (!says_noise && verb.count("--samples") == 0 && render::shows_materials_in_light(job)) {
    job.noise = render::kDefaultNoise;
    job.most_samples = render::kMostDefaultSamples;
  }
  job.deviation = median_deviation;
  job.progress = progress_line(job.turntable ? "brdf render: frames" : "brdf render: parts of the picture");
  const render::JobReport report = render::run(job);
  job.progress = {};  // erases the line
  for (const std::string& note : report.notes) Warning() << "brdf render: " << note;
  o.json ? print_json(report, job) : print_text(report, job, o.times, says_noise);
  return report.validation_messages > 0 ? Exit::failed : Exit::good;
}

}  // namespace

void add_render(CLI::App& app) {
  auto options = std::make_shared<RenderCall>();
  CLI::App* verb =
      add_verb(app, Purpose::look, "render", "Render materials or a scene with the deferred renderer");
  add_scene_options(*verb, options->job);
  add_show_options(*verb, *options);
  add_shown_shader(*verb, options->shader);
  add_comparison_options(*verb, *options);
  verb->footer(
      "Examples: brdf render fitted.json --compare embree -o fitted.png\n"
      "          brdf render a.json --compare b.json --split -o a_and_b.png\n"
      "          brdf render fitted.json --measured samples.csv --split --split-at 0.4 -o measured.png\n"
      "          brdf render samples.csv --json -o samples.png\n"
      "          brdf render --scene scene.json --forward --exposure -1 --tone-map reinhard --no-labels -o "
      "s.png\n"
      "          brdf render --scene scene.json --shading lookup --as-coded --gbuffer-bits 8 -o "
      "looked_up.exr\n"
      "          brdf render a.json --compare b.json --show difference --memory-limit 1G -o difference.png\n"
      "          brdf render --shader ggx.glsl --set roughness=0.3 -o ggx.png\n"
      "          brdf render --scene scene.json --shading phong --per-vertex --width 640 --height 480 -o "
      "vertices.png\n"
      "          brdf render --scene scene.json --gbuffer -o targets.png\n"
      "          brdf render fitted.json --exposure auto --supersample 8 --tone-map neutral -o bright.png\n"
      "          brdf render fitted.json --supersample 1 --no-dither -o bytes.png\n"
      "          brdf render gold.json --shape shader_ball --turntable 60 --fps 30 --quality 80 -o "
      "gold.webp\n"
      "          brdf render gold.json --hard-light -o hard.png\n"
      "          brdf render gold.json --over alpha=0.05:0.8 --balls 6 -o over_alpha.png\n"
      "          brdf render gold.json --noise 1% -o smooth.png\n"
      "          brdf render fitted.json --environment studio --rotate 30 --samples 256 -o studio.png\n"
      "          brdf render --state brdf-view.json --probe 320,240 --times -o as_viewed.png");
  require_every_option(*verb, kRenderOptions);
  on_run(*verb, [options, verb] { return run_render(*verb, *options); });
}

}  // namespace brdf::cli
