// Gaussian random height fields of given slope.
#pragma once

#include "micro/random.h"
#include "micro/surface.h"

namespace brdf::micro {

struct HeightField {
  // Widths of the slope distribution exp(-(sx/alpha_x)^2 - (sy/alpha_y)^2) / (pi alpha_x alpha_y): twice the
  // variance of the slope is alpha^2 (Beckmann's distribution).
  double alpha_x = 0.3, alpha_y = 0.3;
  // Cells along each side of the period; even.
  int size = 512;
  // Distance, in cells, at which the heights' Gaussian autocorrelation exp(-r^2/L^2) has fallen to 1/e.
  double correlation_length = 8;
};

// A realisation: Gaussian heights by spectral synthesis on the periodic grid. The amplitude makes the
// variance of the *mesh's facet slopes* over the ensemble exactly alpha^2/2 (the mesh is flatter than the
// continuous surface whose vertices it takes). Anisotropy is an affine stretch: alpha_y/alpha_x is the ratio
// of the cell's sides.
Surface make_height_field(const HeightField& settings, Random& random);

}  // namespace brdf::micro
