// Determines the light of a scene that casts a shadow, and the projection of its shadow map. The renderer
// draws this map, the reference traces rays to the same light. Objects cast shadows on other objects, never
// on themselves: the cosine already darkens the side that faces away from the light, and the facets of a
// coarse mesh under a smooth normal would appear as steps.
#pragma once

#include <optional>

#include "render/scene/prepared.h"

namespace brdf::render {

inline constexpr int kShadowMapSize = 2048;  // texels across

// Returns the first directional light if the scene has "shadow".
std::optional<std::size_t> shadow_light(const Scene& scene);

struct ShadowView {
  std::size_t light = 0;
  // Maps to x, y in [-1, 1] round all objects that are not flat (a ground lies below objects and casts no
  // shadow on them) and to the nearness to the light in [0, 1].
  glm::mat4 projection{1};
};

// Returns std::nullopt if no light casts a shadow.
std::optional<ShadowView> shadow_view(const PreparedScene& prepared);

}  // namespace brdf::render
