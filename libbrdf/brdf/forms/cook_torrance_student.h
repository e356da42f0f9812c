// The Cook-Torrance form with Student's t distribution of slopes.
#pragma once

#include <algorithm>

#include "brdf/dual.h"
#include "brdf/facets.h"
#include "brdf/form.h"
#include "brdf/microfacet.h"
#include "brdf/samplers.h"

namespace brdf {

// The widths, and the exponent of the tail.
template <class T>
struct StudentRoughness {
  T alpha_x, alpha_y, gamma;
  static constexpr auto fields() {
    return std::array{
        Field{&StudentRoughness::alpha_x, kAlongInfo}, Field{&StudentRoughness::alpha_y, kAcrossInfo},
        Field{&StudentRoughness::gamma,
              ParameterInfo{"gamma", 1.6, 10, 2, 10, "", true,
                            "exponent of the tail: 2 is GGX, smaller values are hazier", Role::other}}};
  }
  // Returns the widths of the GGX lobe with the same scaled slope: alpha sqrt(gamma - 1).
  Roughness<T> ggx() const {
    const T scale = math::sqrt(gamma - T(1));
    return {alpha_x * scale, alpha_y * scale};
  }
};

namespace detail {

// R of tools/student_coefficients.py. Rows are powers of x, columns are powers of y.
inline constexpr double kStudentP = 4.5, kStudentQ = 7.4, kStudentK = 3.1;
inline constexpr std::array<std::array<double, 13>, 10> kStudentMasking{{
    {{0.21000683200894946, 0.12631447484924915, -0.031448929863122886, -0.003563177924505446,
      0.0018032995331538867, -0.0011037240835656233, 0.00034817910071643503, -0.0001277302323183745,
      3.638713705663069e-05, -1.1264447251987916e-05, 2.991624364776405e-06, -1.1045955107676518e-06,
      2.726473470215028e-07}},
    {{-0.19824325307881907, -0.2352754636847249, -0.01741322452815668, 0.019360577888066836,
      -0.0037822266483411695, 0.0014179275134788099, -0.00016044760411150757, 3.881898531052914e-05,
      1.2601379495243371e-05, -4.626793777583855e-06, 3.2686559434387407e-06, -2.1653863233739304e-06,
      9.166105581500814e-07}},
    {{0.06524558514930011, 0.1449957231077621, 0.07884626198182203, -0.0035264676497009247,
      -0.0017563515154087946, 0.0007005184058363546, -0.0004802254171732639, 0.00011559581063441926,
      -5.238549541962488e-05, 1.1279930977842106e-05, -4.393640018802473e-06, 1.0786881019649423e-06,
      -4.017658868900743e-07}},
    {{-0.008409925023877066, -0.036748361748668495, -0.0492032550033809, -0.020062423385596204,
      0.0003539598832911806, -0.0004835058153005864, -3.757024587012467e-05, 5.73391471107233e-05,
      -1.927162162290076e-05, 1.1132421705789029e-05, -2.838952745178302e-06, 2.234501864023875e-06,
      -6.015073442668472e-07}},
    {{0.00027482686731766977, 0.003212600868363495, 0.010342549272907795, 0.012287406586644728,
      0.0049023398292172725, 0.0003378030526123262, 0.00030139544561802304, 9.28434306930373e-06,
      7.1933483014740945e-06, 1.424104250873149e-06, -8.696226289964918e-07, 7.009747736834266e-07,
      -3.6646345260302334e-07}},
    {{7.319038646382862e-06, 2.703248801521276e-05, -0.00040857105102493123, -0.0018766604656634456,
      -0.002513519519678969, -0.0011291305934055787, -0.00017440002547357655, -0.00010686898359426403,
      -8.997139358551863e-06, -7.1430546453140256e-06, -4.1745033998886775e-07, -2.8955200224165003e-07,
      -6.843050849025654e-08}},
    {{4.956143661066414e-07, 4.206236867872636e-07, -3.290925842328167e-05, -4.8555088041537404e-05,
      0.00019308128112505347, 0.00041946638868459575, 0.0002305935759702672, 4.995283931665376e-05,
      3.0514832977357456e-05, 4.348781016818534e-06, 2.6627627856588482e-06, 3.868075916212815e-07,
      1.1786356635805268e-07}},
    {{4.8708793812921885e-08, -4.604608549608298e-08, -3.3121602808747997e-06, 1.0332698210849259e-06,
      2.778857999516698e-05, 7.710276603619623e-06, -5.252235309818993e-05, -4.031077473914268e-05,
      -1.0299994758435198e-05, -6.6652427545164995e-06, -1.2729446026604129e-06, -1.0447975306128835e-06,
      -1.569890663521101e-07}},
    {{6.299876876694234e-09, -1.5305844118119375e-08, -4.188355835645434e-07, 7.619837746168977e-07,
      3.3376062597622928e-06, -4.209485584172344e-06, -7.753473850380319e-06, 4.5001651639842545e-06,
      5.262802427649082e-06, 9.782711354486348e-07, 1.323168091077563e-06, 3.290689794848099e-07,
      4.415093689613812e-07}},
    {{9.024302729688726e-10, -2.9217232000292246e-09, -5.771379554409958e-08, 1.6702091497244388e-07,
      3.654256722525137e-07, -1.0688538118091476e-06, -5.026147099054931e-07, 1.6787681120271136e-06,
      1.6531862317726211e-07, -3.5604114663763113e-07, -3.124190587906436e-08, -4.6093665913970305e-07,
      -2.5425697965523845e-08}},
}};

}  // namespace detail

// Smith's masking for Student's t slopes. The stretched length of GGX, which gives the visible area of the
// facets, becomes cos + length S^(gamma - 1) P. S is the squared sine of the stretched direction. With m its
// cosine, P = 2F1(1, gamma - 3/2; gamma; 1 - m^2) Gamma(gamma - 3/2)/(2 sqrt(pi) Gamma(gamma)). P is computed
// with a relative error of 2e-9 by a polynomial in (3 m - 1)/(m + 1); its coefficients depend on gamma alone.
template <class S>
class StudentMasking {
  static constexpr std::size_t kTerms = std::size(detail::kStudentMasking);

