// Times the renderer, as medians of interleaved runs: a frame compared with the least cost of the same
// targets, forward compared with deferred rendering, first frame, memory. Usage: bench_render [RUNS]
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "render/gpu/renderer.h"
#include "render/gpu/shader_code.h"
#include "render/picture/picture.h"
#include "trade/measure/timing.h"

namespace brdf::render {
namespace {

double milliseconds(const std::function<void()>& work) {
  return 1e3 * timing::seconds_of(work, 1, timing::Clock::wall);
}

// Returns the processor time of all threads: the device is the processor, and other programs must not count.
double processor_milliseconds() {
  return 1e3 * timing::seconds_now(timing::Clock::process);
}

// Runs the works one after the other, `runs` times after one warm-up. Returns medians in milliseconds of
// elapsed time and of processor time.
struct Medians {
  double wall, processor;
};
std::vector<Medians> interleaved(int runs, const std::vector<std::function<void()>>& works) {
  std::vector<std::vector<double>> wall(works.size()), processor(works.size());
  for (const auto& work : works) work();
  for (int run = 0; run < runs; ++run) {
    for (std::size_t k = 0; k < works.size(); ++k) {
      const double before = processor_milliseconds();
      wall[k].push_back(milliseconds(works[k]));
      processor[k].push_back(processor_milliseconds() - before);
    }
  }
  std::vector<Medians> medians;
  for (std::size_t k = 0; k < works.size(); ++k)
    medians.push_back({io::median(wall[k]), io::median(processor[k])});
  return medians;
}

Reflectance microfacets() {
  return find_form_if([](const ReflectanceInfo& f) { return f.facets != nullptr; }).value();
}

PreparedScene sphere(int width, int height) {
  const Reflectance form = microfacets();
  Scene scene = material_scene({{std::string(form.info().name), make_material(form)}});
  scene.camera.width = width;
  scene.camera.height = height;
  return prepare(std::move(scene));
}

// The lower bound for a frame with seven targets: a pass that clears the targets and runs the vertex shader
// on every triangle, and a pass that copies the targets pixel by pixel.
class Floor {
 public:
  Floor(Device& device, const PreparedScene& scene)
      : device_(&device),
        scene_(scene),
        gpu_(device, scene),
        from_(device, extent(), 16),
        to_(device, extent(), 16) {
    const std::vector<VkFormat> colors(kTargetCount, gbuffer_format(16));
    const std::array sets{gpu_.frame_layout(), gpu_.maps_layout()};
    layout_ = make_pipeline_layout(device, sets, sizeof(int));
    vertices_ = make_pipeline(device, {.vertex = shader_code::mesh_vertex,
                                       .fragment = shader_code::gbuffer,
                                       .constants = {16, 0},
                                       .input = VertexInput::mesh,
                                       .colors = colors,
                                       .depth = true,
                                       .vertices_only = true,
                                       .layout = layout_.get()});
    constexpr std::array kBindings{Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, kTargetCount}};
    sampler_ = make_sampler(device, VK_FILTER_NEAREST, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
    set_layout_ = make_set_layout(device, kBindings);
    pool_ = make_descriptor_pool(device, kBindings, 1);
    set_ = allocate_set(device, pool_.get(), set_layout_.get());
    for (std::uint32_t k = 0; k < kTargetCount; ++k) {
      write_image(device, set_, 0, from_.targets[k].view(), sampler_.get(), k);
    }
    const std::array copy_sets{set_layout_.get()};
    copy_layout_ = make_pipeline_layout(device, copy_sets, 0);
    copy_ = make_pipeline(device, {.vertex = shader_code::screen_vertex,
                                   .fragment = shader_code::copy,
                                   .colors = colors,
                                   .depth = true,
                                   .layout = copy_layout_.get()});
  }
  void draw() {
    device_->run([&](VkCommandBuffer commands) {
      const std::array sets{gpu_.frame_set(), gpu_.maps_set(0)};
      begin_targets(commands, from_);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, vertices_.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 2, sets.data(), 0,
                              nullptr);
      gpu_.draw(commands, layout_.get(), 0, 0);
      vkCmdEndRendering(commands);
      for (Image& target : from_.targets) target.transition(commands, Use::sampled);
      begin_targets(commands, to_);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, copy_.get());
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, copy_layout_.get(), 0, 1, &set_, 0,
                              nullptr);
      vkCmdDraw(commands, 3, 1, 0, 0);
      vkCmdEndRendering(commands);
    });
  }

 private:
  VkExtent2D extent() const {
    return {std::uint32_t(scene_.scene.camera.width), std::uint32_t(scene_.scene.camera.height)};
  }

  Device* device_;
  PreparedScene scene_;
  GpuScene gpu_;
  GBuffer from_, to_;
  Owned<VkSampler> sampler_;
  Owned<VkDescriptorSetLayout> set_layout_;
  Owned<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  Owned<VkPipelineLayout> layout_, copy_layout_;
  Owned<VkPipeline> vertices_, copy_;
};

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

void first_frame() {
  double ms = 0;
  {
    std::optional<Device> device;
    std::optional<Renderer> renderer;
    ms = milliseconds([&] {
      const PreparedScene scene = sphere(1280, 720);
      device.emplace();
      renderer.emplace(*device, scene);
      renderer->draw();
    });
    std::printf("first frame, 1280x720, from nothing: %.0f ms; peak memory of the process %.0f MB; %s\n", ms,
                peak_memory_mb(), device->name().c_str());
  }
}

