// Facts that are known about a form in addition to its values. The header of a form declares them; checks,
// integrals and reports use them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "brdf/vec3.h"

namespace brdf {

// A known violation of a physical property. Tests assert it, and the search for violations must find it
// again.
struct Violation {
  std::string_view check;      // energy | reciprocity | non_negative | ...
  std::string_view statement;  // one line, for readers
  std::string_view witness;    // parameters in the syntax of `--set`, separated by spaces
  double theta;                // of the fixed direction, degrees
  // The quantity that the check measures there. energy: the albedo with the light fixed. reciprocity:
  // |f(wi, wo) - f(wo, wi)| divided by the larger of the two. non_negative: the lowest f, in 1/sr.
  double value;
};
using NoViolations = std::array<Violation, 0>;

// Largest relative errors that the grid and the search of `brdf validate --numerics` found, compared with
// 50-digit arithmetic.
struct Accuracy {
  struct Errors {
    double body, faint, tail;  // for f >= 1e-6, >= 1e-12, >= 1e-30 of the lobe's peak
  };
  Errors in_float, in_double;
};

// Locations at which the derivatives are discontinuous. The integrals are split there.
enum class Kink {
  none,
  azimuth,      // azimuths a right angle apart, and equal polar angles
  mirror_edge,  // a lobe about the mirror direction, at the horizon of the other direction
  v_cavity,     // the minimum in the masking of Torrance and Sparrow
  unplaced,     // an unknown location, or not examined: integrals use bisection
};

// A directional albedo known in closed form. It applies to the lobe at full weight (or the diffuse term at
// weight 1) and for equal widths.
struct ClosedAlbedo {
  double theta_low, theta_high;                                     // range of validity, degrees
  double (*albedo)(std::span<const double> shape, double radians);  // for light at that polar angle
  std::string_view source;
};

// The numbers of one function s_nml of a matt basis (brdf/matt_basis.h).
struct MattIndex {
  int n, m, l;
};
// The lobes of a form are such a basis: polynomials of both signs, with weights of either sign. Whether f is
// negative somewhere is then a property of the weights.
struct MattBasis {
  int order;                           // the largest n, at most 5
  std::span<const MattIndex> indices;  // of the weights, in the order of their table
};

// The distribution of microfacets behind a form, as functions of the shape parameters. Slopes (p, q) belong
// to the half vector h = (p, q, 1).
struct FacetFacts {
  double far;  // in widths; the distribution is negligible beyond
  // Computes P22 = D cos_h^4 for each of `count` slopes.
  void (*slopes)(std::span<const double> shape, std::size_t count, const Vec3<double>* h, double* out);
  // Computes the masking G1 of facets with these slopes, seen from the unit vector o.
  void (*masking)(std::span<const double> shape, const Vec3<double>& o, std::size_t count,
                  const Vec3<double>* h, double* out);
};

}  // namespace brdf
