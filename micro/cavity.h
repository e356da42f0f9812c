// The cavity integral that the Oren-Nayar form approximates.
#pragma once

#include "micro/march.h"

namespace brdf::micro {

// Returns the single-reflection f_r (1/sr) of V-grooves with Lambertian facets of albedo 1 and the angles
// of GrooveAngles::oren_nayar. This is the mean over facet angle and azimuth of
//   (wi.a)+ (wo.a)+ / (pi cos t cos_i cos_o)
// times the share of the facet that is both illuminated and visible,
// min(1, 2 cos_i cos t/(wi.a), 2 cos_o cos t/(wo.a)) (Oren and Nayar 1994, eqs. 11-14). Midpoint rule with
// a relative error below 1e-3 for polar angles up to 80 degrees.
double groove_single_reflection(double sigma, const Vec& wi, const Vec& wo);

}  // namespace brdf::micro
