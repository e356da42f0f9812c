// The layout of the window: panels along its edges, the picture in the rest.
#pragma once

#include <vulkan/vulkan.h>

namespace brdf::render {

struct Area {
  float x = 0, y = 0, width = 0, height = 0;
};

struct Layout {
  float scale = 1;
  Area panel, plot, head, status, picture;  // in pixels; of size 0 if the part is absent
  bool plot_in_panel = false;               // the window is too narrow for a separate column
};

// `panels`: whether the panels are shown; `plot`: whether the lobes are shown.
Layout layout_of(VkExtent2D window, float scale, bool panels, bool plot);
// Returns the area in whole pixels, at least one in each direction.
VkRect2D pixels_of(const Area& area);

}  // namespace brdf::render
