#include "render/gpu/renderer.h"

#include "io/files/error.h"

namespace brdf::render {
namespace {

constexpr int kTile = 64;  // pixels; the software driver's threads share tiles of this size
constexpr std::uint32_t kPartTriangles = 30000;  // of a part of the geometry

int tiles_along(std::uint32_t pixels) {
  return (int(pixels) + kTile - 1) / kTile;
}

VkExtent2D extent_of(const Camera& camera) {
  return {std::uint32_t(camera.width), std::uint32_t(camera.height)};
}

void require_shaders(const PreparedScene& scene) {
  if (scene.scene.shading != Shading::brdf) return;
  for (const auto& layer : scene.layers)
    for (const Item& item : layer)
      if (item.form) require_shader(*item.form);
}

void require_environment(const PreparedScene& scene, const RendererOptions& options) {
  if (!scene.environment) return;
  if (!uses_gbuffer(scene.scene, options))
    throw InputError("an environment needs the shading brdf and the deferred path");
}

// Checks the size before anything is allocated, so that a picture that cannot fit is refused at once.
Device& checked(Device& device, const PreparedScene& scene, const RendererOptions& options) {
  const Camera& camera = scene.scene.camera;
  const std::string size = std::to_string(camera.width) + " x " + std::to_string(camera.height);
  if (std::uint32_t(std::max(camera.width, camera.height)) > device.max_image_size()) {
    throw InputError("a picture of " + size + " is larger than the device's " +
                     std::to_string(device.max_image_size()));
  }
  require_shaders(scene);
  require_environment(scene, options);
  device.require_memory(
      picture_bytes(scene.scene, options) + (scene.environment ? light_bytes(*scene.environment) : 0),
      "a picture of " + size);
  const std::size_t items = scene.layers.size() * scene.meshes.size();
  if (options.gbuffer_bits == 8 && items > 255) {
    throw InputError("8-bit targets distinguish at most 255 objects and terms; the scene has " +
                     std::to_string(items));
  }
  if (options.path == Path::forward && scene.layers.size() > 1) {
    throw InputError("the forward path draws materials with one form, but the scene has sums");
  }
  return device;
}

// Returns rectangles that cover these tiles of a picture, row by row.
std::vector<VkRect2D> rectangles(VkExtent2D extent, int first, int count) {
  const int across = tiles_along(extent.width);
  std::vector<VkRect2D> out;
  const auto add = [&](int column, int row, int columns, int rows) {
    const VkRect2D whole{{0, 0}, extent};
    out.push_back(common(whole, {{column * kTile, row * kTile},
                                 {std::uint32_t(columns * kTile), std::uint32_t(rows * kTile)}}));
  };
  while (count > 0) {
    const int column = first % across, row = first / across;
    const int rows = column == 0 ? count / across : 0;
    const int done = rows > 0 ? rows * across : std::min(across - column, count);
    rows > 0 ? add(0, row, across, rows) : add(column, row, done, 1);
    first += done;
    count -= done;
  }
  return out;
}

}  // namespace

bool uses_gbuffer(const Scene& scene, const RendererOptions& options) {
  return scene.shading == Shading::brdf && options.path == Path::deferred;
}

std::uint64_t picture_bytes(const Scene& scene, const RendererOptions& options) {
  const std::uint64_t pixels = std::uint64_t(scene.camera.width) * std::uint64_t(scene.camera.height);
  const int targets = uses_gbuffer(scene, options) ? kTargetCount * options.gbuffer_bits / 2 : 0;
  return pixels * std::uint64_t(targets + texel_size(kColorFormat) + 4) +
         (scene.environment ? sums_bytes(pixels) : 0) + (options.has_places ? place_sums_bytes(pixels) : 0);
}

Renderer::Renderer(Device& device, const PreparedScene& scene, const RendererOptions& options)
    : device_(&checked(device, scene, options)),
      scene_(scene),
      options_(options),
      gpu_(device, scene, options.coarse),
      mesh_parts_(gpu_.mesh_parts(kPartTriangles)),
      color_(
          device, kColorFormat, extent_of(scene.scene.camera),
          VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT),
      sky_(device, gpu_) {
  make_passes();
}

void Renderer::make_passes() {
  const VkExtent2D extent = color_.extent();
  if (scene_.scene.shadow && !shadow_) shadow_.emplace(*device_, gpu_);
  if (uses_gbuffer(scene_.scene, options_)) {
    if (!deferred_) {
      gbuffer_.emplace(*device_, extent, options_.gbuffer_bits);
      deferred_.emplace(*device_, gpu_, *gbuffer_);
    }
    make_environment();
    return;
  }
  if (!depth_)
    depth_ = Image(*device_, VK_FORMAT_D32_SFLOAT, extent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT);
  if (scene_.scene.shading != Shading::brdf) {
    if (!classic_) classic_.emplace(*device_, gpu_, options_.lookup);
  } else if (!forward_) {
    forward_.emplace(*device_, gpu_);
  }
}

void Renderer::make_environment() {
  if (!scene_.environment) {
    environment_.reset();
    light_.reset();
  } else if (!environment_) {
    light_.emplace(*device_, *scene_.environment);
    environment_.emplace(*device_, gpu_, *light_, *deferred_, color_.extent(), options_.gbuffer_bits);
  }
}

void Renderer::update(const PreparedScene& scene) {
  require_shaders(scene);
  require_environment(scene, options_);
  if (scene.environment != scene_.environment) {
    environment_.reset();
    light_.reset();
  }
  if (environment_) environment_->reset();
  scene_ = scene;
  gpu_.update(scene_);
  make_passes();
}

int Renderer::parts() const {
  if (!uses_gbuffer(scene_.scene, options_)) return 1;
  const VkExtent2D extent = color_.extent();
  const int tiles = tiles_along(extent.width) * tiles_along(extent.height);
  return int(scene_.layers.size()) * (int(mesh_parts_.size()) + tiles);
}

void Renderer::record_tiles(VkCommandBuffer commands, std::size_t layer, int first, int count,
                            Timestamps* times) {
  const std::vector<VkRect2D> tiles = rectangles(color_.extent(), first, count);
  if (!environment_ || !environment_->is_smooth()) {
    for (const VkRect2D& tile : tiles)
      deferred_->record_lighting(commands, scene_, gpu_, layer, tile, color_);
    if (times) times->mark(commands, "lighting");
  }
  if (!environment_) return;
  const std::uint32_t seed = options_.seed + std::uint32_t(layer) * 0x10000u;
  if (first == 0 && !environment_->is_smooth()) environment_->record_points(commands, gpu_, seed);
  for (const VkRect2D& tile : tiles) environment_->record(commands, scene_, gpu_, layer, tile, seed, color_);
  if (times) times->mark(commands, "environment");
}

void Renderer::record_parts(VkCommandBuffer commands, int first, int count, Timestamps* times) {
  const int meshes = int(mesh_parts_.size()), of_a_layer = parts() / int(scene_.layers.size());
  if (first == 0 && has_run()) environment_->begin_run(commands);
  for (int part = first, end = first + count; part < end;) {
    const int layer = part / of_a_layer, within = part % of_a_layer;
    const int kind_end = within < meshes ? meshes : of_a_layer;
    const int together = std::min(end - part, kind_end - within);
    if (within < meshes) {
      deferred_->record_geometry(commands, scene_, gpu_, std::size_t(layer),
                                 std::span(mesh_parts_).subspan(std::size_t(within), std::size_t(together)),
                                 within == 0);
      if (times) times->mark(commands, "geometry");
    } else {
      record_tiles(commands, std::size_t(layer), within - meshes, together, times);
    }
    part += together;
  }
}

void Renderer::record_start(VkCommandBuffer commands, Timestamps* times) {
  const auto mark = [&](const char* name) {
    if (times) times->mark(commands, name);
  };
  sky_.record(commands, scene_, gpu_, color_);
  if (environment_ && scene_.scene.environment->shown) environment_->record_backdrop(commands, gpu_, color_);
  mark("background");
  if (scene_.scene.shading != Shading::brdf) {
    classic_->record(commands, scene_, gpu_, color_, depth_);
    mark("forward");
    return;
  }
  if (scene_.scene.shadow) {
    shadow_->record(commands, scene_, gpu_);
    mark("shadow");
  }
  if (options_.path == Path::forward) {
    forward_->record(commands, scene_, gpu_, color_, depth_);
    mark("forward");
  }
}

void Renderer::draw_parts(int first, int count, Timestamps* times) {
  device_->run([&](VkCommandBuffer commands) {
    if (times) times->begin(commands);
    if (first == 0) record_start(commands, times);
    if (uses_gbuffer(scene_.scene, options_)) record_parts(commands, first, count, times);
    if (first + count < parts() || !has_run()) return;
    environment_->end_run(commands, color_);
    if (times) times->mark(commands, "environment");
  });
}

void Renderer::draw_place(PlaceSums& sums, const PlaceRun& run) {
  begin_run(run);
  device_->run([&](VkCommandBuffer commands) {
    record_start(commands, nullptr);
    if (uses_gbuffer(scene_.scene, options_)) record_parts(commands, 0, parts(), nullptr);
    sums.record_add(commands, float(run.samples), run.sign);
  });
}

void Renderer::draw(Timestamps* times) {
  draw_parts(0, parts(), times);
}

void Renderer::reseed(std::uint32_t seed) {
  options_.seed = seed;
  if (environment_) environment_->reset();
}

void Renderer::draw_samples(int samples, Timestamps* times, int first, int run) {
  if (environment_) environment_->reset(samples > 0 ? std::min(samples, run) : run, first);
  do draw(times);
  while (environment_ && this->samples() < samples);
}

void Renderer::begin_run(const PlaceRun& run) {
  if (environment_) environment_->reset(run.samples, run.first, run.stride);
}

void Renderer::begin_smooth() {
  if (environment_) environment_->reset_to_smooth(options_.coarse ? 1 : 2);
}

void Renderer::draw_smooth(Timestamps* times) {
  begin_smooth();
  draw(times);
}

std::vector<float> Renderer::read_standard_error() {
  if (environment_) return environment_->standard_error();
  return std::vector<float>(std::size_t(color_.extent().width) * color_.extent().height * 4, 0.0f);
}

std::vector<float> Renderer::read_color() {
  return read_rgba(*device_, color_);
}

std::vector<float> Renderer::read_target(Target target) {
  if (!uses_gbuffer(scene_.scene, options_))
    throw InputError("this scene is drawn without the seven targets");
  if (scene_.layers.size() > 1) {  // later layers have overwritten the first
    device_->run([&](VkCommandBuffer commands) {
      deferred_->record_geometry(commands, scene_, gpu_, 0, mesh_parts_, true);
    });
  }
  return read_rgba(*device_, gbuffer_->targets[std::size_t(target)]);
}

}  // namespace brdf::render
