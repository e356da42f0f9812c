#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cli/options/next_step.h"
#include "cli/options/options.h"
#include "cli/options/progress.h"
#include "cli/options/shader_options.h"
#include "cli/options/streams.h"
#include "cli/options/terminal.h"
#include "cli/steps/microsurface.h"
#include "cli/verb.h"
#include "io/csv/csv.h"
#include "io/files/numbers.h"
#include "io/files/output.h"
#include "synth/instrument.h"
#include "synth/texels.h"
#include "texel/stack.h"

namespace brdf::cli {
namespace {

struct SynthCall {
  MaterialOptions material;
  std::string grid = "hemisphere";
  std::vector<double> azimuths;
  synth::Instrument instrument;
  micro::SampleSettings microsurface = {.surface = ""};
  std::string texels;  // empty: one sample
  synth::TexelOptions stack;
  std::string output;
};

// Adds the options of a stack. Options of a goniophotometer do not apply to a stack.
void add_texel_options(CLI::App& verb, SynthCall& o) {
  CLI::Option* texels = verb.add_option(
      "--texels", o.texels,
      "Write a stack of photographs with WIDTHxHEIGHT texels instead of the table of one sample");
  for (const char* other : {"--grid", "--theta-i", "--step", "--azimuths", "--blind-zone", "--aperture",
                            "--source-aperture", "--clip-negatives", "--sigma-columns", "--microsurface"})
    if (CLI::Option* option = verb.get_option_no_throw(other)) texels->excludes(option);
  verb.add_option("--lights", o.stack.lights,
                  "Number of lights of a stack, over the hemisphere to 75 degrees")
      ->needs(texels);
  verb.add_option("--viewers", o.stack.viewers,
                  "Number of viewers of a stack; each sees every light (default: one, along z)")
      ->needs(texels);
  verb.add_option_function<std::vector<std::string>>(
          "--vary",
          [&o](const std::vector<std::string>& words) {
            for (const std::string& word : words) o.stack.vary.push_back(synth::parse_variation(word));
          },
          "Parameter that varies smoothly over a stack: name=low:high")
      ->allow_extra_args(false)
      ->needs(texels);
  verb.add_option("--tilt", o.stack.tilt, "Largest tilt of a stack's normals, which vary smoothly, degrees")
      ->needs(texels);
  verb.add_option("--dark-level", o.stack.dark_level,
                  "Constant that is added to every pixel of a stack, 1/sr")
      ->needs(texels);
  verb.add_option("--light-distance", o.stack.rig.light_distance,
                  "Distance of the lights from the middle of a stack (default: infinite)")
      ->needs(texels);
  verb.add_option("--viewer-distance", o.stack.rig.viewer_distance,
                  "Distance of the viewers from the middle of a stack (default: infinite)")
      ->needs(texels);
  verb.add_option("--texel-size", o.stack.rig.texel_size, "Side of a texel, in the unit of the distances")
      ->needs(texels);
  verb.add_option("--registration", o.stack.registration,
                  "Shift of each image of a stack in x and y, as a standard deviation in texels")
      ->needs(texels);
}

void add_options(CLI::App& verb, SynthCall& o) {
  synth::Instrument& instrument = o.instrument;
  add_material_options(verb, o.material);
  add_material_argument(verb, o.material);
  verb.add_option("--grid", o.grid,
                  "Directions: in_plane, hemisphere, merl or a CSV of directions; joined by +")
      ->capture_default_str();
  verb.add_option("--theta-i", instrument.grid.theta_i, "Incidences of in_plane and hemisphere, degrees")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb.add_option("--step", instrument.grid.step,
                  "Detector step, degrees (default 1 in plane, 5 over the hemisphere)");
  verb.add_option(
          "--azimuths", o.azimuths,
          "The sample is turned by each of these and measured again, degrees (default 0; 0,45,90 for an "
          "anisotropic material)")
      ->delimiter(',')
      ->allow_extra_args(false);
  verb.add_option("--blind-zone", instrument.grid.blind_zone,
                  "Leave out directions if detector and source are closer than this, degrees");
  verb.add_option("--aperture", instrument.aperture, "Full angular width of the detector, degrees");
  verb.add_option("--source-aperture", instrument.source_aperture,
                  "Full angular width of the source, degrees");
  verb.add_option("--noise", instrument.noise, "Log-normal noise: factor exp(s z - s^2/2), mean 1");
  verb.add_option("--noise-floor", instrument.noise_floor, "Standard deviation of additive noise, 1/sr");
  verb.add_option("--saturation", instrument.saturation, "Cut readings above this, 1/sr");
  verb.add_flag("--clip-negatives", instrument.clip_negatives, "Set negative readings to 0");
  verb.add_flag("--sigma-columns", instrument.sigma_columns, "Write the standard deviation of every value");
  verb.add_option("--seed", instrument.seed, "Seed of the noise")->capture_default_str();
  add_microsurface_options(verb, o.microsurface);
  add_texel_options(verb, o);
  verb.add_option("-o,--output", o.output, "CSV to write; for a stack, the folder")->required();
  verb.footer(
      "Examples: brdf synth --form ward --set alpha_x=0.05 --set alpha_y=0.16 --grid hemisphere+in_plane "
      "--noise 0.05 --seed 7 -o samples.csv\n"
      "          brdf synth fitted.json --grid in_plane --theta-i 15,45 --step 2 --blind-zone 4 "
      "-o "
      "plane.csv\n"
      "          brdf synth --form ward --aperture 1 --source-aperture 0.5 --noise-floor 0.001 "
      "--sigma-columns "
      "-o noisy.csv\n"
      "          brdf synth --form ward --noise-floor 0.01 --saturation 20 --clip-negatives -o cut.csv\n"
      "          brdf synth --microsurface gaussian --set alpha=0.3 --size 256 --cell 5 --min-power 0.001 "
      "--threads 2 -o traced.csv\n"
      "          brdf synth --microsurface mirror_grooves --set alpha=0.2 --bounces 8 --orders --surfaces 64 "
      "--rays 4096 --gpu -o grooves.csv\n"
      "          brdf synth brushed.json --grid in_plane --azimuths 0,45,90 -o turned.csv\n"
      "          brdf synth --form cook_torrance --set kd=0.3,0.2,0.1 --texels 64x64 --lights 151 --viewers "
      "1 --vary "
      "alpha=0.08:0.5 --tilt 30 --noise 0.03 --dark-level 0.001 --registration 0.2 -o stack\n"
      "          brdf synth --form ward --texels 32x32 --lights 100 --light-distance 80 --viewer-distance "
      "120 --texel-size "
      "0.5 -o near_stack");
}

Exit write(const io::SampleTable& table, const std::string& path) {
  io::write_samples(path, table);
  Note() << "brdf synth: " << io::plural(table.rows(), "direction") << ", "
         << io::plural(table.channels.size(), "channel") << " to " << path;
  for (const std::string& warning : table.warnings) Warning() << "brdf synth: warning: " << warning;
  print_next_step({view_command(path)}, TextStream::error);
  return Exit::good;
}

Exit run_microsurface(const SynthCall& o) {
  micro::SampleSettings settings = o.microsurface;
  if (!o.instrument.grid.theta_i.empty()) settings.theta_i = o.instrument.grid.theta_i;
  if (!o.azimuths.empty()) settings.azimuths = o.azimuths;
  settings.seed = o.instrument.seed;
  return write(trace_microsurface(std::move(settings), o.material.set), o.output);
}

Exit run_stack(const SynthCall& o) {
  synth::TexelOptions stack = o.stack;
  synth::parse_texels(o.texels, stack);
  require_file({"-o", o.output}, "a stack is a folder");
  stack.noise = o.instrument.noise;
  stack.noise_floor = o.instrument.noise_floor;
  stack.saturation = o.instrument.saturation;
  stack.seed = o.instrument.seed;
  io::check_folder_target({"-o", o.output}, {texel::kLightsFile}, {o.material.material});
  synth::write_stack(o.output, choose_material(o.material, "synth"), stack,
                     progress_line("brdf synth: images"));
  Note() << "brdf synth: " << io::plural(std::size_t(stack.lights) * std::size_t(stack.viewers), "image")
         << " of " << stack.width << " x " << stack.height << " texels to " << o.output;
  return Exit::good;
}

Exit run_synth(const SynthCall& o) {
  if (!o.texels.empty()) return run_stack(o);
  const std::vector<std::string> parts = synth::grid_parts(o.grid);
  io::check_targets({{"-o", o.output}}, {parts.begin(), parts.end()});
  if (!o.microsurface.surface.empty()) return run_microsurface(o);
  const Material material = choose_material(o.material, "synth");
  synth::Instrument instrument = o.instrument;
  instrument.grid.parts = parts;
  instrument.grid.azimuths = o.azimuths.empty() ? synth::usual_azimuths(material) : o.azimuths;
  return write(synth::measure(material, instrument, progress_line("brdf synth: directions")), o.output);
}

}  // namespace

void add_synth(CLI::App& app) {
  auto options = std::make_shared<SynthCall>();
  CLI::App* verb =
      add_verb(app, Purpose::measure, "synth", "Measure a known material with a virtual goniophotometer");
  add_options(*verb, *options);
  on_run(*verb, [options] { return run_synth(*options); });
}

}  // namespace brdf::cli
