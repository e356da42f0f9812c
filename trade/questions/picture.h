// The material that factors are shown in: a picture needs a whole BRDF. Rows as directions.
#pragma once

#include "trade/approximations/fresnel.h"
#include "trade/approximations/masking.h"

namespace brdf::trade {

// kd/pi + D V F with GGX's D; V from directions, F from the cosine and the index (or f0).
template <class V, class F>
struct ball_material {
  double kd = 0.3, alpha = 0.3;
  V v;
  F f;
  Row<double> index{};  // columns 1.. of the Fresnel row
  template <class T>
  T operator()(const Row<T>& x) const {
    const Geometry<T> g = geometry_of(x);
    const Roughness<T> a{T(alpha), T(alpha)};
    Row<T> fresnel{};
    for (std::size_t k = 1; k < 5; ++k) fresnel[k] = T(index[k]);
    fresnel[0] = at_most(g.cos_d, T(1));
    return T(kd / kPi) + quotient(d_ggx(a, g), v(a, g)) * f(fresnel);
  }
};

// A kernel whose column 6 is a width, at one width.
template <class K>
struct at_width {
  K kernel;
  double width;
  template <class T>
  T operator()(Row<T> x) const {
    x[6] = T(width);
    return kernel(x);
  }
};

// kd/pi and a normalised cosine lobe: of a kernel over directions and exponent, ...
template <class Lobe>
struct lobe_material {
  Lobe lobe;
  double exponent;
  template <class T>
  T operator()(Row<T> x) const {
    x[6] = T(exponent);
    return T(0.3 / kPi) + T(0.5 * (exponent + 2) / (2 * kPi)) * lobe(x);
  }
};
// ... or of a function of (c, n), given the mirror cosine.
template <class Power>
struct mirror_power {
  Power power;
  template <class T>
  T operator()(const Row<T>& x) const {
    const T c = at_most(at_least(x[2] * x[5] - x[0] * x[3] - x[1] * x[4], T(0)), T(1));
    return power(Row<T>{c, x[6]});
  }
};

// kd/pi + D V F with D given as a kernel, Smith's V and Schlick's F of glass.
template <class D>
struct distribution_material {
  D d;
  double alpha;
  template <class T>
  T operator()(Row<T> x) const {
    x[6] = T(alpha);
    const Geometry<T> g = geometry_of(x);
    const Fraction<T> v = v_smith_ggx(Roughness<T>{T(alpha), T(alpha)}, g);
    return T(0.3 / kPi) + d(x) * (v.num / v.den) * (T(0.04) + T(0.96) * schlick(g));
  }
};

inline const Row<double> kGlass{0, 1.5, 0.04, 0};

template <class F>
Kernel picture_of_fresnel(F f, Row<double> index = kGlass, double kd = 0.3) {
  return kernel(ball_material<smith_correlated, F>{kd, 0.3, {}, f, index});
}
template <class V>
Kernel picture_of_masking(V v) {
  return kernel(ball_material<V, schlick_dielectric>{0.3, 0.3, v, {}, kGlass});
}

}  // namespace brdf::trade
