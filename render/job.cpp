#include "render/job.h"

#include <algorithm>
#include <cmath>

#include "io/content.h"
#include "io/error.h"
#include "io/material_json.h"
#include "io/numbers.h"
#include "io/output.h"
#include "io/samples.h"
#include "render/compare/lobe_body.h"
#include "render/compare/lobe_plot.h"
#include "render/compare/lobe_points.h"
#include "render/compare/pictures.h"
#include "render/frames.h"
#include "render/gpu/lookup.h"
#include "render/scene/texture.h"

namespace brdf::render {
namespace {

template <class Enum>
Enum named(const std::string& text, const std::string& option) {
  const std::optional<Enum> found = find_named<Enum>(text);
  if (!found) throw InputError(option + " " + text + ": must be one of " + known_names<Enum>());
  return *found;
}

bool compared(const Job& job) {
  return !job.compare.empty() || !job.measured.empty();
}

// Nothing but samples.
bool samples_alone(const Job& job) {
  return job.materials.empty() && job.row.empty() && job.scene.empty() && job.state.empty() &&
         !job.measured.empty();
}

bool is_png(const std::filesystem::path& file) {
  return file.extension() == ".png";
}

void check_usage(const Job& job) {
  if (!job.compare.empty() && !job.measured.empty()) throw InputError("give one of --compare and --measured");
  if (!job.state.empty() && (!job.scene.empty() || !job.materials.empty() || compared(job)))
    throw InputError("--state holds the scene and what it is compared with: give nothing beside it");
  if (!job.shape.empty() && (!job.scene.empty() || !job.state.empty()))
    throw InputError("--shape is what a MATERIAL is shown on: a scene has its own");
  if (job.output.empty()) return;
  if (job.turntable) return check_frames(job);
  if (!is_png(job.output) && job.output.extension() != ".exr") {
    throw InputError("-o " + job.output.string() + ": the name must end in .exr or .png");
  }
}

// `named`: whether the file itself says what it is called.
std::pair<std::string, Material> load_material(const std::filesystem::path& file, bool* named = nullptr) {
  io::MaterialFile read = io::read_material_file(file);
  require_colours(read.material.channels, file.string());
  if (named) *named = !read.name.empty();
  return {read.name.empty() ? file.stem().string() : read.name, std::move(read.material)};
}

// The same picture from farther away: at the ends of a row balls stay round.
void step_back(Camera& camera) {
  constexpr float kFarther = 6;
  camera.position = camera.target + kFarther * (camera.position - camera.target);
  const float half = std::tan(glm::radians(camera.vertical_fov) / 2) / kFarther;
  camera.vertical_fov = glm::degrees(2 * std::atan(half));
}

Scene scene_of(const Job& job) {
  std::vector<std::pair<std::string, Material>> materials;
  bool named = false;
  for (const std::filesystem::path& file : job.materials) materials.push_back(load_material(file, &named));
  materials.insert(materials.end(), job.row.begin(), job.row.end());
  if (job.scene.empty()) {
    if (materials.empty()) throw InputError("nothing to render: give a MATERIAL, --scene or --state");
    Scene scene = job.shape.empty() ? material_scene(materials) : shape_scene(job.shape, materials);
    if (materials.size() > 1) step_back(scene.camera);
    if (materials.size() == 1 && named) scene.objects[0].label = materials[0].first;
    return scene;
  }
  Scene scene = load_scene(job.scene);
  if (materials.size() > 1) throw InputError("--scene takes one MATERIAL at most, to put on every object");
  for (Object& object : scene.objects) {
    if (materials.empty()) break;
    object.material_name = materials[0].first;
    object.material = materials[0].second;
  }
  return scene;
}

void apply_overrides(const Job& job, Scene& scene) {
  if (job.width) scene.camera.width = *job.width;
  if (job.height) scene.camera.height = *job.height;
  if (job.exposure) scene.exposure = *job.exposure;
  if (job.shading) {
    scene.shading = named<Shading>(*job.shading, "--shading");
    if (scene.shading != Shading::brdf) scene.tone_map = ToneMap::none;
  }
  apply_environment(job, scene);
  if (job.tone_map) scene.tone_map = named<ToneMap>(*job.tone_map, "--tone-map");
  scene.per_vertex |= job.per_vertex;
  scene.as_coded |= job.as_coded;
}

bool needs_other(Display display) {
  return display != Display::picture && display != Display::gbuffer;
}

// Materials to look at stand in the studio, unless something about them is measured, compared or taken apart.
bool stands_in_the_studio(const Job& job) {
  const bool alone = job.scene.empty() && job.state.empty() && !(job.materials.empty() && job.row.empty());
  const bool is_looked_at = is_png(job.output) || job.turntable;
  return alone && is_looked_at && !job.hard_light && !compared(job) && !job.show && !job.shading &&
         !job.forward && !job.gbuffer && !job.probe;
}

}  // namespace

// Spheres of materials alone are then lit by nothing else, and seen before it.
void apply_environment(const Job& given, Scene& scene) {
  Job job = given;
  if (!job.environment && stands_in_the_studio(job)) job.environment = name_of(Formula::studio);
  if (job.environment) {
    const bool spheres = job.scene.empty() && job.state.empty();
    Environment environment = scene.environment.value_or(Environment{});
    environment.picture = *job.environment;
    if (!find_named<Formula>(environment.picture))
      environment.picture = std::filesystem::absolute(environment.picture).string();
    if (!scene.environment)
      environment.shown = spheres || (!scene.sky_zenith && scene.background == glm::vec3(0));
    scene.environment = environment;
    if (spheres) {
      scene.lights.clear();
      scene.ambient = glm::vec3(0);
    }
  }
  if (!job.rotation) return;
  if (!scene.environment)
    throw InputError("--rotate turns an environment: give --environment, or a scene that has one");
  scene.environment->rotation = *job.rotation;
}

Job with_samples_told(Job job) {
  std::vector<std::filesystem::path> materials;
  for (const std::filesystem::path& file : std::exchange(job.materials, {})) {
    // A pipe can be read once: it is taken for a material.
    if (!std::filesystem::is_regular_file(file) || io::is_json(io::read_content(file))) {
      materials.push_back(file);
    } else if (job.measured.empty()) {
      job.measured = file;
    } else {
      throw InputError(file.string() + ": a second table of samples beside " + job.measured.string());
    }
  }
  job.materials = std::move(materials);
  return job;
}

std::pair<std::string, Material> any_material() {
  const auto form =
      find_form_if([](const ReflectanceInfo& info) { return info.canonical && info.facets != nullptr; });
  return {std::string(form->info().name), make_material(*form)};
}

ViewState state_of(const Job& given) {
  const Job job = with_samples_told(given);
  check_usage(job);
  ViewState state;
  if (!job.state.empty()) {
    state = load_state(job.state);
  } else {
    const bool alone = samples_alone(job);
    state.scene = alone ? material_scene({{"", any_material().second}}) : scene_of(job);
    if (alone) state.display = Display::flip;
    state.other = job.measured.empty() ? Other::embree : Other::samples;
    state.samples = job.measured;
    if (!job.compare.empty() && job.compare != "embree") {
      std::tie(state.material_name, state.material) = load_material(job.compare);
      state.other = Other::material;
      state.everywhere = job.shape.empty();  // a car's tyres stay what they are
    }
  }
  apply_overrides(job, state.scene);
  if (job.gbuffer && is_png(job.output)) state.display = Display::gbuffer;
  if (job.show) state.display = named<Display>(*job.show, "--show");
  if (job.state.empty() && needs_other(state.display) && !compared(job))
    throw InputError("--show " + *job.show + " needs --compare or --measured");
  if (job.split)
    state.split = *job.split;
  else if (job.state.empty())
    state.split = split_at_highlight(state.scene, state.selected);
  if (job.plot_theta) state.plot_theta = float(*job.plot_theta);
  return state;
}

std::vector<std::string> colour_notes(const ViewState& state) {
  std::vector<std::string> notes;
  const auto add = [&](const Material& material, const std::string& name) {
    const auto colours = io::channel_colours(material.channels);
    if (!colours || colours->note.empty()) return;
    std::string note = (name.empty() ? "the material" : name) + ": " + colours->note;
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(std::move(note));
  };
  for (const Object& object : state.scene.objects) add(object.material, object.material_name);
  if (state.material) add(*state.material, state.material_name);
  return notes;
}

namespace {

void write_exr_layers(const Job& job, const ViewState& state, Pictures& pictures, bool with_other) {
  const bool fine = job.supersample || !(with_other || job.gbuffer);
  const Picture& a = fine ? pictures.fine_a() : pictures.a_picture();
  std::vector<Layer> layers{{"", &a, true}};
  std::vector<Picture> targets;
  for (int k = 0; job.gbuffer && k < kTargetCount; ++k) {
    targets.push_back(picture_from(a.width, a.height, pictures.a().read_target(Target(k))));
  }
  for (std::size_t k = 0; k < targets.size(); ++k)
    layers.push_back({std::string(kNames<Target>[k]), &targets[k], true});
  Picture difference = a;
  if (with_other) {
    const Picture& b = fine ? pictures.fine_b() : pictures.b_picture();
    for (std::size_t k = 0; k < difference.pixels.size(); ++k) difference.pixels[k] -= b.pixels[k];
    constexpr std::array kLayerNames{"other", "measured", "reference"};  // in the order of Other
    layers.push_back({kLayerNames[std::size_t(state.other)], &b, true});
    layers.push_back({"difference", &difference});
  }
  write_exr(job.output, layers);
}

// Refuses an output that is one of the files that the picture is made of.
void check_output(const Job& job, const ViewState& state) {
  std::vector<std::filesystem::path> inputs = job.materials;
  inputs.insert(inputs.end(),
                {job.scene, job.state, job.compare, job.measured, state.samples, job.row_source});
  if (state.scene.environment && !find_named<Formula>(state.scene.environment->picture))
    inputs.push_back(state.scene.folder / state.scene.environment->picture);
  for (const Object& object : state.scene.objects) {
    inputs.push_back(state.scene.folder / object.mesh);
    for (const auto& texture : object.textures)
      if (texture) inputs.push_back(state.scene.folder / *texture);
  }
  if (job.turntable) return check_frame_targets(job, inputs);
  io::check_targets({{"-o", job.output}}, inputs);
}

BytePicture bytes_of(const Texture& texture) {
  BytePicture picture(texture.width, texture.height);
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    picture.pixels[k] = {texture.texels[k][0], texture.texels[k][1], texture.texels[k][2]};
  }
  return picture;
}

}  // namespace

