// Where the window's parts lie: panels along its edges, the picture in the rest.
#pragma once

#include <vulkan/vulkan.h>

namespace brdf::render {

struct Area {
  float x = 0, y = 0, width = 0, height = 0;
};

struct Layout {
  float scale = 1;
  Area panel, plot, head, status, picture;  // of no size where they are not there; in pixels
  bool plot_in_panel = false;               // too narrow a window for a column of its own
};

// `panels`: whether they are shown; `plot`: whether the lobes are.
Layout layout_of(VkExtent2D window, float scale, bool panels, bool plot);
// In whole pixels, at least one.
VkRect2D pixels_of(const Area& area);

}  // namespace brdf::render
