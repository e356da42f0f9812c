// The Oren-Nayar form in its qualitative, full and energy-preserving versions.
#pragma once

#include <cmath>

#include "brdf/form.h"
#include "brdf/forms/listing.h"

namespace brdf {

// Returns cos(phi_i - phi_o) sin a tan b with a the larger and b the smaller polar angle, if positive,
// otherwise 0. The value is x_i x_o + y_i y_o divided by the larger cosine. No angle is computed, and
// nothing cancels.
template <class G>
G oren_nayar_azimuth(const Geometry<G>& g) {
  const G s = tangential_product(g);
  return select(G(0) < s, s / larger(g.cos_i, g.cos_o), G(0));
}

// Returns the albedo at the polar angle t. tan t (1 - sin^3 t) is rewritten for t up to 90 degrees.
inline double oren_nayar_albedo(std::span<const double> shape, double t) {
  const double s2 = square(shape[0]), a = 1 - 0.5 * s2 / (s2 + 0.33), b = 0.45 * s2 / (s2 + 0.09);
  const double s = std::sin(t), c = std::cos(t);
  return a + b / kPi * (s * (t - s * c) + 2.0 / 3 * s * c * (1 + s + s * s) / (1 + s));
}

// Oren and Nayar 1994, the qualitative form (eq. 30): f = rho/pi (A + B max(0, cos dphi) sin a tan b),
// A = 1 - 0.5 s^2/(s^2 + 0.33), B = 0.45 s^2/(s^2 + 0.09), with a and b the larger and the smaller polar
// angle and s = sigma.
// Domain: sigma 0..pi/2.
// Symmetry: isotropic, reciprocal.
// Known violations: energy, by up to 1.5 % at rho = 1 (sigma 0.1985, towards grazing incidence); no
// violations for sigma >= 0.32613.
struct oren_nayar : Takes<DiffuseWeights, SlopeDeviation> {
  static constexpr std::string_view name = "oren_nayar";
  static constexpr std::string_view family = "oren_nayar";
  static constexpr Accuracy accuracy{.in_float = {7.9e-7, 0, 0}, .in_double = {1.4e-15, 1.4e-15, 0}};
  static constexpr Kink kink = Kink::azimuth;
  static constexpr std::array albedos{ClosedAlbedo{0, 90, oren_nayar_albedo, "the integral of eq. 30"}};
  static constexpr std::array violations{Violation{"energy",
                                                   "albedo up to 1.0152 at rho 1, for sigma below 0.32613",
                                                   "rho=1 sigma=0.198533", 90, 1.015179}};

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S s2 = square(shape.sigma);
    const S a = S(1) - S(0.5) * s2 / (s2 + S(0.33));
    const S b = S(0.45) * s2 / (s2 + S(0.09));
    return {S(1 / kPi) * (a + b * oren_nayar_azimuth(g))};
  }
};

// Returns sin(theta) from the tangential components, which is exact at both ends.
template <class G>
G sine(const Vec3<G>& w) {
  return math::sqrt(square(w.x) + square(w.y));
}

// Oren and Nayar 1994, eq. 27 and 28: f = rho/pi L1 + rho^2/pi L2 with a, b the larger and the smaller
// polar angle,
//   L1 = C1 + C2 cos(dphi) tan b + C3 (1 - |cos dphi|) tan((a+b)/2),  C1 = 1 - 0.5 s^2/(s^2 + 0.33),
//   C2 = 0.45 s^2/(s^2 + 0.09) (sin a - [(2b/pi)^3 if cos(dphi) < 0]),
//   C3 = 0.125 s^2/(s^2 + 0.09) (4ab/pi^2)^2,  L2 = 0.17 s^2/(s^2 + 0.13) (1 - cos(dphi) (2b/pi)^2).
// Domain: sigma 0..pi/2.
// Symmetry: isotropic, reciprocal.
// Known violations: energy, up to 1.0510 at rho 1 (sigma 0.304). For sigma > 0.664 L1 is negative when both
// directions graze; f is then negative for small rho.
struct oren_nayar_full : Takes<DiffuseWeights, SlopeDeviation> {
  static constexpr std::string_view name = "oren_nayar_full";
  static constexpr std::string_view family = "oren_nayar";
  static constexpr Accuracy accuracy{.in_float = {1.6e-6, 6.6e-7, 5.1e-7},
                                     .in_double = {2.8e-15, 3.1e-15, 1.2e-15}};
  static constexpr Kink kink = Kink::azimuth;
  static constexpr std::array violations{
      Violation{"energy", "albedo up to 1.0510 at rho 1 (sigma 0.304, towards 90 degrees)",
                "rho=1 sigma=0.304", 89.5, 1.04704},
      Violation{"non_negative", "the direct term is negative towards double grazing for sigma > 0.664",
                "rho=0.41 sigma=1.5707963267948966", 89.5, -0.01723}};

