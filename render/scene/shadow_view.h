// Which light of a scene casts a shadow, and how its shadow map looks at the scene. The renderer draws that
// map, the reference traces the same light. Objects cast shadows on one another, none on itself: there the
// cosine says what is dark, and the facets of a coarse mesh under a smooth normal would show as steps.
#pragma once

#include <optional>

#include "render/scene/prepared.h"

namespace brdf::render {

inline constexpr int kShadowMapSize = 2048;  // texels across

// The first directional one, where the scene has "shadow".
std::optional<std::size_t> shadow_light(const Scene& scene);

struct ShadowView {
  std::size_t light = 0;
  // To x, y in [-1, 1] round everything that is not flat (a ground lies under things, not over them) and to
  // the nearness to the light in [0, 1].
  glm::mat4 projection{1};
};

// Nothing where no light casts one.
std::optional<ShadowView> shadow_view(const PreparedScene& prepared);

}  // namespace brdf::render
