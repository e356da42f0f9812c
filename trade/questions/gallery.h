// Compares frames of the renderer: pictures once, times in turn.
#pragma once

#include <functional>
#include <string>

#include "render/gpu/renderer.h"
#include "trade/ledger/ledger.h"

namespace brdf::trade {

// One method of drawing a frame.
struct Way {
  std::string name;
  render::Scene scene;
  render::RendererOptions options;
};

using Pixels = std::function<bool(int x, int y)>;  // the pixels that count

// Measures the same methods on a rarer kind of scene.
struct FrameExtreme {
  std::string domain;
  std::function<void(render::Scene&)> change = [](render::Scene&) {};
  Pixels of = [](int, int) { return true; };
};

struct FrameQuestion {
  std::string name, domain;
  std::vector<Way> ways;  // the first is the exact one
  Pixels of = [](int, int) { return true; };
  std::vector<FrameExtreme> extremes;
};

// Differences of luminance over the surface pixels of both pictures.
struct PictureError {
  Error error;
  double image = 0, root_mean_square = 0;
};
PictureError picture_error(const render::Picture& picture, const render::Picture& exact, const Pixels& of);

// Measures the frames. With a software driver, the cost is the processor time of all its threads.
std::vector<LedgerRow> measure_frames(render::Device& device, const FrameQuestion& question, int rounds = 21);

}  // namespace brdf::trade
