// Slopes and masking of explicit surfaces.
#pragma once

#include "micro/goniometer.h"

namespace brdf::micro {

// The slope distribution of the mesh, weighted by projected area, over independent surfaces.
struct Slopes {
  Estimate alpha_x, alpha_y;  // sqrt(2 <s^2>)
  // Share of the plane with slopes outside the ellipse (sx/alpha_x)^2 + (sy/alpha_y)^2 = q, for the
  // requested widths. Beckmann's distribution has exp(-q).
  std::vector<Estimate> outside;
};
// Measures the slopes. Requires a simulation of a height field.
Slopes measure_slopes(const Simulation& simulation, const std::vector<double>& q,
                      const Progress& progress = {});

// Visibility of the surface from one direction w. Sample points are spread evenly over the macroscopic plane.
struct Masking {
  Angle theta;  // in the plane of the tangent
  // Share of the points facing w that are visible from w: Smith's 1/(1 + Lambda) if heights and slopes were
  // independent.
  Estimate visible_points;
  Estimate visible_towards, visible_away;  // the same for facets tilted towards w, and away from it
  Estimate projected_area;  // area visible along w per macroscopic area: cos theta on any surface
  // Area facing w, projected along w: cos theta (1 + Lambda). Depends on the slopes alone.
  Estimate facing_area;
};
std::vector<Masking> measure_masking(const Simulation& simulation, const std::vector<Angle>& thetas,
                                     const Progress& progress = {});

// Returns Smith's Lambda of a Beckmann surface with width alpha along the azimuth of the direction (Walter
// et al. 2007, from Smith 1967): (exp(-a^2)/(a sqrt(pi)) - erfc(a))/2 with a = cot(theta)/alpha. theta must
// be in (0, pi/2).
double smith_lambda(double alpha, Angle theta);

}  // namespace brdf::micro
