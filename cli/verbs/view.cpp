#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "cli/options/environment_options.h"
#include "cli/options/options.h"
#include "cli/options/terminal.h"
#include "cli/steps/shown_shader.h"
#include "cli/steps/solver_beside.h"
#include "cli/verb.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "io/formats/read.h"
#include "render/job.h"
#include "render/light/formula.h"
#include "render/viewer/commands.h"
#include "render/viewer/viewer.h"

namespace brdf::cli {
namespace {

// Returns the state from a saved state, a scene, or materials. Two materials become A and B.
render::ViewState initial_state(const render::Job& given, int width, int height) {
  render::Job job = render::with_samples_told(given);
  job.in_window = true;
  if (job.state.empty()) {  // the position of the split depends on them
    job.width = width;
    job.height = height;
  }
  const bool two = job.scene.empty() && job.materials.size() == 2;
  if (two) {
    job.compare = job.materials[1].string();
    job.materials.pop_back();
  }
  if (two || !job.measured.empty()) job.show = "split";
  if (job.scene.empty() && job.materials.empty() && job.row.empty() && job.state.empty()) {
    render::ViewState state;
    state.scene = render::material_scene({render::any_material()});
    if (!job.environment && !job.hard_light && job.measured.empty())
      job.environment = name_of(render::Formula::studio);
    render::apply_environment(job, state.scene);
    state.scene.camera.width = width;
    state.scene.camera.height = height;
    if (!job.measured.empty()) render::open_file(state, job.measured);
    return state;
  }
  render::ViewState state = render::state_of(job);
  if (!job.measured.empty())
    state.plot_theta = render::measured_theta(io::read_samples(job.measured), state.plot_theta);
  return state;
}

// Returns the file that the window's title names.
std::filesystem::path file_of(const render::Job& job) {
  if (!job.state.empty()) return job.state;
  if (!job.scene.empty()) return job.scene;
  if (!job.materials.empty()) return job.materials[0];
  return job.row.empty() ? job.measured : job.row_source;
}

// Prints the median time of the frames. The first five are not counted.
void print_frames(const render::ViewerReport& report) {
  const std::string frames = io::plural(std::size_t(report.frames), "frame");
  if (report.median_frame_ms > 0)
    std::cout << "median of " << frames << ": " << io::short_number(report.median_frame_ms, 3) << " ms, "
              << io::short_number(1000 / report.median_frame_ms, 3) << " frames/s\n";
  else
    std::cout << "no median of " << frames << ": the first five are not counted, give more --frames\n";
}

}  // namespace

void add_view(CLI::App& app) {
  struct ViewCall {
    render::Job job;
    render::ViewerOptions viewer;
    ShownShader shader;
    bool commands = false;
  };
  auto options = std::make_shared<ViewCall>();
  render::ViewerOptions& viewer = options->viewer;
  CLI::App* verb = add_verb(app, Purpose::look, "view", "Look at materials and scenes in a window");
  verb->add_option("MATERIAL", options->job.materials,
                   "Material JSON files: two are compared side by side; or samples");
  verb->add_option("--scene", options->job.scene, "A scene's JSON file");
  verb->add_option("--shape", options->job.shape,
                   "Object that shows a MATERIAL instead of a sphere, as in render");
  add_shown_shader(*verb, options->shader);
  verb->add_option("--measured", options->job.measured, "Sample table to compare with");
  verb->add_option("--state", options->job.state, "Saved state to start from");
  verb->add_option("--save-as", viewer.state_file, "File to which Ctrl-S saves the state")
      ->capture_default_str();
  verb->add_option("--screenshot", viewer.screenshot, "File to which P writes the picture")
      ->capture_default_str();
  verb->add_option("--width", viewer.width, "Width of the window, pixels")
      ->check(CLI::Range(64, 8192))
      ->capture_default_str();
  verb->add_option("--height", viewer.height, "Height of the window, pixels")
      ->check(CLI::Range(64, 8192))
      ->capture_default_str();
  verb->add_option("--gbuffer-bits", viewer.gbuffer_bits,
                   "Bits per channel of the seven targets: 8, 16 or 32")
      ->check(CLI::IsMember({8, 16, 32}))
      ->capture_default_str();
  add_environment_options(*verb, options->job, viewer.samples);
  add_memory_option(*verb, viewer.memory_limit);
  verb->add_option("--scale", viewer.scale, "Scale of text and panels, instead of the scale of the display")
      ->check(CLI::Range(0.5, 4.0));
  verb->add_flag("--orbit", viewer.orbit,
                 "Turn the camera with every frame; with --frames the time of the frames is printed");
  verb->add_flag("--commands", options->commands,
                 "Print the commands of the window as JSON and open no window");
  verb->add_option("--frames", viewer.frames, "Number of frames after which the window closes")
      ->check(CLI::Range(0, 1000000000));
  verb->add_flag("--validation", viewer.validation,
                 "Run under Vulkan's validation and synchronisation layers");
  verb->footer(
      "Keys and mouse:\n" + render::command_help(78) +
      "Examples: brdf view fitted.json --measured samples.csv\n"
      "          brdf view fitted.json --hard-light\n"
      "          brdf view --shader ggx.glsl --param roughness=0.05:1 --set roughness=0.3\n"
      "          brdf view --scene scenes/vase.json\n"
      "          brdf view fitted.json --environment studio --rotate 30 --samples 256 --shape shader_ball\n"
      "          brdf view --state kept.json --save-as kept.json --screenshot shown.png --width 800 --height "
      "600\n"
      "          brdf view a.json b.json --gbuffer-bits 16 --memory-limit 1G --validation --frames 100\n"
      "          brdf view fitted.json --hard-light --orbit --frames 100 --scale 2\n"
      "          brdf view --commands");
  on_run(*verb, [options, verb] {
    if (!options->commands) show_shader(options->shader, "view", options->job);
    const render::Job& job = options->job;
    if (options->commands) {
      std::cout << render::command_json();
      return Exit::good;
    }
    std::vector<io::Target> targets;  // only the requested targets: the others may never be written
    if (verb->count("--save-as") > 0) targets.push_back({"--save-as", options->viewer.state_file});
    if (verb->count("--screenshot") > 0) targets.push_back({"--screenshot", options->viewer.screenshot});
    io::check_targets(targets);
    options->viewer.state = initial_state(options->job, options->viewer.width, options->viewer.height);
    for (const std::string& note : render::colour_notes(options->viewer.state))
      Warning() << "brdf view: " << note;
    options->viewer.file = file_of(job);
    options->viewer.solver = solver_beside();
    const render::ViewerReport report = render::view(options->viewer);
    if (options->viewer.orbit && options->viewer.frames > 0) print_frames(report);
    return report.validation_messages > 0 ? Exit::failed : Exit::good;
  });
}

}  // namespace brdf::cli
