// Estimates the light that a surface reflects from its environment to the viewer, by random directions.
//
// Directions are drawn from the light's picture and from the reflectance's own sampler (from the cosine if
// it has no sampler), and weighted by the balance heuristic (Veach and Guibas 1995): each counts f cos L
// over the sum of both densities.
#pragma once

#include "render/light/points.h"
#include "render/reference/surface_hit.h"

namespace brdf::render {

struct EnvironmentEstimate {
  glm::vec3 mean{0};
  // Variance of the mean, estimated from the variance between runs of kRun points; 0 for a single run.
  glm::vec3 variance{0};
};

// `wo` is in the surface's frame; `starts`: the starts of the pixel's point sequences. `samples` is rounded
// up to whole runs. Shadows are not computed.
EnvironmentEstimate environment_light(const PreparedScene& scene, const Item& item, const SurfaceHit& surface,
                                      const glm::vec3& wo, const std::array<double, kPointDimensions>& starts,
                                      int samples);

}  // namespace brdf::render
