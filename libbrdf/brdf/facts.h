// What is known of a form besides its values. A form's header
// states it; checks, integrals and reports ask for it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "brdf/vec3.h"

namespace brdf {

// A known violation of a physical property: a fact that tests assert and the search must find again.
struct Violation {
  std::string_view check;      // energy | reciprocity | non_negative | ...
  std::string_view statement;  // one line for people
  std::string_view witness;    // parameters as `--set` takes them, separated by spaces
  double theta;                // of the fixed direction, degrees
  // What the check measures there. energy: the albedo with the light fixed; reciprocity: |f(wi, wo) - f(wo,
  // wi)| over the larger of the two; non_negative: the lowest f, 1/sr.
  double value;
};
using NoViolations = std::array<Violation, 0>;

// Largest relative errors over the grid of `brdf validate --numerics`, against 50 digits.
struct Accuracy {
  struct Errors {
    double body, faint, tail;  // where f >= 1e-6, >= 1e-12, >= 1e-30 of the lobe's peak
  };
  Errors in_float, in_double;
};

// Where the derivatives jump: the integrals split there.
enum class Kink {
  none,
  azimuth,      // where the azimuths are a right angle apart, and where the polar angles are equal
  mirror_edge,  // a lobe about the mirror direction: where that leaves the other's hemisphere
  v_cavity,     // the minimum of Torrance and Sparrow's masking
  unplaced,     // somewhere, or nobody has looked: integrals by bisection
};

// A directional albedo known in closed form, of the lobe at
// full weight (or the diffuse weight at 1) and equal widths.
struct ClosedAlbedo {
  double theta_low, theta_high;                                     // degrees: where it holds
  double (*albedo)(std::span<const double> shape, double radians);  // for light at that polar angle
  std::string_view source;
};

// The microfacets that a form stands for, by its shape parameters. Slopes are of h = (p, q, 1).
struct FacetFacts {
  double far;  // in widths: beyond, the distribution holds nothing
  // P22 = D cos_h^4 for each of `count` slopes.
  void (*slopes)(std::span<const double> shape, std::size_t count, const Vec3<double>* h, double* out);
  // The masking G1 of facets with these slopes, seen from the unit vector o.
  void (*masking)(std::span<const double> shape, const Vec3<double>& o, std::size_t count,
                  const Vec3<double>* h, double* out);
};

}  // namespace brdf
