#include "render/viewer/layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace brdf::render {
namespace {

constexpr float kPanel = 320, kPlot = 330, kLine = 26;  // pixels at scale 1
constexpr float kMostShare = 0.45f;                     // of the window, for the panel
constexpr float kLeastPicture = 400;                    // next to both columns, at scale 1

}  // namespace

Layout layout_of(VkExtent2D window, float scale, bool panels, bool plot) {
  const float width = float(window.width), height = float(window.height);
  Layout out;
  out.scale = scale;
  out.picture = {0, 0, width, height};
  if (!panels) return out;
  const float panel = std::floor(std::min(kPanel * scale, kMostShare * width));
  const float line = std::min(std::floor(kLine * scale), height / 4);
  out.panel = {0, 0, panel, height};
  out.plot_in_panel = plot && width - panel - kPlot * scale < kLeastPicture * scale;
  const float right = plot && !out.plot_in_panel ? kPlot * scale : 0;
  const float rest = width - panel - right;
  if (right > 0) out.plot = {width - right, 0, right, height};
  out.head = {panel, 0, rest, line};
  out.status = {panel, height - line, rest, line};
  out.picture = {panel, line, rest, height - 2 * line};
  return out;
}

VkRect2D pixels_of(const Area& area) {
  return {{std::int32_t(area.x), std::int32_t(area.y)},
          {std::uint32_t(std::max(area.width, 1.0f)), std::uint32_t(std::max(area.height, 1.0f))}};
}

}  // namespace brdf::render
