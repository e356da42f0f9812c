// Symmetric V-grooves with random facet angle and azimuth.
#pragma once

#include "micro/random.h"
#include "micro/surface.h"

namespace brdf::micro {

// How the facet angles t of the grooves are distributed; every groove takes the same share of the
// macroscopic plane.
enum class GrooveAngles {
  // Density over t proportional to exp(-t^2 / (2 sigma^2)) sin t: Oren and Nayar (SIGGRAPH 1994), eq. 7,
  // whose P
  // is a share of projected area per solid angle.
  oren_nayar,
  // tan t as in a Gaussian distribution of slopes of width alpha: D(t) cos t of Beckmann's D, which is the
  // same share.
  beckmann,
};

struct Grooves {
  GrooveAngles angles = GrooveAngles::beckmann;
  double width = 0.3;  // sigma in radians, or alpha
  int count = 1024;    // grooves in one period
};

// Grooves of width 1 side by side along x with their upper edges at z = 0, invariant along y. Groove k is
// seen in a frame turned by a uniform random azimuth: what happens in one groove never reaches another,
// because all of them lie below their common upper plane.
Surface make_grooves(const Grooves& settings, Random& random);

}  // namespace brdf::micro
