// Materials that show a factor: a picture needs a whole BRDF.
#pragma once

#include "trade/approximations/fresnel.h"
#include "trade/approximations/lobes.h"
#include "trade/approximations/masking.h"
#include "trade/measure/domain.h"

namespace brdf::trade {

// kd/pi + D V F with GGX's D. V is a function of directions, F of the cosine and the index (or f0).
template <class V, class F>
struct ball_material {
  V v;
  F f;
  FresnelRow<double> index;
  double kd = 0.3, alpha = 0.3;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const Roughness<T> a{T(alpha), T(alpha)};
    const FresnelRow<T> fresnel{at_most(g.cos_d, T(1)), T(index.n), T(index.k), T(index.f0), T(index.dip)};
    return T(kd / kPi) + quotient(d_ggx(a, g), v(a, g)) * f(fresnel);
  }
};

// A kernel at one width.
template <class K>
struct at_width {
  K kernel;
  double width;
  template <class T>
  T operator()(DirectionRow<T> x) const {
    x.width = T(width);
    return kernel(x);
  }
};

// kd/pi and a normalised cosine lobe, for a kernel over directions and exponent.
template <class Lobe>
struct lobe_material {
  Lobe lobe;
  double exponent;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    return T(0.3 / kPi) + T(0.5 * (exponent + 2) / (2 * kPi)) * at_width<Lobe>{lobe, exponent}(x);
  }
};
// Converts a function of (c, n), with c the mirror cosine, to such a kernel.
template <class Power>
struct mirror_power {
  Power power;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    return power(CosineRow<T>{at_most(at_least(mirror_cosine(x), T(0)), T(1)), x.width});
  }
};

// kd/pi + D V F with D given as a kernel, Smith's V and Schlick's F of glass.
template <class D>
struct distribution_material {
  D d;
  double alpha;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const Fraction<T> v = v_smith_ggx(Roughness<T>{T(alpha), T(alpha)}, g);
    return T(0.3 / kPi) + at_width<D>{d, alpha}(x) * (v.num / v.den) * (T(0.04) + T(0.96) * schlick(g));
  }
};

inline constexpr FresnelRow<double> kGlass{.cosine = 0, .n = 1.5, .f0 = 0.04};

template <class V, class F>
Kernel on_ball(V v, F f, const FresnelRow<double>& index = kGlass, double kd = 0.3) {
  return untimed_kernel(ball_material<V, F>{v, f, index, kd});
}

// Returns a domain of directions and a width.
inline Domain directions(Axis width, double most_theta, double least_theta = 0) {
  return direction_domain(least_theta, most_theta, {std::move(width)});
}
// Returns a domain of a cosine, and of alpha or the exponent.
inline Domain cosines(Axis cosine, Axis width) {
  return make_domain({std::move(cosine), std::move(width)}, [](std::span<const double> at) {
    return CosineRow<double>{at[0], at[1]};
  });
}

}  // namespace brdf::trade
