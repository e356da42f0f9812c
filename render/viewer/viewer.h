// `brdf view`: a window on a scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/compare/state.h"
#include "render/viewer/by_hand.h"

namespace brdf::render {

struct ViewerOptions {
  ViewState state;
  std::filesystem::path file;  // where it came from; empty: nowhere
  int width = 1280, height = 720;
  int gbuffer_bits = 16;
  int samples = 1024;  // of an environment's light, brought in while the view stands still
  std::uint64_t memory_limit = 0;
  std::filesystem::path state_file = "brdf-view.json";  // what saving writes and loading reads
  std::filesystem::path screenshot = "brdf-view.png";
  int frames = 0;  // quit after so many; 0: when the user does
  bool validation = false;
  float scale = 0;     // of text and panels; 0: the display's
  bool orbit = false;  // the camera turns with every frame
  Solver solver;       // none: nothing is fitted
};

struct ViewerReport {
  unsigned validation_messages = 0;
  double median_frame_ms = 0;  // from events to presented, of all frames but the first five
  int frames = 0;
};

// Returns when the window closes. Throws EnvironmentError when there
// is no display or no driver, InputError when the state cannot be drawn.
ViewerReport view(const ViewerOptions& options);

}  // namespace brdf::render