void frames(int runs) {
  Device device;
  std::printf("\nframe of %d triangles, seven 16-bit targets, microfacets, one light (ms, median of %d)\n",
              kSphereTriangles, runs);
  std::printf("%12s %8s %10s %10s %8s %8s | on the processor %8s %8s %8s\n", "picture", "frame", "geometry",
              "lighting", "least", "ratio", "frame", "least", "ratio");
  for (const auto& [width, height] : {std::pair{640, 360}, {1280, 720}, {1920, 1080}}) {
    const PreparedScene scene = sphere(width, height);
    Renderer renderer(device, scene);
    Floor floor(device, scene);
    Timestamps times(device);
    std::vector<double> geometry, lighting;
    const auto frame = [&] {
      renderer.draw(&times);
      for (const auto& [name, ms] : times.read()) {
        if (name == "geometry") geometry.push_back(ms);
        if (name == "lighting") lighting.push_back(ms);
      }
    };
    const std::vector<Medians> ms = interleaved(runs, {frame, [&] { floor.draw(); }});
    std::printf("%6dx%-5d %8.1f %10.1f %10.1f %8.1f %8.2f | %25.1f %8.1f %8.2f\n", width, height, ms[0].wall,
                io::median(geometry), io::median(lighting), ms[1].wall, ms[0].wall / ms[1].wall,
                ms[0].processor, ms[1].processor, ms[0].processor / ms[1].processor);
  }
  std::printf(
      "least: a pass that clears the seven targets and runs the vertex shader of the same mesh, a pass that "
      "copies them\n");
}

// Layers of spheres behind each other: forward rendering lights surfaces that are hidden later.
Scene crowd(int lights) {
  Scene scene;
  scene.camera = {{0, 0, 12}, {0, 0, 0}, {0, 1, 0}, 30, 640, 360};
  for (int z = 0; z < 4; ++z) {
    for (int x = 0; x < 5; ++x) {
      Object object;
      object.mesh = "sphere:5120";
      object.material = make_material(microfacets());
      object.position = {1.6f * float(x - 2), 0.3f * float(z) - 0.4f, 1.5f * float(z) - 3};
      scene.objects.push_back(object);
    }
  }
  for (int k = 0; k < lights; ++k) {
    scene.lights.push_back({true, {float(k % 8) - 3.5f, float(k / 8) - 3.5f, 6}, glm::vec3(1), 4});
  }
  return scene;
}

void forward_against_deferred(int runs) {
  Device device;
  std::printf("\nforward against deferred, 640x360, 20 spheres in four layers drawn back to front (ms)\n");
  std::printf("%8s %10s %10s %20s %26s\n", "lights", "forward", "deferred", "forward/deferred",
              "the same on the processor");
  for (const int lights : {1, 4, 16, 64}) {
    const PreparedScene scene = prepare(crowd(lights));
    Renderer deferred(device, scene), forward(device, scene, {.path = Path::forward});
    const std::vector<Medians> ms = interleaved(runs, {[&] { forward.draw(); }, [&] { deferred.draw(); }});
    std::printf("%8d %10.1f %10.1f %20.2f %26.2f\n", lights, ms[0].wall, ms[1].wall, ms[0].wall / ms[1].wall,
                ms[0].processor / ms[1].processor);
  }
}

// Returns the largest pixel value of the lobe alone.
float highlight_peak(Device& device, const Reflectance& form, double exponent) {
  const ReflectanceInfo& about = form.info();
  Material material = make_material(form);
  Term& term = material.terms.front();
  term.shape.front()[std::size_t(about.shape_index(brdf::Role::exponent))] = exponent;
  for (auto& weights : term.weights)
    for (std::size_t k = 0; k < weights.size(); ++k)
      weights[k] = about.weights[k].role == brdf::Role::diffuse ? 0 : 1;
  Scene scene = material_scene({{std::string(about.name), material}});
  scene.ambient = scene.background = glm::vec3(0);
  Renderer renderer(device, prepare(std::move(scene)), {.gbuffer_bits = 32});
  renderer.draw();
  const std::vector<float> color = renderer.read_color();
  float peak = 0;
  for (std::size_t k = 0; k < color.size(); k += 4) peak = std::max(peak, color[k]);
  return peak;
}

void highlight_peaks() {
  Device device;
  // A power of the cosine about the mirror direction, and of the half vector.
  const auto form = [](bool about_mirror) {
    return find_form_if([&](const ReflectanceInfo& f) {
             return f.canonical && f.shape_index(brdf::Role::exponent) >= 0 &&
                    (f.kink == Kink::mirror_edge) == about_mirror;
           })
        .value();
  };
  const Reflectance about_mirror = form(true), of_half = form(false);
  std::printf("\nbrightest pixel of a sphere, the lobe alone\n%10s %10s %14s %8s\n", "power",
              std::string(about_mirror.info().name).c_str(), std::string(of_half.info().name).c_str(),
              "ratio");
  for (const double n : {5.0, 20.0, 100.0, 500.0}) {
    const double mirror = highlight_peak(device, about_mirror, n), half = highlight_peak(device, of_half, n);
    std::printf("%10.0f %10.4f %14.4f %8.3f\n", n, mirror, half, half / mirror);
  }
}

}  // namespace
}  // namespace brdf::render

int main(int argc, char** argv) {
  using namespace brdf::render;
  const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 100;
  try {
    first_frame();
    frames(runs);
    forward_against_deferred(std::max(5, runs / 5));
    highlight_peaks();
  } catch (const brdf::EnvironmentError& error) {
    std::fprintf(stderr, "bench_render: %s\n", error.what());
    return 3;
  }
  return 0;
}
