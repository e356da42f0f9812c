// The window's panels: what they show, and what is asked for on them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/compare/pictures.h"
#include "render/reference/reference.h"
#include "render/viewer/commands.h"
#include "render/viewer/editors.h"
#include "render/viewer/layout.h"

namespace brdf::render {

struct PanelInfo {
  const Pictures* pictures = nullptr;              // what is shown
  const io::SampleTable* samples = nullptr;        // as a picture shows them
  const std::vector<double>* residuals = nullptr;  // mean ln(A/measured), measured/residual_map.h
  double frame_ms = 0;
  bool moving = false;          // fewer pixels are drawn
  std::string device, message;  // message: the last thing that went wrong or was done
  bool is_error = false;
  std::optional<PixelProbe> probe;
  glm::vec2 probe_at{0};
  const std::vector<Interval>* intervals = nullptr;
  double fitting = -1;  // seconds so far; negative: no fit goes on
  bool can_fit = false;
  std::optional<double> error;         // of A at the samples, the median
  std::optional<double> error_before;  // where a slider is held: before it was
};

class Panels {
 public:
  // Between ImGui::NewFrame and ImGui::Render; the requests of the buttons that were pressed.
  std::vector<Request> draw(Session& session, const Layout& layout, const PanelInfo& info,
                            const Whereabouts& where);
  void show_help() { help_ = true; }
  // Closes what lies on top; false where there is nothing.
  bool dismiss();

 private:
  bool help_ = false;
};

// The plot of the lobes, and what the samples say; the slice and the map of residuals stand open where there
// is room.
void plot_panel(Session& session, const PanelInfo& info, bool room);
// Beside samples: f_r over the viewer's angle at the measured light nearest to the plot's, and where A is too
// dark or too bright at them.
void slice_section(Session& session, const PanelInfo& info);
void residual_section(const std::vector<double>& cells);
// Names, numbers and messages round the picture.
void picture_lines(const Session& session, const Layout& layout, const PanelInfo& info);

}  // namespace brdf::render