  // The terms of f that depend on the directions, computed without cancellation.
  template <class G>
  struct Angles {
    G facing;    // factor of C2 over B: cos(dphi) tan b (sin a - ...)
    G sideways;  // factor of C3 over B/8: (4ab/pi^2)^2 (1 - |cos dphi|) tan((a+b)/2)
    G multiple;  // cos(dphi) (2b/pi)^2
  };
  template <class G>
  static Angles<G> angles(const Geometry<G>& g) {
    const G tiny(1e-18);
    const G sin_i = sine(g.wi), sin_o = sine(g.wo);
    const G sin_a = larger(sin_i, sin_o), sin_b = smaller(sin_i, sin_o);
    const G cos_a = smaller(g.cos_i, g.cos_o), cos_b = larger(g.cos_i, g.cos_o);
    const G a = G(2 / kPi) * math::angle(sin_a, cos_a);
    const G b = G(2 / kPi) * math::angle(sin_b, cos_b);
    const G s = tangential_product(g);
    const G cos_phi = s / at_least(sin_i * sin_o, tiny);

    // sin a - b^3, divided by cos b. Both are near 1 near grazing; their distances to 1 are therefore
    // subtracted.
    const G b_left = G(2 / kPi) * math::angle(cos_b, sin_b);
    const G steep = b_left * (G(1) + b + b * b) - square(cos_a) / (G(1) + sin_a);
    const G back = select(sin_a < G(0.5), sin_a - b * b * b, steep);
    const G away = s / (at_least(sin_a, tiny) * cos_b) * back;

    // 1 - |cos dphi| = sin^2/(1 + |cos|). The cross product, computed from sum and difference, is exact if
    // the azimuths nearly agree; tan((a+b)/2) is large in that case.
    const Vec3<G> d = g.wo - g.wi;
    const G sin_phi = G(0.5) * (g.h.x * d.y - g.h.y * d.x) / at_least(sin_i * sin_o, tiny);
    const G aside = square(sin_phi) / (G(1) + larger(cos_phi, -cos_phi));
    return {select(s < G(0), away, s / cos_b), square(a * b) * aside * ((sin_i + sin_o) / g.h.z),
            cos_phi * square(b)};
  }

  template <class S, class G>
  static S value(const Weights<S>& w, const Weights<S>&, const Shape<S>& shape, const Geometry<G>& g) {
    const Angles<G> t = angles(g);
    const S s2 = square(shape.sigma);
    const S b = s2 / (s2 + S(0.09));
    const S direct = S(1) - S(0.5) * s2 / (s2 + S(0.33)) + b * (S(0.45) * t.facing + S(0.125) * t.sideways);
    const S interreflected = S(0.17) * s2 / (s2 + S(0.13)) * (S(1) - t.multiple);
    return S(1 / kPi) * w.rho * (direct + w.rho * interreflected);
  }
};

// rho is not a weight: light is reflected repeatedly, and values above 1 have no meaning.
template <class T>
struct Reflectivity {
  T rho;
  static constexpr auto fields() {
    return std::array{Field{&Reflectivity::rho, ParameterInfo{"rho", 0, 1, 0.5, 1, "", false,
                                                              "diffuse reflectance", Role::diffuse}}};
  }
};

template <class T>
struct UnitRoughness {
  T roughness;
  static constexpr auto fields() {
    return std::array{Field{&UnitRoughness::roughness,
                            ParameterInfo{"roughness", 0, 1, 0.5, 1, "", false,
                                          "0 for smooth, 1 for fully rough", Role::other, Map::roughness}}};
  }
};

// Fujii's form with the energy-preserving term: Portsmouth, Kutz and Hill 2024 (EON), r = roughness,
//   f = rho/pi A (1 + r s/t) + rho_ms/pi (1 - E_i)(1 - E_o)/(1 - E_avg),  A = 1/(1 + c1 r),
//   c1 = 1/2 - 2/(3 pi), c2 = 2/3 - 28/(15 pi), E_avg = A (1 + c2 r),
//   rho_ms = rho^2 E_avg/(1 - rho (1 - E_avg)),
//   s = wi.wo - cos_i cos_o, t = max(cos_i, cos_o) if s > 0, else 1.
// E is the exact albedo of the first term. 1 - E = A r (c1 - G/pi) and 1 + s are computed without
// cancellation; 0/0 does not occur.
// Domain: roughness 0..1, rho 0..1.
// Symmetry: isotropic, reciprocal. The albedo is 1 at rho 1.
// Known violations: none.
struct oren_nayar_energy : Takes<Reflectivity, UnitRoughness> {
  static constexpr std::string_view name = "oren_nayar_energy";
  static constexpr std::string_view family = "oren_nayar";
  static constexpr Accuracy accuracy{.in_float = {7.5e-7, 6.4e-7, 4e-7},
                                     .in_double = {1.4e-15, 1.3e-15, 1.1e-15}};
  static constexpr Kink kink = Kink::azimuth;
  static constexpr std::array albedos{ClosedAlbedo{0, 90, whole_albedo, "white surfaces lose nothing"}};
  static constexpr NoViolations violations{};

