// Draws lines and dots of a plot into the window.
#pragma once

#include <imgui.h>

#include "render/compare/lobe_plot.h"

namespace brdf::render {

inline ImU32 in_window(const ByteColor& color) {
  return IM_COL32(color[0], color[1], color[2], 255);
}

// `place`: maps a point of the plot to the window; `dot`: the radius of a dot in pixels.
template <class Plot, class Place>
void draw_plot(const Plot& plot, float dot, const Place& place) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const LobePath& path : plot.paths) {
    for (const glm::vec2& p : path.points) list->PathLineTo(place(p));
    list->PathStroke(in_window(path.color), 0, path.width);
  }
  for (const LobePlot::Dot& d : plot.dots) {
    list->AddCircleFilled(place(d.at), dot + 1, IM_COL32(15, 15, 18, 255));
    list->AddCircleFilled(place(d.at), dot, in_window(d.color));
  }
}

}  // namespace brdf::render
