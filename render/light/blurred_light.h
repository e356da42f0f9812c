// The light of an environment, averaged over solid angles of several sizes. With it a picture without noise
// needs few directions: each direction stands for all directions near it.
#pragma once

#include <vector>

#include "render/light/light_map.h"

namespace brdf::render {

// Height of the finest level, in texels; a level is twice as wide as high, and each further level has half
// the height, down to 1.
inline constexpr int kBlurredHeight = 64;
inline constexpr int kBlurredLevels = 7;

// Position of a level in the picture of all levels. The levels lie below one another. Each level has a border
// of one texel that repeats its neighbours across the edge, so that the picture can be sampled linearly.
constexpr int blurred_row(int level) {
  return 2 * kBlurredHeight - (2 * kBlurredHeight >> level) + 2 * level;
}
inline constexpr int kBlurredPictureWidth = 2 * kBlurredHeight + 2,
                     kBlurredPictureHeight = blurred_row(kBlurredLevels);

// Returns the picture of all levels, row by row from the top: radiance (x, y, z) averaged over the texel's
// solid angle. The mean over the sphere is the same in each level.
std::vector<glm::vec4> blurred_light(const LightMap& light);

}  // namespace brdf::render
