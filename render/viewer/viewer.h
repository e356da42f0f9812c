// `brdf view`: a window on a scene.
#pragma once

#include <cstdint>
#include <filesystem>

#include "render/compare/state.h"
#include "render/job.h"
#include "render/viewer/by_hand.h"

namespace brdf::render {

struct ViewerOptions {
  ViewState state;
  std::filesystem::path file;  // source of the state; empty if it is not from a file
  int width = 1280, height = 720;
  int gbuffer_bits = 16;
  // Samples of an environment's light per pixel, added while the view does not move.
  int samples = kDefaultSamples;
  std::uint64_t memory_limit = 0;
  std::filesystem::path state_file = "brdf-view.json";  // the file for saving and loading the state
  std::filesystem::path screenshot = "brdf-view.png";
  // Quits after this number of frames; 0: when the user quits.
  int frames = 0;
  bool validation = false;
  float scale = 0;     // of text and panels; 0: the scale of the display
  bool orbit = false;  // the camera turns with each frame
  Solver solver;       // empty: fits are not available
};

struct ViewerReport {
  unsigned validation_messages = 0;
  // From events to presentation, over all frames except the first five.
  double median_frame_ms = 0;
  int frames = 0;
};

// Shows the window and returns when it closes. Throws EnvironmentError if there is no display or no driver,
// InputError if the state cannot be drawn.
ViewerReport view(const ViewerOptions& options);

}  // namespace brdf::render
