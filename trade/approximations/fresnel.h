// Cheaper Fresnel terms. Row: cos_d, eta, f0 (dielectric) or cos_d, n, k, f0 (conductor).
#pragma once

#include "brdf/fresnel.h"
#include "trade/measure/kernel.h"

namespace brdf::trade {

template <class T>
T fifth_power(const T& x) {
  return square(square(x)) * x;
}

struct exact_dielectric {
  template <class T>
  T operator()(const Row<T>& x) const {
    return fresnel_dielectric(x[1], x[0]);
  }
};

// Schlick 1994: f0 + (1 - f0)(1 - c)^5.
struct schlick_dielectric {
  template <class T>
  T operator()(const Row<T>& x) const {
    return x[2] + (T(1) - x[2]) * fifth_power(T(1) - x[0]);
  }
};

// Lagarde 2012 / Karis 2013: the fifth power as 2^((-5.55473 c - 6.98316) c).
struct gaussian_dielectric {
  template <class T>
  T operator()(const Row<T>& x) const {
    const T log2 = (T(-5.55473) * x[0] - T(6.98316)) * x[0];
    return x[2] + (T(1) - x[2]) * math::exp(log2 * T(0.69314718055994531));
  }
};

// No angle at all.
struct constant_dielectric {
  template <class T>
  T operator()(const Row<T>& x) const {
    return x[2];
  }
};

// The lookup-texture article's slip.
struct slipped_dielectric {
  template <class T>
  T operator()(const Row<T>& x) const {
    return fresnel_dielectric_as_coded(x[1], x[0]);
  }
};

struct exact_conductor {
  template <class T>
  T operator()(const Row<T>& x) const {
    return fresnel_conductor(x[1], x[2], x[0]);
  }
};

struct schlick_conductor {
  template <class T>
  T operator()(const Row<T>& x) const {
    return x[3] + (T(1) - x[3]) * fifth_power(T(1) - x[0]);
  }
};

// Lazanyi and Szirmay-Kalos 2005: Schlick less a c (1 - c)^e, with Hoffman's (2019) choice of e = 6 and a
// from the exact value at 82 degrees (c = 1/7). Column 4 holds a.
struct lazanyi_conductor {
  template <class T>
  T operator()(const Row<T>& x) const {
    const T u = T(1) - x[0];
    const T u5 = fifth_power(u);
    return x[3] + (T(1) - x[3]) * u5 - x[4] * x[0] * u5 * u;
  }
};

// Pharr and Humphreys 2004 (first edition): both polarisations with sin^2 dropped against n^2 + k^2.
struct simplified_conductor {
  template <class T>
  T operator()(const Row<T>& x) const {
    const T c = x[0], n = x[1], m = square(x[1]) + square(x[2]), c2 = c * c;
    const T rp = (m * c2 - T(2) * n * c + T(1)) / (m * c2 + T(2) * n * c + T(1));
    const T rs = (m - T(2) * n * c + c2) / (m + T(2) * n * c + c2);
    return T(0.5) * (rp + rs);
  }
};

}  // namespace brdf::trade
