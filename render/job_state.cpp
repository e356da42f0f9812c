// Converts a job to a view state, reading its files.
#include <algorithm>
#include <cmath>

#include "io/columns/foreign_json.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/material/below_zero.h"
#include "io/material/material_json.h"
#include "render/frames.h"
#include "render/gpu/held.h"
#include "render/job_parts.h"

namespace brdf::render {
namespace {

template <class Enum>
Enum named(const std::string& text, const std::string& option) {
  const std::optional<Enum> found = find_named<Enum>(text);
  if (!found) throw InputError(option + " " + text + ": must be one of " + known_names<Enum>());
  return *found;
}

void check_usage(const Job& job) {
  if (!job.compare.empty() && !job.measured.empty()) throw InputError("give one of --compare and --measured");
  if (!job.state.empty() && (!job.scene.empty() || !job.materials.empty() || compared(job)))
    throw InputError("--state contains the scene and the comparison: give no other input with it");
  if (!job.shape.empty() && (!job.scene.empty() || !job.state.empty()))
    throw InputError("--shape selects the object of a MATERIAL; a scene has its own objects");
  if (job.output.empty()) return;
  if (job.turntable) return check_frames(job);
  if (!is_png(job.output) && job.output.extension() != ".exr")
    throw InputError("-o " + job.output.string() + ": the name must end in .exr or .png");
}

// `named`: set to whether the file gives the material's name.
std::pair<std::string, Material> load_material(const std::filesystem::path& file, bool* named = nullptr) {
  io::MaterialFile read = io::read_material_file(file);
  require_colours(read.material.channels, file.string());
  io::require_not_below_zero(read.material, file.string());
  if (named) *named = !read.name.empty();
  return {read.name.empty() ? file.stem().string() : read.name, std::move(read.material)};
}

// Shows the same picture from farther away with a smaller field of view; spheres at the ends of a row then
// look round.
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
  if (materials.size() > 1)
    throw InputError("--scene accepts at most one MATERIAL, which is applied to every object");
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
  if ((job.per_vertex || job.as_coded) && scene.shading == Shading::brdf)
    throw InputError(
        std::string(job.per_vertex ? "--per-vertex" : "--as-coded") +
        ": applies to the shadings of the articles: give --shading phong, phong_blinn or lookup");
  scene.per_vertex |= job.per_vertex;
  scene.as_coded |= job.as_coded;
}

// Returns whether the studio lights the materials: if they are only viewed, and nothing about them is
// measured, compared or taken apart.
bool stands_in_the_studio(const Job& job) {
  const bool alone = job.scene.empty() && job.state.empty() && !(job.materials.empty() && job.row.empty());
  const bool is_looked_at = is_png(job.output) || job.turntable || job.in_window;
  return alone && is_looked_at && !job.hard_light && !compared(job) && !job.show && !job.shading &&
         !job.forward && !job.gbuffer && !job.probe;
}

// Puts balls on the floor of the studio, seen from a little above and from farther away, so that the floor
// and the shadow on it are seen.
void stand_on_floor(Scene& scene) {
  constexpr float kAbove = 14, kFarther = 1.22f, kLower = 0.12f;  // degrees; a factor; in radii
  scene.environment->floor = -1.0f;
  const float distance = kFarther * glm::length(scene.camera.position - scene.camera.target);
  scene.camera.target.y -= kLower;
  scene.camera.position = scene.camera.target + distance * glm::vec3(0, std::sin(glm::radians(kAbove)),
                                                                     std::cos(glm::radians(kAbove)));
}

}  // namespace

bool shows_materials_in_light(const Job& given) {
  const Job job = with_samples_told(given);
  const bool alone = job.scene.empty() && job.state.empty() && !(job.materials.empty() && job.row.empty());
  return alone && !compared(job) && (job.environment || stands_in_the_studio(job));
}

// If the job consists of materials alone, the environment becomes the only light and is shown behind the
// objects.
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
      if (environment.picture == name_of(Formula::studio) && job.shape.empty()) stand_on_floor(scene);
    }
  }
  if (!job.rotation) return;
  if (!scene.environment)
    throw InputError("--rotate rotates an environment: give --environment, or a scene with an environment");
  scene.environment->rotation = *job.rotation;
}

Job with_samples_told(Job job) {
  std::vector<std::filesystem::path> materials;
  for (const std::filesystem::path& file : std::exchange(job.materials, {})) {
    // A pipe can be read only once and is assumed to contain a material.
    if (!std::filesystem::is_regular_file(file) || io::may_be_material(io::read_content(file))) {
      materials.push_back(file);
    } else if (job.measured.empty()) {
      job.measured = file;
    } else {
      throw InputError(file.string() + ": is a second table of samples in addition to " +
                       job.measured.string());
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
      state.everywhere = job.shape.empty();  // the tyres of a car keep their material
    }
  }
  give_room(state);
  apply_overrides(job, state.scene);
  if (job.gbuffer && is_png(job.output)) state.display = Display::gbuffer;
  if (job.show) state.display = named<Display>(*job.show, "--show");
  if (job.state.empty() && needs_other(state.display) && !compared(job))
    throw InputError("--show " + *job.show + " needs --compare or --measured");
  if (job.split && state.display != Display::split)
    throw InputError("--split-at sets the position of the split: give --show split");
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
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
  };
  for (const Object& object : state.scene.objects) add(object.material, object.material_name);
  if (state.material) add(*state.material, state.material_name);
  return notes;
}

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

}  // namespace brdf::render
