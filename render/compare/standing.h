// The picture of a view that stands still: drawn through one place of each pixel after the other and added up
// on the device, so that edges become smooth and an environment's light settles, in place.
#pragma once

#include "render/gpu/renderer.h"
#include "render/gpu/running_mean.h"
#include "render/picture/picture.h"

namespace brdf::render {

class Standing {
 public:
  // Draws with this renderer, which outlives this.
  Standing(Device& device, Renderer& renderer);
  // The view has moved.
  void reset() { mean_.reset(); }
  int pictures() const { return mean_.count(); }
  // So many pictures make whole rounds through `across` x `across` places and bring at least `samples` of an
  // environment, `run` each.
  static int wanted(int across, int samples, int run = kRun);

  // The scene through the next place, with the environment's next run, of as many samples as the runs before.
  void draw_next(const PreparedScene& scene, int across, Timestamps* times, int run = kRun);
  Image& shown() { return shown_; }
  const Image& shown() const { return shown_; }
  // The root mean square of the surface's standard errors over its mean; after at least two pictures.
  double noise();

 private:
  Device* device_;
  Renderer* renderer_;
  RunningMean mean_;
  Image shown_;
};

// The root mean square of the surface's standard errors (RGBA, as Renderer::read_standard_error) over its
// mean.
double noise_of(const std::vector<float>& errors, const Picture& picture);

}  // namespace brdf::render
