// The pair of directions in the local frame, with the one grazing guard of the library.
#pragma once

#include "brdf/math.h"
#include "brdf/vec3.h"

namespace brdf {

// Cosines below this are evaluated here. Small enough to be out of sight, large enough that no denominator of
// any form leaves float's (double's) range.
template <class T>
inline constexpr double kMinCosine = std::is_same_v<base_scalar_t<T>, float> ? 1e-6 : 1e-12;

template <class T>
struct Geometry {
  Vec3<T> wi, wo;  // as given, z raised to at least the smallest cosine
  Vec3<T> h;       // wi + wo: not normalised, because through |h|^2 every half-vector term keeps its accuracy
  Vec3<T> h_rest;  // what rounding took from h: wi + wo = h + h_rest exactly
  T h2;            // |h|^2
  T cos_i, cos_o;  // n.wi, n.wo, raised
  T cos_d;         // wi.h/|h| = |h|/2 (a dot product would lose it near grazing, and reciprocity with it)
  T lowest;        // the smaller cosine as given: the horizon test
};

// Unit vectors wi (to the light) and wo (to the viewer), n = +z. Total: any input gives finite members, and
// swapping the directions gives the same h, h2, cos_d and lowest bit for bit. `min_cosine` is overridden only
// by accuracy tests, which evaluate another scalar's guard in 50 digits.
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

// s = x_i x_o + y_i y_o: the cosine of the azimuth between times both sines. Where both directions graze a
// quarter turn apart the products cancel, and s is divided by cosines as small. There (x_o, y_o) is nearly
// (x_i, y_i) turned to that side, of which s holds nothing: the rests are multiplied instead.
template <class T>
T tangential_product(const Geometry<T>& g) {
  const T side = select(g.wi.x * g.wo.y < g.wi.y * g.wo.x, T(-1), T(1));
  const T xi = side * g.wi.x, yi = side * g.wi.y, xo = side * g.wo.x, yo = side * g.wo.y;
  return T(0.5) * ((g.wi.x + yo) * (g.wo.x + yi) + (g.wi.y - xo) * (g.wo.y - xi));
}

// The directions as seen from a frame whose tangent is turned by the angle with this cosine and sine.
template <class T>
Vec3<T> turn(const Vec3<T>& w, const T& cos_phi, const T& sin_phi) {
  return {w.x * cos_phi + w.y * sin_phi, w.y * cos_phi - w.x * sin_phi, w.z};
}

}  // namespace brdf
