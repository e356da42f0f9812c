// A slice through the plane of incidence: f_r over the viewer's angle, measured values as dots, materials as
// lines.
#pragma once

#include "render/compare/lobe_plot.h"

namespace brdf::render {

// In the unit square, y upwards. x: theta_o from -90 to 90 degrees; y: log10 f_r from `low` to `high`, whole
// decades that hold the dots shown, the curves' tops too. What lies below is drawn at the lower edge.
struct SlicePlot {
  std::vector<LobePath> paths;
  std::vector<LobePlot::Dot> dots;
  int low = 0, high = 1;
};
// `solo` as in lobe_plot.
SlicePlot slice_plot(const std::vector<LobeCurve>& curves, int solo, const std::vector<LobeDot>& dots);

}  // namespace brdf::render