JobReport run(const Job& given) {
  const Job job = with_samples_told(given);
  ViewState state = state_of(job);
  check_output(job, state);
  // Without a display of its own, a comparison shows all it has in a row.
  const bool row = compared(job) && state.display == Display::picture && !job.show;
  if (row) state.display = Display::difference;
  const bool with_other = needs_other(state.display);
  if (with_other && state.other != Other::material && state.scene.shading != Shading::brdf) {
    throw InputError("a comparison with Embree or samples needs the shading brdf");
  }
  const RendererOptions options{.gbuffer_bits = job.gbuffer_bits,
                                .path = job.forward ? Path::forward : Path::deferred};
  if ((job.gbuffer || state.display == Display::gbuffer) && !uses_gbuffer(state.scene, options))
    throw InputError("this scene is drawn without the seven targets of --gbuffer");
  const Camera& camera = state.scene.camera;
  if (job.probe && (job.probe->x < 0 || job.probe->y < 0 || job.probe->x >= camera.width ||
                    job.probe->y >= camera.height)) {
    throw InputError("--probe " + std::to_string(job.probe->x) + "," + std::to_string(job.probe->y) +
                     ": is outside the picture of " + std::to_string(camera.width) + " x " +
                     std::to_string(camera.height));
  }
  Device device({.memory_limit = job.memory_limit, .validation = job.validation});
  Finish finish{.rounding = job.rounding};
  if (job.supersample) finish.supersample = *job.supersample;
  finish.probed = job.probe.has_value();
  Pictures pictures(device, options, job.samples, finish);
  pictures.update(state, {std::uint32_t(camera.width), std::uint32_t(camera.height)});
  if (job.exposure_from_picture) state.scene.exposure = exposure_from(pictures.a_picture());
  JobReport report;
  report.exposure = state.scene.exposure;
  report.notes = colour_notes(state);
  if (std::string note = left_out_note(state); !note.empty()) report.notes.push_back(std::move(note));
  if (!pictures.samples_note().empty()) report.notes.push_back(pictures.samples_note());
  if (with_other) {
    report.other = pictures.other_name(state);
    if (!samples_alone(job)) report.difference = pictures.difference();
  }
  if (job.probe) {
    report.probe = pixel_probe(pictures.prepared(), job.probe->x, job.probe->y);
    report.probed_a = pictures.a_picture().at(job.probe->x, job.probe->y);
    if (with_other) report.probed_b = pictures.b_picture().at(job.probe->x, job.probe->y);
  }
  if (job.turntable && !job.output.empty()) {
    write_frames(job, [&](int frame) {
      ViewState turned = state;
      if (frame > 0) orbit(turned.scene.camera, float(2 * kPi * frame / *job.turntable), 0);
      pictures.update(turned, {std::uint32_t(camera.width), std::uint32_t(camera.height)});
      return row ? pictures.row(turned, job.labels) : pictures.capture(turned, job.labels);
    });
  } else if (is_png(job.output)) {
    write_png(job.output, row ? pictures.row(state, job.labels) : pictures.capture(state, job.labels));
  } else if (!job.output.empty()) {
    write_exr_layers(job, state, pictures, with_other);
  }
  report.device = device.name();
  report.width = camera.width;
  report.height = camera.height;
  report.passes = pictures.times();
  report.samples = pictures.samples_drawn();
  report.noise = pictures.noise();
  report.clipped = clipped_share(pictures.a_picture(), state.scene.tone_map, state.scene.exposure);
  report.validation_messages = device.validation_messages();
  return report;
}