 public:
  explicit StudentMasking(const S& gamma) : gamma_(gamma) {
    if constexpr (Differentiated<S>) {  // by the chain rule, with three polynomials of plain numbers
      const auto c = coefficients(Dual<B, 1>::variable(gamma.a, 0));
      for_each_term([&](auto k) { by_gamma_[k] = c[k].v[0]; });
      for_each_term([&](auto k) { c_[k] = c[k].a; });
    } else {
      c_ = coefficients(gamma);
    }
  }

  // Returns the length that replaces cos + stretched length. `a` are the widths of ggx().
  template <class G>
  S length(const Roughness<S>& a, const Vec3<G>& w) const {
    const S tangent2 = square(a.alpha_x * w.x) + square(a.alpha_y * w.y);
    const S length2 = tangent2 + square(w.z);
    const S stretched = math::sqrt(length2);
    const S x = (G(3) * w.z - stretched) / (stretched + w.z);
    return stretched * (math::pow(tangent2 / length2, gamma_ - S(1)) * factor(x)) + w.z;
  }

  // Returns the coefficients of P, by powers of x.
  template <class T>
  static std::array<T, kTerms> coefficients(const T& gamma) {
    const T y = T(detail::kStudentK) * (gamma - T(detail::kStudentP)) / (gamma + T(detail::kStudentQ));
    const T scale = square(gamma + T(2)) / ((gamma - T(1.5)) * ((gamma - T(0.5)) * (gamma + T(0.5))));
    std::array<T, kTerms> c;
    for_each_term([&](auto k) { c[k] = scale * kernels::horner(y, detail::kStudentMasking[k]); });
    return c;
  }

 private:
  using B = base_scalar_t<S>;
  using Plain = std::conditional_t<Differentiated<S>, B, S>;

  template <class F>
  static void for_each_term(F&& f) {
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      (f(std::integral_constant<std::size_t, k>{}), ...);
    }(std::make_index_sequence<kTerms>{});
  }

  S factor(const S& x) const {
    if constexpr (Differentiated<S>) {
      B p(0), by_x(0), by_gamma(0);
      for_each_term([&](auto k) {
        by_x = by_x * x.a + p;
        p = p * x.a + c_[kTerms - 1 - k];
        by_gamma = by_gamma * x.a + by_gamma_[kTerms - 1 - k];
      });
      return S{p, x.v * by_x + gamma_.v * by_gamma};
    } else {
      S p = c_[kTerms - 1];
      for_each_term([&](auto k) {
        if constexpr (k > 0) p = p * x + c_[kTerms - 1 - k];
      });
      return p;
    }
  }

  S gamma_;
  std::array<Plain, kTerms> c_, by_gamma_;
};

