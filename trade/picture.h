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