namespace {

// The table whose points are drawn, and the angle of its light: the one asked for, or the nearest to the usual one.
std::optional<io::SampleTable> measured_lobe(const Job& job, ViewState& state) {
  if (state.other != Other::samples || state.samples.empty()) return std::nullopt;
  io::SampleTable table = io::read_samples(state.samples);
  const double wanted = double(state.plot_theta), nearest = nearest_light(table, wanted);
  if (!job.plot_theta && job.state.empty() && std::isfinite(nearest)) state.plot_theta = float(nearest);
  if (!(std::abs(nearest - double(state.plot_theta)) <= kNearLight))
    throw InputError(table.name() + ": has no row whose light stands within " + io::short_number(kNearLight) +
                     " degree of --theta " + io::short_number(wanted) + "; the nearest stands at " +
                     io::short_number(nearest));
  return table;
}

}  // namespace

void write_lobes(const Job& given, LobeView view) {
  const Job job = with_samples_told(given);
  if (samples_alone(job)) throw InputError("the lobe is a MATERIAL's: give one beside the samples");
  ViewState state = state_of(job);
  if (!is_png(job.output))
    throw InputError("-o " + job.output.string() + ": the plot's name must end in .png");
  check_output(job, state);
  const std::optional<io::SampleTable> table = measured_lobe(job, state);
  if (view == LobeView::body) {
    const Object& object = state.scene.objects.at(state.selected);
    write_png(job.output, lobe_body_picture(object.material, object.material_name, double(state.plot_theta),
                                            table ? &*table : nullptr, job.width.value_or(640)));
    return;
  }
  const std::vector<LobeCurve> curves = lobe_curves(state);
  const std::vector<LobeDot> dots =
      table ? lobe_dots(*table, double(state.plot_theta)) : std::vector<LobeDot>{};
  int solo = state.plot_solo;
  if (job.solo) {
    std::string known;
    for (std::size_t k = 0; k < curves.size(); ++k) {
      if (curves[k].name == *job.solo) solo = int(k);
      known += (k ? ", " : "") + curves[k].name;
    }
    if (solo < 0) throw InputError("--solo " + *job.solo + ": must be one of " + known);
  }
  write_png(job.output, lobe_picture(curves, double(state.plot_theta), solo, job.width.value_or(640), dots));
}

void write_maps(const std::string& kind, int size, std::uint64_t seed, const std::filesystem::path& folder) {
  io::make_folder(folder);
  if (kind == "tiles") {
    write_png(folder / "tiles.png", bytes_of(floor_tile(size, seed)));
    return;
  }
  const auto maps = rusty_metal(size, seed);
  for (std::size_t k = 0; k < maps.size(); ++k) {
    write_png(folder / (std::string(kNames<TextureSlot>[k]) + ".png"), bytes_of(maps[k]));
  }
}

void write_lookup_pictures(const std::filesystem::path& folder) {
  io::make_folder(folder);
  for (std::size_t k = 0; k < kNames<LookupFactor>.size(); ++k) {
    write_png(folder / (std::string(name_of(LookupFactor(k))) + ".png"),
              lookup_picture(LookupFactor(k), false));
  }
  write_png(folder / "product_as_coded.png", lookup_picture(LookupFactor::product, true));
}

}  // namespace brdf::render
