// Pictures with several samples per pixel, averaged in linear light. These pictures are for viewing;
// measures and proofs compare a single sample at the pixel's centre.
#pragma once

#include <functional>

#include "render/picture/picture.h"
#include "render/scene/prepared.h"

namespace brdf::render {

inline constexpr int kMostSupersample = 16;  // across: 256 samples per pixel

// Returns n x n places in a pixel, relative to its centre, in pixels within (-1/2, 1/2). Each of n x n
// cells, each of n^2 columns and each of n^2 rows contains exactly one place, which gives edges near the
// horizontal or the vertical n^2 steps too (the canonical arrangement of Chiu, Shirley and Wang 1994,
// "Multi-jittered sampling", without its jitter). The mean of the places is the centre.
std::vector<glm::vec2> sample_places(int n);

// Returns the mean of draw(scene) with the camera's samples at each of these places. The alpha value
// (picture.h) is decided by at least half of the samples. n = 1 is draw(scene) itself.
using Draw = std::function<Picture(const PreparedScene&)>;
Picture supersampled(const PreparedScene& scene, int n, const Draw& draw);

}  // namespace brdf::render
