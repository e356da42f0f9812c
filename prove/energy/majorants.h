// Reasons why no form of these families reflects more than it receives, each with the formula that it
// applies to. A form belongs to a family if its recorded formula is that formula (energy.cpp), so that no
// form is mistaken for another.
//
// For facets: f_specular cos_o = p(wo | wi) R. Here p = D G1(wi)/(4 cos_i) is the density of visible
// normals, mirrored, with the integral 1 (Heitz and d'Eon 2014), and R = F G2/G1(wi). If R <= 1 everywhere,
// the albedo of the lobe is at most 1, and with kd + ks <= 1 the albedo of the whole form is. R is written
// without terms that cancel.
#pragma once

#include "brdf/fresnel.h"
#include "brdf/microfacet.h"
#include "prove/energy/facet_cells.h"
#include "prove/scalar/lemmas.h"

namespace brdf::prove {

// G2/G1(wi) = (1 + Lambda_i)/(1 + Lambda_i + Lambda_o) = 1 - Lambda_o/(1 + Lambda_i + Lambda_o), a function
// of positive numbers.
template <class T>
T smith_ratio(const T& lambda_o, const T& lambda_i) {
  return at_least(T(1) - lambda_o / (T(1) + lambda_i + lambda_o), T(0));
}

struct GgxSmith {
  template <class W>
  using Cell = GgxSmithCell<W>;
  static constexpr bool tied = false;
  template <class S, class G>
  static S lobe(const Roughness<S>& a, const Geometry<G>& g) {
    return quotient(d_ggx(a, g), v_smith_ggx(a, g));
  }
  // (sqrt(1 + t^2) - 1)/2 of the scaled tangent t
  template <class T>
  static T lambda(const Roughness<T>& a, const Vec3<T>& w) {
    const T t2 = (square(a.alpha_x * w.x) + square(a.alpha_y * w.y)) / square(w.z);
    return T(0.5) * t2 / (T(1) + math::sqrt(T(1) + t2));
  }
  template <class T>
  static T ratio(const Roughness<T>& a, const Geometry<T>& g) {
    return smith_ratio(lambda(a, g.wo), lambda(a, g.wi));
  }
};

struct BeckmannSmith {
  template <class W>
  using Cell = BeckmannSmithCell<W>;
  static constexpr bool tied = false;
  template <class S, class G>
  static S lobe(const Roughness<S>& a, const Geometry<G>& g) {
    return quotient(d_beckmann(a, g), v_smith_beckmann(a, g));
  }
  // In exact arithmetic this is not negative; the library's clamp at ten widths removes e^-100 of the
  // value.
  template <class T>
  static T lambda(const Roughness<T>& a, const Vec3<T>& w) {
    return at_least(cos_lambda_beckmann(a, w), T(0)) / w.z;
  }
  template <class T>
  static T ratio(const Roughness<T>& a, const Geometry<T>& g) {
    return smith_ratio(lambda(a, g.wo), lambda(a, g.wi));
  }
};

// The cavities of Torrance and Sparrow mask as G1 = min(1, 2 cos_h cos/cos_d) and G2 = min(G1(wi), G1(wo)).
struct BeckmannCavities {
  template <class W>
  using Cell = BeckmannCavityCell<W>;
  static constexpr bool tied = false;
  template <class S, class G>
  static S lobe(const Roughness<S>& a, const Geometry<G>& g) {
    return quotient(d_beckmann(a, g), v_cavities(g));
  }
  template <class T>
  static T ratio(const Roughness<T>&, const Geometry<T>& g) {
    const auto masking = [&](const T& c) { return at_most(T(4) * g.h.z * c / g.h2, T(1)); };
    return at_most(masking(g.cos_o) / masking(g.cos_i), T(1));
  }
};

// Schlick's masking s = cos/(cos (1 - k) + k), k = (alpha + 1)^2/8, with the distribution that has the
// masking G1 of GGX: R = F s(wo) s(wi)/G1(wi). With u = 1/cos_i,
//   1/s - 1/G1 = (u - 1)(k - alpha^2 (u + 1)/(2 (1 + sqrt(1 + alpha^2 (u^2 - 1))))).
// The last fraction is at most alpha/2, since the root is at least alpha u + alpha - 1. With
//   k - alpha/2 = (1 - alpha)^2/8
// the ratio s/G1 is at most 1 - (u - 1)(1 - alpha)^2/8 s. This holds for equal widths; for unequal widths k
// does not depend enough on the larger one.
struct GgxSchlick {
  static constexpr bool tied = true;
  template <class S, class G>
  static S lobe(const Roughness<S>& a, const Geometry<G>& g) {
    return quotient(d_ggx(a, g), v_schlick_ggx(k_schlick_ggx(a), g));
  }
  template <class T>
  static T ratio(const Roughness<T>& a, const Geometry<T>& g) {
    const T alpha = a.alpha_x, k = square(alpha + T(1)) * T(0.125);
    const auto rest = [&](const T& c) { return k * ((T(1) - c) / c); };  // 1/s - 1
    const T s_o = T(1) / (T(1) + rest(g.cos_o));
    const T loss = (T(1) - g.cos_i) / g.cos_i * square(T(1) - alpha) * T(0.125) / (T(1) + rest(g.cos_i));
    return at_least(T(1) - at_least(loss, T(0)), T(0)) * at_most(s_o, T(1));
  }
};

// F = f0 + (1 - f0) s = 1 - (1 - f0)(1 - s), with s and f0 in [0, 1].
template <class T>
T schlick_fresnel(const T& f0, const Geometry<T>& g) {
  return at_least(T(1) - (T(1) - f0) * at_least(T(1) - schlick(g), T(0)), T(0));
}
// The Fresnel reflectance is at most 1.
//
// A dielectric has F = s^2 (1 + p^2)/2 with g = sqrt(eta^2 - 1 + c^2) and
//   s = (g - c)/(g + c),  p = (c (g + c) - 1)/(c (g - c) + 1).
// F is at most 1 for eta >= 1 and c <= 1, because
//   s = 1 - 2 c/(g + c),  p = 1 - 2 (1 - c^2)/(c (g - c) + 1) = -1 + 2 c g/(c (g - c) + 1).
//
// A conductor has the index N and w = sqrt(N^2 - 1 + c^2), Re w >= 0. Its two factors
//   |(c - w)/(c + w)|^2,  |(N^2 c - w)/(N^2 c + w)|^2
// are at most 1 if c Re w and c Re(N^2 conj w) are not negative. The latter is c Re w (|w|^2 + 1 - c^2).
template <class T>
T most_fresnel() {
  return T(1);
}

// --- Oren and Nayar's qualitative form: f = (A + B max(0, s)/max(cos_i, cos_o))/pi -------------------------

// Returns the lobe as the form writes it.
template <class S, class G>
S oren_nayar_lobe(const S& sigma, const Geometry<G>& g) {
  const S s2 = square(sigma);
  const S a = S(1) - S(0.5) * s2 / (s2 + S(0.33));
  const S b = S(0.45) * s2 / (s2 + S(0.09));
  return S(1 / kPi) * (a + b * oren_nayar_azimuth(g));
}

// Returns the albedo at the polar angle with this sine and cosine. Over the azimuth max(0, s) integrates to
// 2 sin_i sin_o. The ratio cos_o/max(cos_i, cos_o) is 1 below theta_i and cos_o/cos_i beyond theta_i, so
// that the remaining integrals are (theta - s c)/2 and (1 - s^3)/(3 c). The albedo is
//   A + B/pi (s (theta - s c) + 2/3 s c (1 + s + s^2)/(1 + s)),
// in which nothing is divided by the cosine. In A and B, sigma^2/(sigma^2 + k) is written as 1 - k/(sigma^2
// + k), in which sigma occurs once.
template <class T>
T oren_nayar_albedo_of(const T& sigma, const T& sine, const T& cosine) {
  const T s2 = square(sigma);
  const T a = T(0.5) + T(0.5) * (T(0.33) / (s2 + T(0.33)));
  const T b = T(0.45) - T(0.45) * (T(0.09) / (s2 + T(0.09)));
  const T angle = math::angle(sine, cosine);
  const T inner = sine * (angle - sine * cosine) +
                  T(2.0 / 3) * sine * cosine * ((T(1) + sine + square(sine)) / (T(1) + sine));
  return a + b * T(1 / kPi) * inner;
}

// --- The energy-preserving diffuse form --------------------------------------------------------------------

// A (1 + r s/t), plus the missing energy, which is returned over both directions: the recorded formula.
template <class W, class S, class G>
S given_back_value(const W& weight, const S& r, const Geometry<G>& g) {
  constexpr double c1 = 0.5 - 2 / (3 * kPi), c2 = 2.0 / 3 - 28 / (15 * kPi);
  const auto missed = [](const Vec3<G>& w, const G& c) {
    const G sine_w = sine(w), series = G(1) + sine_w + sine_w * sine_w;
    return G(kPi / 2 - 2.0 / 3) * (c * c) / (G(1) + sine_w) + sine_w * math::angle(c, sine_w) +
           sine_w * sine_w * c - G(2.0 / 3) * sine_w * c * series / (G(1) + sine_w);
  };
  const G s = tangential_product(g),
          below = G(0.5) * (square(g.h.x) + square(g.h.y) + square(g.cos_i) + square(g.cos_o));
  const S first = select(s < G(0), (S(1) - r) + r * below, S(1) + r * (s / larger(g.cos_i, g.cos_o)));
  const S a = S(1) / (S(1) + S(c1) * r), average = a * (S(1) + S(c2) * r);
  const S again = square(weight) * average / (S(1) - weight * (a * r * S(c1 - c2)));
  const G both = missed(g.wi, g.cos_i) * missed(g.wo, g.cos_o) * G(1 / (kPi * kPi * (c1 - c2)));
  return S(1 / kPi) * a * (weight * first + again * r * both);
}

// Returns the albedo of the energy-preserving diffuse form. The albedo of the first term is rho (1 - m)
// with m = A r M/pi and M = pi c1 - G(theta) >= 0. From 1 - s = c^2/(1 + s),
//   M = kappa + (1 - s)(theta - 2/3 - s c (s + 2)/(3 (1 + s))),  kappa = pi/2 - theta.
// The second term returns rho q m with
//   1 - q = (1 - rho)/(1 - rho (1 - E_avg)) >= 0.
// The sum, rho (1 - m (1 - q)), is at most rho.
template <class T>
T given_back_albedo(const T& rho, const T& r, const T& sine, const T& cosine) {
  const T c1(0.5 - 2 / (3 * kPi)), rest(0.5 - 2 / (3 * kPi) - (2.0 / 3 - 28 / (15 * kPi)));
  const T theta = math::angle(sine, cosine), kappa = math::angle(cosine, sine);
  const T missing = kappa + square(cosine) / (T(1) + sine) *
                                (theta - T(2.0 / 3) - sine * cosine * (sine + T(2)) / (T(3) * (T(1) + sine)));
  const T ar = r / (T(1) + c1 * r);
  const T lost = ar * missing * T(1 / kPi);
  const T kept = (T(1) - rho) / (T(1) - rho * (ar * rest));
  return rho * (T(1) - lost * kept);
}

}  // namespace brdf::prove
