// The geometry of a pair of directions in the local frame, with the only guard against grazing angles in
// the library.
#pragma once

#include "brdf/math.h"
#include "brdf/vec3.h"

namespace brdf {

// Smaller cosines are replaced by this value. It is too small to be visible, and large enough to keep the
// denominators of all forms within the range of float (double).
template <class T>
inline constexpr double kMinCosine = std::is_same_v<base_scalar_t<T>, float> ? 1e-6 : 1e-12;

template <class T>
struct Geometry {
  Vec3<T> wi, wo;  // as given, with z raised to at least the smallest cosine
  Vec3<T> h;       // wi + wo: not normalised, because |h|^2 keeps the accuracy of all half-vector terms
  Vec3<T> h_rest;  // rounding error of h: wi + wo = h + h_rest exactly
  T h2;            // |h|^2
  T cos_i, cos_o;  // n.wi, n.wo, raised
  T cos_d;         // wi.h/|h| = |h|/2 (a dot product would lose accuracy and reciprocity near grazing)
  T lowest;        // the smaller cosine as given, for the horizon test
};

// Computes the geometry of the unit vectors wi (to the light) and wo (to the viewer), n = +z. Any input
// gives finite members. Exchanging the directions gives bit-identical h, h2, cos_d and lowest. Only
// accuracy tests pass `min_cosine`: they evaluate the guard of another scalar in 50 digits.
template <class T>
Geometry<T> geometry(const Vec3<T>& wi, const Vec3<T>& wo, double min_cosine = kMinCosine<T>) {
  Geometry<T> g;
  g.wi = wi;
  g.wo = wo;
  g.lowest = smaller(wi.z, wo.z);
  g.cos_i = g.wi.z = at_least(wi.z, T(min_cosine));
  g.cos_o = g.wo.z = at_least(wo.z, T(min_cosine));
  g.h = g.wi + g.wo;
  g.h_rest = {sum_rest(g.wi.x, g.wo.x, g.h.x), sum_rest(g.wi.y, g.wo.y, g.h.y),
              sum_rest(g.wi.z, g.wo.z, g.h.z)};
  g.h2 = dot(g.h, g.h);
  g.cos_d = T(0.5) * math::sqrt(g.h2);
  return g;
}

// Returns s = x_i x_o + y_i y_o, which is the cosine of the azimuth difference times both sines. If both
// directions are near grazing and their azimuths differ by a quarter turn, the products cancel, and s is
// later divided by cosines that are equally small. (x_o, y_o) is then nearly (x_i, y_i) rotated by that
// quarter turn, which contributes nothing to s. The function therefore multiplies the small differences
// instead.
template <class T>
T tangential_product(const Geometry<T>& g) {
  const T side = select(g.wi.x * g.wo.y < g.wi.y * g.wo.x, T(-1), T(1));
  const T xi = side * g.wi.x, yi = side * g.wi.y, xo = side * g.wo.x, yo = side * g.wo.y;
  return T(0.5) * ((g.wi.x + yo) * (g.wo.x + yi) + (g.wi.y - xo) * (g.wo.y - xi));
}

// Returns the direction as seen from a frame with its tangent rotated by the angle with this cosine and sine.
template <class T>
Vec3<T> turn(const Vec3<T>& w, const T& cos_phi, const T& sin_phi) {
  return {w.x * cos_phi + w.y * sin_phi, w.y * cos_phi - w.x * sin_phi, w.z};
}

}  // namespace brdf
