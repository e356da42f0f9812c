// Thresholds that spread the rounding of a picture to bytes as blue noise: neighbours round differently, and
// what is left is too fine to be seen as bands.
#pragma once

#include <vector>

namespace brdf::render {

// Pixels across the square tile that repeats over a picture.
inline constexpr int kDitherTile = 32;

// A threshold in (0, 1) for every pixel of the tile, each of (k + 1/2)/kDitherTile^2 once, rows from the top.
// By void and cluster (Ulichney 1993, "The void-and-cluster method for dither array generation"), a Gaussian
// of 1.5 pixels, from this seed; the same everywhere.
std::vector<float> void_and_cluster(unsigned long long seed);

// Of the tile of seed 1 at a pixel.
float dither_threshold(int x, int y);

}  // namespace brdf::render
