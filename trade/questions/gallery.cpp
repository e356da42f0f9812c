#include "trade/questions/gallery.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/proof/shader_proof.h"
#include "trade/measure/question.h"

namespace brdf::trade {
namespace {

using render::Picture;
using render::Renderer;

Picture drawn(Renderer& renderer) {
  renderer.draw();
  const render::Camera& camera = renderer.scene().scene.camera;
  return render::picture_from(camera.width, camera.height, renderer.read_color());
}

std::vector<timing::Timing> times_of(render::Device& device,
                                     const std::vector<std::unique_ptr<Renderer>>& renderers, int rounds) {
  std::vector<std::function<void()>> calls;
  for (const auto& renderer : renderers) calls.push_back([&r = *renderer] { r.draw(); });
  timing::Options options;
  options.rounds = rounds;
  options.least_seconds = 4e-3;
  options.neighbours = 3;
  if (render::is_software(device)) options.clock = timing::Clock::process;
  return timing::interleaved(calls, options);
}

}  // namespace

PictureError picture_error(const Picture& a, const Picture& exact, const Pixels& of) {
  PictureError out;
  std::vector<double> differences;
  double sum = 0, total = 0, squares = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (exact.at(x, y).a < 0.5f || a.at(x, y).a < 0.5f || !of(x, y)) continue;
      const auto mean = [](const glm::vec4& c) { return (double(c.r) + double(c.g) + double(c.b)) / 3; };
      const double e = mean(exact.at(x, y)), d = std::abs(mean(a.at(x, y)) - e);
      if (d > out.error.max || differences.empty()) {
        out.error.max = d;
        out.error.where = "pixel " + std::to_string(x) + ", " + std::to_string(y);
      }
      differences.push_back(d);
      sum += d;
      squares += d * d;
      total += e;
    }
  if (differences.empty()) return out;
  const auto count = double(differences.size());
  std::ranges::sort(differences);
  out.error.mean = sum / count;
  out.error.p99 = timing::quantile(differences, 0.99);
  out.image = total > 0 ? sum / total : 0;
  out.root_mean_square = std::sqrt(squares / count);
  return out;
}

std::vector<LedgerRow> measure_frames(render::Device& device, const FrameQuestion& question, int rounds) {
  std::vector<std::unique_ptr<Renderer>> renderers;
  std::vector<Picture> pictures;
  for (const Way& way : question.ways) {
    renderers.push_back(std::make_unique<Renderer>(device, render::prepare(way.scene), way.options));
    pictures.push_back(drawn(*renderers.back()));
  }
  const std::vector<timing::Timing> timings = times_of(device, renderers, rounds);
  std::vector<LedgerRow> rows;
  for (std::size_t k = 0; k < question.ways.size(); ++k) {
    const PictureError error = picture_error(pictures[k], pictures[0], question.of);
    LedgerRow row;
    row.question = question.name;
    row.choice = question.ways[k].name;
    row.exact = question.ways[0].name;
    row.unit = Unit::frame;
    set_cost(row, timings[k], 1);
    row.error = error.error;
    row.quantity = "radiance";
    row.image_error = error.image;
    row.domain = question.domain;
    char rms[64];
    std::snprintf(rms, sizeof rms, "RMS %.2e", error.root_mean_square);
    row.note = rms;
    rows.push_back(std::move(row));
  }
  for (const FrameExtreme& extreme : question.extremes) {
    Picture exact;
    for (std::size_t k = 0; k < question.ways.size(); ++k) {
      render::Scene scene = question.ways[k].scene;
      extreme.change(scene);
      renderers[k]->update(render::prepare(scene));
      const Picture picture = drawn(*renderers[k]);
      if (k == 0) exact = picture;
      rows[k].extremes.push_back({extreme.domain, picture_error(picture, exact, extreme.of).error.max});
    }
  }
  mark_dominated(rows);
  return rows;
}

}  // namespace brdf::trade
