// Thresholds that distribute the rounding errors of a picture's bytes as blue noise. Neighbouring pixels
// round differently, and the remaining pattern is too fine to appear as bands.
#pragma once

#include <vector>

namespace brdf::render {

// Pixels across the square tile that repeats over a picture.
inline constexpr int kDitherTile = 32;

// Returns a threshold in (0, 1) for each pixel of the tile, rows from the top; each of the values (k +
// 1/2)/kDitherTile^2 occurs once. The method is void and cluster (Ulichney 1993, "The void-and-cluster
// method for dither array generation") with a Gaussian of 1.5 pixels. The result depends only on the seed,
// on all machines.
std::vector<float> void_and_cluster(unsigned long long seed);

// Returns the threshold of the tile of seed 1 at a pixel.
float dither_threshold(int x, int y);

}  // namespace brdf::render
