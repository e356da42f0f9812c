// The window's panels: their content and the requests made on them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/compare/pictures.h"
#include "render/reference/reference.h"
#include "render/viewer/commands.h"
#include "render/viewer/editors.h"
#include "render/viewer/layout.h"
#include "render/viewer/shown.h"

namespace brdf::render {

struct PanelInfo {
  const Pictures* pictures = nullptr;              // the pictures that are shown
  const io::SampleTable* samples = nullptr;        // in the colours of a picture
  const std::vector<double>* residuals = nullptr;  // mean ln(A/measured), measured/residual_map.h
  double frame_ms = 0;
  bool coarse = false;          // fewer pixels are drawn
  std::string device, message;  // message: the last error or action
  bool is_error = false;
  std::optional<Shown::Probe> probe;
  glm::vec2 probe_at{0};
  const std::vector<Interval>* intervals = nullptr;
  double fitting = -1;  // seconds so far; negative: no fit is running
  bool can_fit = false;
  std::optional<double> error;         // of A at the samples, the median
  std::optional<double> error_before;  // if a slider is held: the error before
};

class Panels {
 public:
  // Call between ImGui::NewFrame and ImGui::Render. Returns the requests of the buttons that were pressed.
  std::vector<Request> draw(Session& session, const Layout& layout, const PanelInfo& info,
                            const Whereabouts& where);
  void show_help() { help_ = true; }
  // Closes the topmost overlay; returns false if there is no overlay.
  bool dismiss();

 private:
  bool help_ = false;
};

// Draws the plot of the lobes, and the sections on the samples. The slice and the map of residuals are open
// at first if `room` is set.
void plot_panel(Session& session, const PanelInfo& info, bool room);
// The sections on samples: f_r over the viewing angle at the measured light nearest to the plot's light,
// and the map of samples for which A is too dark or too bright.
void slice_section(Session& session, const PanelInfo& info);
void residual_section(const std::vector<double>& cells);
// Returns the relative difference at the ends of the map's colour scale: 1, 2 or 5 times a power of ten, at
// least 0.01 and at most 0.5, so that at most one cell of twenty exceeds it if that is possible.
double residual_range(const std::vector<double>& cells);
// Returns the probe as lines of text: place, angles, and f_r of A and, if B is shown, of B.
std::vector<std::string> probe_lines(const Shown::Probe& probe);
// Draws names, numbers and messages round the picture.
void picture_lines(const Session& session, const Layout& layout, const PanelInfo& info);

}  // namespace brdf::render
