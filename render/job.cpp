#include "render/job.h"

#include <algorithm>

#include "io/error.h"
#include "io/material_file.h"
#include "render/lookup.h"
#include "render/measured.h"
#include "render/reference.h"
#include "render/texture.h"

namespace brdf::render {
namespace {

template <class Enum, std::size_t N>
Enum named(const std::string& text, const std::array<const char*, N>& names, const std::string& option) {
  const auto found = std::find(names.begin(), names.end(), text);
  if (found != names.end()) return Enum(found - names.begin());
  std::string known;
  for (const char* name : names) (known += known.empty() ? "" : ", ") += name;
  throw InputError(option + " " + text + ": must be one of " + known);
}

void check_output(const Job& job) {
  if (job.compare && !job.measured.empty()) throw InputError("give one of --compare and --measured");
  if (job.split && !job.compare && job.measured.empty())
    throw InputError("--split needs --compare or --measured");
  const std::string suffix = job.output.extension().string();
  if (suffix != ".exr" && suffix != ".png") {
    throw InputError("-o " + job.output.string() + ": the name must end in .exr or .png");
  }
}

std::vector<std::pair<std::string, Material>> load_materials(const Job& job) {
  std::vector<std::pair<std::string, Material>> materials;
  for (const std::filesystem::path& file : job.materials) {
    materials.emplace_back(file.stem().string(), io::read_material(file));
    const std::size_t channels = materials.back().second.channels.size();
    if (channels != 1 && channels != 3) {
      throw InputError(file.string() + ": has " + std::to_string(channels) +
                       " channels; the renderer takes 1 or 3");
    }
  }
  return materials;
}

// In the order of kTargetNames: 0 colour, 1 direction, 2 position.
constexpr std::array kTargetKinds{0, 1, 0, 2, 0, 1, 1};

}  // namespace

Scene scene_of(const Job& job) {
  const auto materials = load_materials(job);
  if (job.scene.empty() && materials.empty())
    throw InputError("nothing to render: give a MATERIAL or --scene");
  Scene scene = job.scene.empty() ? material_scene(materials) : load_scene(job.scene);
  if (!job.scene.empty() && !materials.empty()) {
    if (materials.size() > 1) throw InputError("--scene takes one MATERIAL at most, to put on every object");
    for (Object& object : scene.objects) {
      object.material_name = materials[0].first;
      object.material = materials[0].second;
    }
  }
  if (job.width) scene.camera.width = *job.width;
  if (job.height) scene.camera.height = *job.height;
  if (job.exposure) scene.exposure = *job.exposure;
  if (job.shading) {
    scene.shading = named<Shading>(*job.shading, kShadingNames, "--shading");
    if (scene.shading != Shading::brdf) scene.tone_map = ToneMap::none;
  }
  if (job.tone_map) scene.tone_map = named<ToneMap>(*job.tone_map, kToneMapNames, "--tone-map");
  scene.per_vertex |= job.per_vertex;
  scene.as_coded |= job.as_coded;
  return scene;
}

std::vector<BytePicture> target_pictures(Renderer& renderer) {
  const Camera& camera = renderer.scene().scene.camera;
  float extent = 1e-6f;
  for (const Item& item : renderer.scene().layers[0]) extent = std::max(extent, item.extent);
  std::vector<BytePicture> pictures;
  for (int k = 0; k < kTargetCount; ++k) {
    Picture picture = picture_from(camera.width, camera.height, renderer.read_target(k));
    const Picture ids = picture_from(camera.width, camera.height, renderer.read_target(3));
    for (std::size_t p = 0; p < picture.pixels.size(); ++p) {
      glm::vec4& pixel = picture.pixels[p];
      const glm::vec3 value(pixel);
      const int kind = kTargetKinds[std::size_t(k)];
      if (ids.pixels[p].a < 0.5f) {
        pixel = glm::vec4(0);
      } else if (kind > 0) {
        pixel = glm::vec4((kind == 1 ? value : value / extent) * 0.5f + 0.5f, 1);
      }
    }
    pictures.push_back(
        displayed(picture, kTargetKinds[std::size_t(k)] == 0 ? ToneMap::srgb : ToneMap::none, 0));
  }
  return pictures;
}

namespace {

void write_outputs(const Job& job, Renderer& renderer, const Picture& picture, const Picture& reference) {
  const Scene& scene = renderer.scene().scene;
  if (job.output.extension() == ".png") {
    if (job.gbuffer) {
      write_png(job.output, beside(target_pictures(renderer)));
      return;
    }
    const BytePicture shown = displayed(picture, scene.tone_map, scene.exposure);
    if (!job.compare && job.measured.empty()) {
      write_png(job.output, shown);
      return;
    }
    const BytePicture other = displayed(reference, scene.tone_map, scene.exposure);
    write_png(job.output, job.split ? split(shown, other)
                                    : beside({shown, other, difference_picture(picture, reference)}));
    return;
  }
  std::vector<Layer> layers{{"", &picture, true}};
  std::vector<Picture> targets;
  if (job.gbuffer) {
    for (int k = 0; k < kTargetCount; ++k) {
      targets.push_back(picture_from(picture.width, picture.height, renderer.read_target(k)));
    }
    for (std::size_t k = 0; k < kTargetCount; ++k) layers.push_back({kTargetNames[k], &targets[k], true});
  }
  Picture difference = picture;
  if (job.compare || !job.measured.empty()) {
    for (std::size_t k = 0; k < difference.pixels.size(); ++k) difference.pixels[k] -= reference.pixels[k];
    layers.push_back({job.compare ? "reference" : "measured", &reference, true});
    layers.push_back({"difference", &difference});
  }
  write_exr(job.output, layers);
}

// What the picture stands beside: the reference, or the same scene rendered from measured values.
Picture other_picture(const Job& job, const PreparedScene& scene) {
  if (job.measured.empty()) return render_reference(scene);
  const Measured measured = interpolate(io::read_samples(job.measured));
  return render_reference(scene, {.measured = &measured});
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": cannot be made: " + error.message());
}

BytePicture bytes_of(const Texture& texture) {
  BytePicture picture(texture.width, texture.height);
  for (std::size_t k = 0; k < picture.pixels.size(); ++k) {
    picture.pixels[k] = {texture.texels[k][0], texture.texels[k][1], texture.texels[k][2]};
  }
  return picture;
}

}  // namespace

