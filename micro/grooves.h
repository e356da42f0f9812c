// Symmetric V-grooves with random facet angles and azimuths.
#pragma once

#include "micro/random.h"
#include "micro/surface.h"

namespace brdf::micro {

// Distribution of the facet angles t of the grooves. Every groove occupies the same share of the
// macroscopic plane.
enum class GrooveAngles {
  // Density over t proportional to exp(-t^2 / (2 sigma^2)) sin t: Oren and Nayar (SIGGRAPH 1994), eq. 7.
  // Their P is a share of projected area per solid angle.
  oren_nayar,
  // tan t has a Gaussian distribution of slopes of width alpha. The density is D(t) cos t with Beckmann's
  // D, which is the same share.
  beckmann,
};

struct Grooves {
  GrooveAngles angles = GrooveAngles::beckmann;
  double width = 0.3;  // sigma in radians, or alpha
  int count = 1024;    // grooves in one period
};

// Generates grooves of width 1 side by side along x, with their upper edges at z = 0 and constant along y.
// Groove k has a frame of its own, rotated by a uniform random azimuth. Light in one groove never reaches
// another groove because all of them lie below their common upper plane.
Surface make_grooves(const Grooves& settings, Random& random);

}  // namespace brdf::micro
