#include "render/compare/slice_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/compare/lobe_colours.h"

namespace brdf::render {
namespace {

constexpr int kMostDecades = 5;
constexpr float kSmallest = 1e-12f;

struct Values {
  float least = std::numeric_limits<float>::infinity(), most = kSmallest;
};

// Chooses the decades that contain these values.
void choose_decades(SlicePlot& plot, const Values& dots, float highest) {
  plot.high = int(std::ceil(std::log10(std::max(dots.most, highest))));
  const float low = std::isfinite(dots.least) ? dots.least : highest;
  plot.low = std::clamp(int(std::floor(std::log10(std::max(low, kSmallest)))), plot.high - kMostDecades,
                        plot.high - 1);
}

glm::vec2 at(const SlicePlot& plot, float theta, float value) {
  const float height =
      (std::log10(std::max(value, kSmallest)) - float(plot.low)) / float(plot.high - plot.low);
  return {(theta + 90) / 180, std::clamp(height, 0.0f, 1.0f)};
}

}  // namespace

SlicePlot slice_plot(const std::vector<LobeCurve>& curves, int solo, const std::vector<LobeDot>& dots) {
  SlicePlot plot;
  Values measured;
  float highest = kSmallest;
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (is_shown(solo, c))
      for (const float f : curves[c].values) highest = std::max(highest, f);
  std::vector<LobeDot> shown;
  for (const LobeDot& dot : dots)
    if (is_shown(solo, dot, curves)) shown.push_back(dot);
  for (const LobeDot& dot : shown) {
    measured.most = std::max(measured.most, dot.value);
    if (dot.value > 0) measured.least = std::min(measured.least, dot.value);
  }
  choose_decades(plot, measured, highest);
  for (int decade = plot.low; decade <= plot.high; ++decade) {
    const float y = float(decade - plot.low) / float(plot.high - plot.low);
    plot.paths.push_back({{{0, y}, {1, y}}, kLobeGrid, 1});
  }
  for (int angle = -90; angle <= 90; angle += 30) {
    const float x = float(angle + 90) / 180;
    plot.paths.push_back({{{x, 0}, {x, 1}}, kLobeGrid, 1});
  }
  for (std::size_t c = 0; c < curves.size(); ++c) {
    if (!is_shown(solo, c)) continue;
    LobePath path{{}, curves[c].color, 2};
    for (int k = 0; k < kLobePoints; ++k)
      path.points.push_back(at(plot, float(k - kSteepest), curves[c].values[std::size_t(k)]));
    plot.paths.push_back(std::move(path));
  }
  for (const LobeDot& dot : shown) plot.dots.push_back({at(plot, float(dot.theta_o), dot.value), dot.color});
  return plot;
}

}  // namespace brdf::render
