#include "render/compare/supersample.h"

namespace brdf::render {
namespace {

// Numbers of samples of a pixel that meet a surface, and that meet a surface with known values.
struct Counts {
  int surface = 0, known = 0;
};

float majority(const Counts& counts, std::size_t samples) {
  if (2 * std::size_t(counts.surface) < samples) return 0;
  return 2 * counts.known >= counts.surface ? 1 : kNotMeasured;
}

}  // namespace

std::vector<glm::vec2> sample_places(int n) {
  std::vector<glm::vec2> places;
  const auto side = double(n);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      places.emplace_back((column + (row + 0.5) / side) / side - 0.5,
                          (row + (column + 0.5) / side) / side - 0.5);
    }
  }
  return places;
}

Picture supersampled(const PreparedScene& scene, int n, const Draw& draw) {
  if (n <= 1) return draw(scene);
  const std::vector<glm::vec2> places = sample_places(n);
  PreparedScene moved = scene;
  Picture mean(scene.scene.camera.width, scene.scene.camera.height);
  std::vector<Counts> counts(mean.pixels.size());
  for (const glm::vec2& place : places) {
    moved.scene.camera.offset = place;
    const Picture sample = draw(moved);
    for (std::size_t k = 0; k < counts.size(); ++k) {
      mean.pixels[k] += sample.pixels[k];
      counts[k].surface += is_surface(sample.pixels[k]);
      counts[k].known += is_measured(sample.pixels[k]);
    }
  }
  for (std::size_t k = 0; k < counts.size(); ++k) {
    mean.pixels[k] *= 1 / float(places.size());
    mean.pixels[k].a = majority(counts[k], places.size());
  }
  return mean;
}

}  // namespace brdf::render