JobReport run(const Job& job) {
  check_output(job);
  PreparedScene scene = prepare(scene_of(job));
  const bool with_other = job.compare || !job.measured.empty();
  if (with_other && scene.scene.shading != Shading::brdf) {
    throw InputError("--compare and --measured need the shading brdf");
  }
  // Samples hold no ambient light: leave it out on both sides.
  if (!job.measured.empty()) scene.scene.ambient = glm::vec3(0);
  Device device({.memory_limit = job.memory_limit, .validation = job.validation});
  Renderer renderer(device, scene,
                    {.gbuffer_bits = job.gbuffer_bits, .path = job.forward ? Path::forward : Path::deferred});
  renderer.draw();
  const Camera& camera = scene.scene.camera;
  const Picture picture = picture_from(camera.width, camera.height, renderer.read_color());
  JobReport report;
  Picture other;
  if (with_other) {
    other = other_picture(job, scene);
    report.difference = compare(picture, other);
  }
  write_outputs(job, renderer, picture, other);
  report.device = device.name();
  report.width = camera.width;
  report.height = camera.height;
  report.clipped = clipped_share(picture, scene.scene.tone_map, scene.scene.exposure);
  report.validation_messages = device.validation_messages();
  return report;
}

void write_maps(const std::string& kind, int size, std::uint64_t seed, const std::filesystem::path& folder) {
  make_folder(folder);
  if (kind == "tiles") {
    write_png(folder / "tiles.png", bytes_of(floor_tile(size, seed)));
    return;
  }
  const auto maps = rusty_metal(size, seed);
  for (std::size_t k = 0; k < maps.size(); ++k) {
    write_png(folder / (std::string(kTextureNames[k]) + ".png"), bytes_of(maps[k]));
  }
}

void write_lookup_pictures(const std::filesystem::path& folder) {
  make_folder(folder);
  for (std::size_t k = 0; k < kLookupNames.size(); ++k) {
    write_png(folder / (std::string(kLookupNames[k]) + ".png"), lookup_picture(LookupFactor(k), false));
  }
  write_png(folder / "product_as_coded.png", lookup_picture(LookupFactor::product, true));
}

}  // namespace brdf::render
