// Gaussian random height fields with given slopes.
#pragma once

#include "micro/random.h"
#include "micro/surface.h"

namespace brdf::micro {

struct HeightField {
  // Widths of the slope distribution exp(-(sx/alpha_x)^2 - (sy/alpha_y)^2) / (pi alpha_x alpha_y). Twice
  // the variance of the slope is alpha^2 (Beckmann's distribution).
  double alpha_x = 0.3, alpha_y = 0.3;
  // Number of cells along each side of the period. Must be even.
  int size = 512;
  // Distance, in cells, at which the Gaussian autocorrelation of the heights, exp(-r^2/L^2), has fallen to
  // 1/e.
  double correlation_length = 8;
};

// Generates a realisation: Gaussian heights by spectral synthesis on the periodic grid. The amplitude is
// chosen to make the variance of the *mesh's facet slopes* over the ensemble exactly alpha^2/2. (The mesh
// is flatter than the continuous surface through its vertices.) Anisotropy is an affine stretch:
// alpha_y/alpha_x is the ratio of the sides of a cell.
Surface make_height_field(const HeightField& settings, Random& random);

}  // namespace brdf::micro
