// Accumulates the picture of a view that does not move. Each frame is drawn through another place of the
// pixels and added up on the device, which smooths edges and reduces the noise of an environment's light.
#pragma once

#include "render/gpu/renderer.h"
#include "render/gpu/running_mean.h"
#include "render/picture/picture.h"

namespace brdf::render {

class Standing {
 public:
  // Draws with this renderer, which must outlive this object.
  Standing(Device& device, Renderer& renderer);
  // Starts anew because the view has moved.
  void reset() { mean_.reset(); }
  int pictures() const { return mean_.count(); }
  // Returns the number of pictures that complete whole rounds through `across` x `across` places and
  // contain at least `samples` samples of an environment, `run` in each picture.
  static int wanted(int across, int samples, int run = kRun);

  // Draws the scene through the next place, with the environment's next run. `run` must be the same for all
  // pictures since reset().
  void draw_next(const PreparedScene& scene, int across, Timestamps* times, int run = kRun);
  Image& shown() { return shown_; }
  const Image& shown() const { return shown_; }
  // Returns the root mean square of the surface's standard errors over the surface's mean. Requires at
  // least two pictures.
  double noise();

 private:
  Device* device_;
  Renderer* renderer_;
  RunningMean mean_;
  Image shown_;
};

// Returns the root mean square of the surface's standard errors (RGBA, as from
// Renderer::read_standard_error) over the mean of the surface.
double noise_of(const std::vector<float>& errors, const Picture& picture);

}  // namespace brdf::render
