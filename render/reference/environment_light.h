// What a surface sends to the viewer of the light all around it, by random directions.
//
// Directions are drawn from the light's picture and from the reflectance's own sampler (the cosine where it
// has none), and weighted by the balance heuristic (Veach and Guibas 1995): each counts f cos L over the sum
// of both densities.
#pragma once

#include "render/light/points.h"
#include "render/reference/surface_hit.h"

namespace brdf::render {

struct EnvironmentEstimate {
  glm::vec3 mean{0};
  glm::vec3 variance{
      0};  // of the mean, told from the scatter between runs of kRun points; 0 for a single run
};

// `wo` in the surface's frame; `starts`: the pixel's points. `samples` is rounded up to whole runs. No
// shadows.
EnvironmentEstimate environment_light(const PreparedScene& scene, const Item& item, const SurfaceHit& surface,
                                      const glm::vec3& wo, const std::array<double, kPointDimensions>& starts,
                                      int samples);

}  // namespace brdf::render
