// Cheaper lobes.
#pragma once

#include <cmath>

#include "brdf/forms/blinn_phong.h"
#include "brdf/forms/phong.h"
#include "trade/approximations/masking.h"

namespace brdf::trade {

// c^n. Row: c, n.
struct cosine_power {
  template <class T>
  T operator()(const Row<T>& x) const {
    return math::pow(x[0], x[1]);
  }
};
struct cosine_power_libm {
  template <class T>
  T operator()(const Row<T>& x) const {
    return std::pow(x[0], x[1]);
  }
};
// Wang et al. 2009: a spherical Gaussian e^(n (c - 1)).
struct spherical_gaussian {
  template <class T>
  T operator()(const Row<T>& x) const {
    return math::exp(x[1] * (x[0] - T(1)));
  }
};
// Schlick 1994: c/(n - n c + c).
struct schlick_power {
  template <class T>
  T operator()(const Row<T>& x) const {
    return x[0] / (x[1] - x[1] * x[0] + x[0]);
  }
};
// Repeated squaring for an exponent known beforehand.
template <int doublings>
struct squared_power {
  template <class T>
  T operator()(const Row<T>& x) const {
    T y = x[0];
    for (int k = 0; k < doublings; ++k) y = y * y;
    return y;
  }
};

// Phong's lobe (r.o)^n as a renderer has it, by vectors. Row: wi, wo, n in column 6.
struct mirror_lobe {
  template <class T>
  T operator()(const Row<T>& x) const {
    // r = 2 (n.l) n - l with n = +z
    const T c = at_least(x[2] * x[5] - x[0] * x[3] - x[1] * x[4], T(0));
    return math::pow(c, x[6]);
  }
};
// Blinn's half vector with `factor` times the exponent; 4 makes it as narrow as the mirror direction's.
struct half_lobe {
  double factor;
  template <class T>
  T operator()(const Row<T>& x) const {
    const Vec3<T> h{x[0] + x[3], x[1] + x[4], x[2] + x[5]};
    const T c = h.z / math::sqrt(dot(h, h));
    return math::pow(c, T(factor) * x[6]);
  }
};
// The same lobes through differences, accurate at the peak for any exponent.
struct mirror_lobe_stable {
  template <class T>
  T operator()(const Row<T>& x) const {
    return mirror_cosine_power(x[6], geometry_of(x));
  }
};

// D of GGX. Row: wi, wo, alpha.
struct ggx_stable {
  template <class T>
  T operator()(const Row<T>& x) const {
    const Fraction<T> d = d_ggx(Roughness<T>{x[6], x[6]}, geometry_of(x));
    return d.num / d.den;
  }
};
// As it is printed nearly everywhere: alpha^2/(pi ((n.h)^2
// (alpha^2 - 1) + 1)^2) with a normalised half vector.
struct ggx_naive {
  template <class T>
  T operator()(const Row<T>& x) const {
    Vec3<T> h{x[0] + x[3], x[1] + x[4], x[2] + x[5]};
    h = h * (T(1) / math::sqrt(dot(h, h)));
    const T a2 = x[6] * x[6];
    const T t = h.z * h.z * (a2 - T(1)) + T(1);
    return a2 / (T(kPi) * t * t);
  }
};

}  // namespace brdf::trade
