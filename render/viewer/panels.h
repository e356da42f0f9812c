// The viewer's user interface: panels that change the view state.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "render/compare/pictures.h"
#include "render/compare/state.h"
#include "render/reference/reference.h"

namespace brdf::render {

struct PanelInfo {
  const Pictures* pictures = nullptr;
  float frame_rate = 0;
  std::string device, message;  // message: the last thing that went wrong or was done
  std::optional<PixelProbe> probe;
};

// What the user asked for beyond changes of the state.
struct PanelRequests {
  bool reset_camera = false, fit_camera = false, screenshot = false, save = false, load = false;
  std::string open;  // a file's name
};

class Panels {
 public:
  // Between ImGui::NewFrame and ImGui::Render.
  PanelRequests draw(ViewState& state, const PanelInfo& info);
  // The prompt for a file's name opens with the next frame.
  void ask_for_file() { open_prompt_ = true; }
  // The prompt is to open with the next frame: what is typed until then is not for the viewer's keys.
  bool asking() const { return open_prompt_; }
  // Enter was pressed while text has the keyboard: Dear ImGui polls, and would miss a short tap.
  void accept() { accept_ = true; }

 private:
  void main_panel(ViewState& state, const PanelInfo& info, PanelRequests& requests);
  void file_prompt(PanelRequests& requests);
  void plot(ViewState& state, const io::SampleTable* samples);

  bool open_prompt_ = false, accept_ = false;
  std::string file_name_;
};

}  // namespace brdf::render
