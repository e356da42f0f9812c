// A slice through the plane of incidence: f_r over the viewing angle, measured values as dots, materials as
// lines.
#pragma once

#include "render/compare/lobe_plot.h"

namespace brdf::render {

// A slice in the unit square, y upwards. x: theta_o from -90 to 90 degrees; y: log10 f_r from `low` to
// `high`. These are whole decades that contain the dots shown and the peaks of the curves. Values below
// `low` are drawn at the lower edge.
struct SlicePlot {
  std::vector<LobePath> paths;
  std::vector<LobePlot::Dot> dots;
  int low = 0, high = 1;
};
// Returns the slice. `solo` has the same meaning as in lobe_plot.
SlicePlot slice_plot(const std::vector<LobeCurve>& curves, int solo, const std::vector<LobeDot>& dots);

}  // namespace brdf::render
