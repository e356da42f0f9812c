// Times of the renderer, as medians of interleaved runs: a frame against the least that the same targets
// cost, forward against deferred, first frame, memory. Usage: bench_render [RUNS]
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "io/error.h"
#include "render/picture.h"
#include "render/renderer.h"
#include "render/shader_code.h"

namespace brdf::render {
namespace {

double milliseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// Runs the works one after the other, `runs` times after one warm-up; medians in milliseconds.
std::vector<double> interleaved(int runs, const std::vector<std::function<void()>>& works) {
  std::vector<std::vector<double>> times(works.size());
  for (const auto& work : works) work();
  for (int run = 0; run < runs; ++run) {
    for (std::size_t k = 0; k < works.size(); ++k) times[k].push_back(milliseconds(works[k]));
  }
  std::vector<double> medians;
  for (const auto& t : times) medians.push_back(median(t));
  return medians;
}

PreparedScene sphere(int width, int height, const char* form = "cook_torrance") {
  Scene scene = material_scene({{form, make_material(*find_form(form))}});
  scene.camera.width = width;
  scene.camera.height = height;
  return prepare(std::move(scene));
}

// The least that a frame with seven targets costs: clear them, run the vertex shader on every triangle, copy
// them.
class Floor {
 public:
  Floor(Device& device, const PreparedScene& scene)
      : device_(&device),
        scene_(scene),
        gpu_(device, scene),
        from_(device, extent(), 16),
        to_(device, extent(), 16) {
    const std::array sets{gpu_.frame_layout(), gpu_.maps_layout()};
    layout_ = make_pipeline_layout(device, sets, sizeof(int));
    pipeline_ = make_pipeline(device, {.vertex = shader_code::mesh_vertex(),
                                       .fragment = shader_code::gbuffer(),
                                       .constants = {16, 0},
                                       .input = VertexInput::mesh,
                                       .colors = std::vector(kTargetCount, gbuffer_format(16)),
                                       .depth = true,
                                       .vertices_only = true,
                                       .layout = layout_.get()});
  }
  void draw() {
    device_->run([&](VkCommandBuffer commands) {
      begin_targets(commands, from_);
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
      const std::array sets{gpu_.frame_set(), gpu_.maps_set(0)};
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 2, sets.data(), 0,
                              nullptr);
      gpu_.draw(commands, layout_.get(), 0, 0);
      vkCmdEndRendering(commands);
      for (std::size_t k = 0; k < kTargetCount; ++k) copy(commands, from_.targets[k], to_.targets[k]);
    });
  }

 private:
  VkExtent2D extent() const {
    return {std::uint32_t(scene_.scene.camera.width), std::uint32_t(scene_.scene.camera.height)};
  }
  static void copy(VkCommandBuffer commands, Image& from, Image& to) {
    from.transition(commands, Use::transfer_source);
    to.transition(commands, Use::transfer_destination, true);
    VkImageCopy region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.extent = {from.extent().width, from.extent().height, 1};
    vkCmdCopyImage(commands, from.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.get(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
  }

  Device* device_;
  PreparedScene scene_;
  GpuScene gpu_;
  GBuffer from_, to_;
  Owned<VkPipelineLayout> layout_;
  Owned<VkPipeline> pipeline_;
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
  std::printf("\nframe of %d triangles, seven 16-bit targets, cook_torrance, one light (ms, median of %d)\n",
              kSphereTriangles, runs);
  std::printf("%12s %8s %10s %10s %12s %8s\n", "picture", "frame", "geometry", "lighting", "least", "ratio");
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
    const std::vector<double> ms = interleaved(runs, {frame, [&] { floor.draw(); }});
    std::printf("%6dx%-5d %8.1f %10.1f %10.1f %12.1f %8.2f\n", width, height, ms[0], median(geometry),
                median(lighting), ms[1], ms[0] / ms[1]);
  }
  std::printf("least: clear the seven targets, vertex work of the same mesh, copy the targets\n");
}

// Layers of spheres behind each other: forward rendering lights what is then hidden.
Scene crowd(int lights) {
  Scene scene;
  scene.camera = {{0, 0, 12}, {0, 0, 0}, {0, 1, 0}, 30, 640, 360};
  for (int z = 0; z < 4; ++z) {
    for (int x = 0; x < 5; ++x) {
      Object object;
      object.mesh = "sphere:5120";
      object.material = make_material(cook_torrance{});
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
  std::printf("%8s %10s %10s %20s\n", "lights", "forward", "deferred", "forward/deferred");
  for (const int lights : {1, 4, 16, 64}) {
    const PreparedScene scene = prepare(crowd(lights));
    Renderer deferred(device, scene), forward(device, scene, {.path = Path::forward});
    const std::vector<double> ms = interleaved(runs, {[&] { forward.draw(); }, [&] { deferred.draw(); }});
    std::printf("%8d %10.1f %10.1f %20.2f\n", lights, ms[0], ms[1], ms[0] / ms[1]);
  }
}

float highlight_peak(Device& device, const char* form, double exponent) {
  Material material = make_material(*find_form(form));
  material.terms[0].shape[0][0] = exponent;
  for (auto& weights : material.terms[0].weights) weights = {0, 1};
  Scene scene = material_scene({{form, material}});
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
  std::printf("\nbrightest pixel of a sphere, kd 0, ks 1\n%10s %10s %14s %8s\n", "exponent", "phong",
              "blinn_phong", "ratio");
  for (const double n : {5.0, 20.0, 100.0, 500.0}) {
    const float phong_peak = highlight_peak(device, "phong", n),
                blinn = highlight_peak(device, "blinn_phong", n);
    std::printf("%10.0f %10.4f %14.4f %8.3f\n", n, double(phong_peak), double(blinn),
                double(blinn / phong_peak));
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
