#include "render/gpu/renderer.h"

#include "io/files/error.h"

namespace brdf::render {
namespace {

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
    throw InputError("an environment's light needs the shading brdf and the deferred path");
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
    throw InputError("8-bit targets tell at most 255 objects and terms apart, the scene has " +
                     std::to_string(items));
  }
  if (options.path == Path::forward && scene.layers.size() > 1)
    throw InputError("the forward path draws materials of one form; the scene has sums");
  return device;
}

}  // namespace

bool uses_gbuffer(const Scene& scene, const RendererOptions& options) {
  return scene.shading == Shading::brdf && options.path == Path::deferred;
}

std::uint64_t picture_bytes(const Scene& scene, const RendererOptions& options) {
  const std::uint64_t pixels = std::uint64_t(scene.camera.width) * std::uint64_t(scene.camera.height);
  const int targets = uses_gbuffer(scene, options) ? kTargetCount * options.gbuffer_bits / 2 : 0;
  return pixels * std::uint64_t(targets + texel_size(kColorFormat) + 4) +
         (scene.environment ? sums_bytes(pixels) : 0);
}

Renderer::Renderer(Device& device, const PreparedScene& scene, const RendererOptions& options)
    : device_(&checked(device, scene, options)),
      scene_(scene),
      options_(options),
      gpu_(device, scene),
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

void Renderer::record(VkCommandBuffer commands, Timestamps* times) {
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
    return;
  }
  if (environment_) environment_->begin_run(commands);
  for (std::size_t layer = 0; layer < scene_.layers.size(); ++layer) {
    deferred_->record_geometry(commands, scene_, gpu_, layer);
    mark("geometry");
    deferred_->record_lighting(commands, scene_, gpu_, layer, color_);
    mark("lighting");
    if (!environment_) continue;
    environment_->record(commands, scene_, gpu_, layer, options_.seed + std::uint32_t(layer) * 0x10000u);
    mark("environment");
  }
  if (!environment_) return;
  environment_->end_run(commands, color_);
  mark("environment");
}

void Renderer::draw(Timestamps* times) {
  device_->run([&](VkCommandBuffer commands) {
    if (times) times->begin(commands);
    record(commands, times);
  });
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
    device_->run([&](VkCommandBuffer commands) { deferred_->record_geometry(commands, scene_, gpu_, 0); });
  }
  return read_rgba(*device_, gbuffer_->targets[std::size_t(target)]);
}

}  // namespace brdf::render
