// Encloses elementary functions of one double: series with their remainders, in outward rounded arithmetic.
//
// Nothing here relies on a C library except for sqrt, which IEEE 754 rounds correctly.
#pragma once

namespace brdf::prove {

struct Bounds {
  double lo, hi;
};

// Each function encloses its value at x. The remarks give the permitted arguments.
Bounds exp_at(double x);    // -745 <= x <= 709
Bounds log_at(double x);    // x > 0 and normal
Bounds log1p_at(double x);  // x > -1
Bounds erfcx_at(double x);  // exp(x^2) erfc(x), 0 <= x <= 11
// Encloses the angle of the point (cosine, sine), 0 to pi/2. Both are >= 0 and not both 0.
Bounds angle_at(double sine, double cosine);
Bounds sin_at(double x);  // 0 <= x <= 1.6
Bounds cos_at(double x);  // 0 <= x <= 1.6

// pi lies between these neighbours.
inline constexpr Bounds kPiBounds{3.14159265358979311600, 3.14159265358979356009};

}  // namespace brdf::prove
