// Pictures of several samples a pixel, averaged in linear light. Measures and proofs compare one sample, the
// pixel's centre; these are for looking at.
#pragma once

#include <functional>

#include "render/picture/picture.h"
#include "render/scene/prepared.h"

namespace brdf::render {

inline constexpr int kMostSupersample = 16;  // across: 256 samples a pixel

// n x n places in a pixel, from its centre, in pixels within (-1/2, 1/2): one in each of n x n cells, in each
// of n^2 columns and in each of n^2 rows, so that an edge near the horizontal or the vertical has n^2 steps
// too (the canonical arrangement of Chiu, Shirley and Wang 1994, "Multi-jittered sampling", without its
// jitter). Their mean is the centre.
std::vector<glm::vec2> sample_places(int n);

// The mean of draw(scene) with the camera's samples at each of these places. A (picture.h) is what half or
// more of the samples say. n = 1 is draw(scene) itself.
using Draw = std::function<Picture(const PreparedScene&)>;
Picture supersampled(const PreparedScene& scene, int n, const Draw& draw);

}  // namespace brdf::render