// Returns the ratio of D to the D of GGX with the widths of ggx(): (gamma - 1) (1 + tan^2)^(2 - gamma),
// with tan^2 scaled by these widths.
template <class S, class G>
S student_over_ggx(const S& gamma, const Roughness<S>& a, const Geometry<G>& g) {
  const S tangent2 = scaled_tangent2(a, g) / square(g.h.z);
  return (gamma - S(1)) * math::exp((S(2) - gamma) * math::log1p(tangent2));
}

// Slopes and masking, for numerical integration.
struct StudentFacets {
  static StudentRoughness<double> of(std::span<const double> shape) { return {shape[0], shape[1], shape[2]}; }
  static void slopes(std::span<const double> shape, std::size_t count, const Vec3<double>* h, double* out) {
    const StudentRoughness<double> s = of(shape);
    Geometry<double> g{};
    for (std::size_t k = 0; k < count; ++k) {
      g.h = h[k];
      out[k] = GgxSlopes::density(s.ggx(), h[k]) * student_over_ggx(s.gamma, s.ggx(), g);
    }
  }
  static void masking(std::span<const double> shape, const Vec3<double>& o, std::size_t count,
                      const Vec3<double>*, double* out) {
    const StudentRoughness<double> s = of(shape);
    std::fill(out, out + count, 2 * o.z / (o.z + StudentMasking<double>(s.gamma).length(s.ggx(), o)));
  }
  // The mean slope of the heaviest tail needs this range for an accuracy of seven digits.
  static constexpr FacetFacts facts{1e36, slopes, masking};
};

// Samples the half vector with slopes from Student's distribution. Density: D cos_h.
struct StudentSlopes {
  template <class T>
  static Vec3<T> sample(const StudentRoughness<T>& s, T u1, T u2, const Vec3<T>& wo) {
    using std::cos, std::sin, std::expm1, std::log1p;
    const Roughness<T> a = s.ggx();
    // Infinite for u1 of exactly 1, which a generator that rounds to float can return.
    const T slope2 = at_most(expm1(-log1p(-u1) / (s.gamma - T(1))), T(1e30));
    const T radius = math::sqrt(slope2);
    const T phi = T(2 * kPi) * u2;
    return mirrored(wo,
                    normalised(Vec3<T>{a.alpha_x * radius * cos(phi), a.alpha_y * radius * sin(phi), T(1)}));
  }
  template <class T>
  static T pdf(const StudentRoughness<T>& s, const Geometry<T>& g) {
    const Roughness<T> a = s.ggx();
    const Fraction<T> d = d_ggx(a, g);
    return d.num / d.den * student_over_ggx(s.gamma, a, g) * g.h.z / (T(8) * square(g.cos_d));
  }
};

// Cook and Torrance 1982 with Student's t distribution of slopes (Ribardiere, Bringier, Meneveaux and
// Simonot 2017), its height-correlated Smith masking and Schlick's Fresnel:
// f = kd/pi + ks D G F/(4 cos_i cos_o), D = (1 + tan^2/(gamma - 1))^-gamma/(pi alpha_x alpha_y cos_h^4),
// tan^2 = ((h_x/alpha_x)^2 + (h_y/alpha_y)^2)/h_z^2.
// Domain: alpha 1e-4..1, gamma 1.6..10, f0 0..1. (For gamma below 1.5 the facets have no mean slope, and
// everything is masked.)
// Symmetry: anisotropic, reciprocal. gamma = 2 gives cook_torrance; the limit of large gamma is
// cook_torrance_beckmann.
// Known violations: only for kd + ks > 1.
struct cook_torrance_student : Takes<SchlickWeights, StudentRoughness> {
  static constexpr std::string_view name = "cook_torrance_student";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {8e-6, 8.8e-6, 1.4e-5},
                                     .in_double = {1.2e-14, 1.5e-14, 1.7e-14}};
  static constexpr Kink kink = Kink::none;
  using Facets = StudentFacets;
  using Sampler = StudentSlopes;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> a = shape.ggx();
    const StudentMasking<S> masking(shape.gamma);
    const Fraction<S> v{S(0.5), g.cos_o * masking.length(a, g.wi) + g.cos_i * masking.length(a, g.wo)};
    const S vd = quotient(d_ggx(a, g), v) * student_over_ggx(shape.gamma, a, g);
    return {S(1 / kPi), vd, vd * schlick(g)};
  }
};

}  // namespace brdf
