// `brdf view`: a window on a scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/compare/state.h"

namespace brdf::render {

struct ViewerOptions {
  ViewState state;
  int width = 1280, height = 720;
  int gbuffer_bits = 16;
  int samples = 1024;  // of an environment's light, brought in while the view stands still
  std::uint64_t memory_limit = 0;
  std::filesystem::path state_file = "brdf-view.json";  // what saving writes and loading reads
  std::filesystem::path screenshot = "brdf-view.png";
  int frames = 0;  // quit after so many; 0: when the user does
  bool validation = false;
};

// Returns when the window closes, with the number of validation messages. Throws EnvironmentError when there
// is no display or no driver, InputError when the state cannot be drawn.
unsigned view(const ViewerOptions& options);

}  // namespace brdf::render