  static constexpr double kC1 = 0.5 - 2 / (3 * kPi);
  static constexpr double kC2 = 2.0 / 3 - 28 / (15 * kPi);

  // Returns pi c1 - G(theta), the loss of the first term at that angle. The result is proportional to the
  // cosine towards grazing incidence.
  template <class G>
  static G missing(const Vec3<G>& w, const G& c) {
    const G s = sine(w);
    return G(kPi / 2 - 2.0 / 3) * (c * c) / (G(1) + s) + s * math::angle(c, s) + s * s * c -
           G(2.0 / 3) * s * c * (G(1) + s + s * s) / (G(1) + s);
  }

  template <class S, class G>
  static S value(const Weights<S>& w, const Weights<S>&, const Shape<S>& shape, const Geometry<G>& g) {
    const S& r = shape.roughness;
    const G s = tangential_product(g);
    const G below = G(0.5) * (square(g.h.x) + square(g.h.y) + square(g.cos_i) + square(g.cos_o));  // 1 + s
    const S single = select(s < G(0), (S(1) - r) + r * below, S(1) + r * (s / larger(g.cos_i, g.cos_o)));
    const S a = S(1) / (S(1) + S(kC1) * r);
    const S average = a * (S(1) + S(kC2) * r);
    const S rho_ms = square(w.rho) * average / (S(1) - w.rho * (a * r * S(kC1 - kC2)));
    const G missed = missing(g.wi, g.cos_i) * missing(g.wo, g.cos_o) * G(1 / (kPi * kPi * (kC1 - kC2)));
    return S(1 / kPi) * a * (w.rho * single + rho_ms * r * missed);
  }
};

template <class T>
struct LinearAlbedo {
  T albedo;
  static constexpr auto fields() {
    return std::array{Field{&LinearAlbedo::albedo, ParameterInfo{"albedo", 0, kWeightMax, 0.5, 1, "", false,
                                                                 "colour of the surface", Role::diffuse}}};
  }
  constexpr std::array<T, 1> linear() const { return {albedo}; }
  static constexpr LinearAlbedo from_linear(const std::array<T, 1>& w) { return {w[0]}; }
};

// The listing of the thesis, with s = roughness^2: f = albedo/pi (C1 + C2)(1 + roughness/2),
// C1 = 1 - 0.5 s^2/(s^2 + 0.33), C2 = 0.45 s^2/(s^2 + 0.09) c (times 1/max(cos_i, cos_o) if c >= 0),
// c = wi.wo - cos_i cos_o.
// Domain: roughness 0..1.
// Symmetry: isotropic, reciprocal.
// Known violations: energy, by the factor 1 + roughness/2: 1.15 at normal incidence (roughness 0.5).
struct oren_nayar_as_coded : Takes<LinearAlbedo, UnitRoughness> {
  static constexpr std::string_view name = "oren_nayar_as_coded";
  static constexpr std::string_view family = "oren_nayar";
  static constexpr Accuracy accuracy{.in_float = {1.2e-6, 1.2e-6, 0}, .in_double = {2e-15, 2.4e-15, 2.1e-15}};
  static constexpr Kink kink = Kink::azimuth;
  static constexpr std::array violations{Violation{"energy", "albedo above 1 by the factor 1 + roughness/2",
                                                   "albedo=1 roughness=0.55", 89.5, 1.21904}};

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S s2 = square(square(shape.roughness));
    const G c = tangential_product(g);
    const G azimuth = select(c < G(0), c, c / larger(g.cos_i, g.cos_o));
    const S c1 = S(1) - S(0.5) * s2 / (s2 + S(0.33));
    const S c2 = S(0.45) * s2 / (s2 + S(0.09)) * azimuth;
    return {S(1 / kPi) * (c1 + c2) * (S(1) + S(0.5) * shape.roughness)};
  }
};

}  // namespace brdf
