// Slopes and masking of explicit surfaces.
#pragma once

#include "micro/goniometer.h"

namespace brdf::micro {

// The mesh's own slope distribution, weighted by projected area, over independent surfaces.
struct Slopes {
  Estimate alpha_x, alpha_y;  // sqrt(2 <s^2>)
  // Share of the plane whose slopes lie outside the ellipse (sx/alpha_x)^2 + (sy/alpha_y)^2 = q, with the
  // widths asked for; Beckmann's distribution has exp(-q).
  std::vector<Estimate> outside;
};
// Needs a simulation of a height field.
Slopes measure_slopes(const Simulation& simulation, const std::vector<double>& q,
                      const Progress& progress = {});

// What one direction w sees of the surface. Points are spread evenly over the macroscopic plane.
struct Masking {
  Angle theta;              // in the plane of the tangent
  Estimate visible_points;  // share of the points facing w that see it: Smith's 1/(1 + Lambda) if heights and
                            // slopes had nothing to do with one another
  Estimate visible_towards, visible_away;  // the same for facets tilted towards w, and away from it
  Estimate projected_area;                 // area seen along w per macroscopic area: cos theta on any surface
  Estimate facing_area;  // area facing w, projected along it: cos theta (1 + Lambda), by the slopes alone
};
std::vector<Masking> measure_masking(const Simulation& simulation, const std::vector<Angle>& thetas,
                                     const Progress& progress = {});

// Smith's Lambda of a Beckmann surface of width alpha along the direction's azimuth (Walter et al. 2007,
// from Smith 1967): (exp(-a^2)/(a sqrt(pi)) - erfc(a))/2 with a = cot(theta)/alpha. Theta in (0, pi/2).
double smith_lambda(double alpha, Angle theta);

}  // namespace brdf::micro
