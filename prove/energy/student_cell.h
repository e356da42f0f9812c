// The cells of Student's t facets (facet_albedo.h), stretched by the roughnesses of the GGX lobe that has
// the same scaled slope.
//
// T(N_z) = (gamma - 1) N_z^(2 gamma - 4) is the ratio of the distribution to the distribution of GGX. With
// steps t of N_z = t^(1/(2 gamma - 3)) this ratio disappears from the integrand:
//   T dN_z = (gamma - 1)/(2 gamma - 3) dt.
// The visible area of the facets from cosine c, over c, is a function of m = 1/c,
//   B(m) = m (1 - 1/m^2)^(gamma - 1) P(4/(m + 1) - 1) + 1,
// with the polynomial P of StudentMasking; A_v = c B(1/c). P is not negative (student_polynomial), so that
// B is at least 1.
#pragma once

#include "prove/energy/facet_albedo.h"

namespace brdf::prove {

// B and A of one exponent.
class StudentArea {
 public:
  explicit StudentArea(const Exactly& gamma)
      : power_(gamma - Exactly(1)), c_(StudentMasking<double>::coefficients(gamma)) {}
  // Returns A for a stretched direction, given its cosine and sine.
  template <class T>
  T seen(const T& cosine, const T& sine) const {
    const T x = cosine / (cosine + Exactly(1)) * Exactly(4) - Exactly(1);
    return powered(square(sine)) * polynomial(x) + cosine;
  }
  // Returns B for m >= 1.
  template <class T>
  T over_cosine(const T& m) const {
    const T x = Exactly(4) / (m + Exactly(1)) - Exactly(1);
    return m * (powered(Exactly(1) - Exactly(1) / square(m)) * polynomial(x)) + Exactly(1);
  }

 private:
  Exactly powered(const Exactly& sine2) const {
    const Exactly s = cut(sine2, 0, 1);
    const auto at = [&](double x) {
      return x > 1e-280 ? exp(power_ * log(Exactly::of(x, x))) : Exactly::of(0, 1e-100);
    };
    return hull(at(s.lo), at(s.hi));
  }
  // The slope is unknown if the sine may be 0.
  template <int N>
  Dual<Exactly, N> powered(const Dual<Exactly, N>& sine2) const {
    const Exactly s = cut(sine2.a, 0, 1), value = powered(s);
    if (!(s.lo > 1e-12)) return {value, sine2.v * Exactly::poison()};
    return {value, sine2.v * (power_ * value / s)};
  }
  template <class T>
  T polynomial(const T& x) const {
    T p = x * c_.back() + c_[c_.size() - 2];
    for (std::size_t k = c_.size() - 2; k-- > 0;) p = p * x + c_[k];
    return p;
  }

  Exactly power_;  // gamma - 1
  std::array<Exactly, std::size(detail::kStudentMasking)> c_;
};

template <class W>
class StudentCell {
  using Slopes = typename W::Slopes;

 public:
  StudentCell(const FacetView& view, const Exactly& gamma)
      : gamma_(gamma),
        area_(gamma),
        seen_(area_.seen(view.turn.cosines<Slopes>(2), view.turn.sines<Slopes>(2))),
        anywhere_(cut(area_.seen(view.turn.cosine, view.turn.sine), view.turn.cosine.lo, 1e300)) {}

  Exactly scale() const { return Exactly(2) * (gamma_ - Exactly(1)) * steepness(); }
  Height height(const Bounds& step) const {
    const auto at = [&](double t) {
      return t > 1e-280 ? exp(log(Exactly::of(t, t)) * steepness()) : Exactly::of(0, 1e-15);
    };
    const Exactly z = cut(hull(at(step.lo), at(step.hi)), 0, 1);
    if (!(step.lo > 1e-280)) return {z, Exactly::poison()};
    return {z, z * steepness() / Exactly::of(step.lo, step.hi)};
  }

  std::optional<Slopes> smooth(const FacetCell<W, Slopes>& n) const {
    if (!(n.rho.a.lo > 1e-9)) return std::nullopt;
    return n.facing / (n.cos_view * area_.over_cosine(n.stretched(n.rho)) + seen_);
  }
  Exactly anywhere(const FacetCell<W, Exactly>& n) const {
    if (n.rho.hi <= 0) return Exactly();
    Exactly hidden = Exactly::of(n.cos_view.lo, 1e300);  // c B; B is at least 1
    if (n.rho.lo > 1e-9) {
      const Exactly m = cut(n.stretched(n.rho), 1, 1e300);
      hidden = cut(n.cos_view * area_.over_cosine(m), n.cos_view.lo, 1e300);
    }
    return cut(n.facing, 0, 1.01) / (anywhere_ + hidden);
  }

 private:
  Exactly steepness() const { return Exactly(1) / (gamma_ * Exactly(2) - Exactly(3)); }

  Exactly gamma_;
  StudentArea area_;
  Slopes seen_;
  Exactly anywhere_;
};

}  // namespace brdf::prove
