// The slope distributions and maskings with enclosed albedos (facet_albedo.h), and the reflectance of
// facets.
#pragma once

#include "prove/energy/facet_albedo.h"

namespace brdf::prove {

// The masked weight of a cell's normals without F and the measure; the weight is at least 0. smooth()
// returns std::nullopt if the weight is not smooth in the cell.
template <class W>
struct GgxSmithCell : EvenSteps {
  using Slopes = typename W::Slopes;
  static Exactly scale() { return Exactly(2); }  // times 1/pi
  explicit GgxSmithCell(const FacetView&) {}

  std::optional<Slopes> smooth(const FacetCell<W, Slopes>& n) const {
    if (!(n.rho.a.lo > 1e-9)) return std::nullopt;
    return n.facing / (n.cos_view * n.stretched(n.rho) + Exactly(1));
  }
  Exactly anywhere(const FacetCell<W, Exactly>& n) const {
    if (n.rho.hi <= 0) return Exactly();
    // Increasing in rho.
    const auto lit = [&](double rho) {
      return rho > 1e-9 ? Exactly(1) / (Exactly(1) + n.cos_view * n.stretched(Exactly::of(rho, rho)))
                        : Exactly();
    };
    return cut(n.facing, 0, 1.01) * Exactly::of(lit(n.rho.lo).lo, n.rho.hi > 1e-9 ? lit(n.rho.hi).hi : 1);
  }
};

// W of Beckmann's normals.
struct BeckmannDensity : EvenSteps {
  static Exactly density(const Exactly& z) {
    Exactly w = hull(density_at(z.lo), density_at(z.hi));
    if (z.lo <= 0.70711 && z.hi >= 0.70710) w = hull(w, Exactly::of(1.4715, 1.4716));
    return w;
  }
  // For z above 0.05.
  template <int N>
  static Dual<Exactly, N> density(const Dual<Exactly, N>& z) {
    return {density(z.a), z.v * slope(z.a)};
  }

 private:
  // Increasing up to z^2 = 1/2, where the density is 4/e, then decreasing.
  static Exactly density_at(double z) {
    if (z <= 0.04) return Exactly::of(0, 1e-200);  // e^-624 * 390625 is less
    const Exactly z2 = square(Exactly::of(z, z));
    return exp(Exactly(1) - Exactly(1) / z2) / square(z2);
  }
  static Exactly slope(const Exactly& z) {
    const Exactly z2 = square(z);
    return density(z) * (Exactly(2) - Exactly(4) * z2) / (z2 * z);
  }
};

// Returns whether the mirrored directions of Beckmann's normals are certainly lit and all terms are smooth.
template <class W>
bool smoothly_lit(const FacetCell<W, typename W::Slopes>& n) {
  return n.rho.a.lo > 1e-9 && n.up.a.lo > 0.05;
}
// Encloses x/y.
inline Exactly quotient_at(double x, double y) {
  return Exactly::of(x, x) / Exactly::of(y, y);
}

template <class W>
struct BeckmannCavityCell : BeckmannDensity {
  using Slopes = typename W::Slopes;
  static Exactly scale() { return Exactly(1); }
  explicit BeckmannCavityCell(const FacetView&) {}

  std::optional<Slopes> smooth(const FacetCell<W, Slopes>& n) const {
    if (!smoothly_lit(n)) return std::nullopt;
    const Slopes two = n.up * Exactly(2), blocked = two * n.rho, open = two * n.cos_view;  // times c
    const auto least = [](const Slopes& x, const Slopes& y, const Slopes& z) {
      return x.a.hi < y.a.lo && x.a.hi < z.a.lo;
    };
    const Slopes weight = density(n.up);
    if (least(open, n.facing, blocked)) return weight * two;
    if (!(n.cos_view.a.lo > 1e-9)) return std::nullopt;
    if (least(n.facing, open, blocked)) return weight * (n.facing / n.cos_view);
    if (least(blocked, open, n.facing)) return weight * (blocked / n.cos_view);
    return std::nullopt;
  }
  Exactly anywhere(const FacetCell<W, Exactly>& n) const {
    if (n.rho.hi <= 0 || n.up.hi <= 0) return Exactly();
    const Exactly up = cut(n.up, 0, 1.01), rho = cut(n.rho, 0, 1e300), facing = cut(n.facing, 0, 1.01);
    const Exactly two = Exactly(2) * up;
    const Exactly other = smaller(facing, two * rho);  // over c
    const double low = std::min(two.lo, quotient_at(other.lo, std::max(n.cos_view.hi, 1e-9)).lo);
    const double high =
        n.cos_view.lo > 1e-9 ? std::min(two.hi, quotient_at(other.hi, n.cos_view.lo).hi) : two.hi;
    return density(up) * Exactly::of(low, high);
  }
};

// H and its slopes by x, -erfc(a)/2, and by y, e^(-a^2)/(2 sqrt(pi)), for x, y >= 0 and a = x/y. All three
// terms decrease in a.
class BeckmannMasking {
 public:
  BeckmannMasking(const Exactly& x, const Exactly& y)
      : x_(x), y_(y), most_(tail(x.lo, y.hi)), least_(tail(x.hi, y.lo)) {}
  static Exactly value_at(double x, double y) { return value_at(x, y, tail(x, y)); }
  Exactly value() const { return hull(value_at(x_.hi, y_.lo, least_), value_at(x_.lo, y_.hi, most_)); }
  // Returns x + H, the visible area of the surface, which increases in both x and y.
  Exactly area() const {
    const auto at = [](double x, double y) { return Exactly::of(x, x) + value_at(x, y); };
    return hull(at(x_.lo, y_.lo), at(x_.hi, y_.hi));
  }
  Exactly by_x() const { return hull(least_.erfc, most_.erfc) * Exactly(-0.5); }
  Exactly by_y() const { return hull(least_.gauss, most_.gauss) * half_over_root_pi(); }
  // Returns the slope by y^2. y may be 0: e^(-x^2/y^2)/y increases while y^2 is below 2 x^2.
  Exactly by_y2() const {
    const Exactly half = Exactly(0.5) * half_over_root_pi();
    if (y_.lo > 1e-9) return half * hull(least_.gauss, most_.gauss) / y_;
    if (!(2 * square(x_.lo) > square(y_.hi) * 1.01) || !(y_.hi > 1e-300)) return Exactly::poison();
    return half * Exactly::of(0, (most_.gauss / Exactly::of(y_.hi, y_.hi)).hi);
  }

 private:
  struct Tail {
    Exactly gauss, erfc;  // e^(-a^2), erfc(a): below 1e-43 beyond 10
  };
  static Tail tail(double x, double y) {
    if (x >= 10 * y) return {Exactly::of(0, 1e-43), Exactly::of(0, 1e-43)};
    const Exactly a = quotient_at(x, y), gauss = exp(-square(a));
    return {gauss, gauss * erfcx(a)};
  }
  static Exactly half_over_root_pi() {
    return Exactly::widened(0.28209479177387814347, 0.28209479177387814347);
  }
  static Exactly value_at(double x, double y, const Tail& t) {
    const Exactly h =
        Exactly::of(y, y) * t.gauss * half_over_root_pi() - Exactly::of(x, x) * t.erfc * Exactly(0.5);
    return cut(h, 0, 1e300);
  }

  Exactly x_, y_;
  Tail most_, least_;
};

template <class W>
class BeckmannSmithCell : public BeckmannDensity {
  using Slopes = typename W::Slopes;

 public:
  static Exactly scale() { return Exactly(1); }
  explicit BeckmannSmithCell(const FacetView& view) : area_(area_of(view)) {}

  std::optional<Slopes> smooth(const FacetCell<W, Slopes>& n) const {
    if (!smoothly_lit(n)) return std::nullopt;
    const Slopes q2 = n.tangent2(n.rho);
    const BeckmannMasking out(n.rho.a, root(q2.a));
    const Slopes hidden{out.value(), n.rho.v * out.by_x() + q2.v * out.by_y2()};
    return density(n.up) * n.facing / (area_ + n.cos_view * hidden / n.rho);
  }
  Exactly anywhere(const FacetCell<W, Exactly>& n) const {
    if (n.rho.hi <= 0 || n.up.hi <= 0) return Exactly();
    const Exactly q = root(n.tangent2(cut(n.rho, 0, 1e300)));
    // Increasing in rho, decreasing in q and in c.
    const auto lit = [](double area, double cosine, double rho, double q_at) {
      const Exactly hidden = BeckmannMasking::value_at(rho, q_at) / Exactly::of(rho, rho);
      return Exactly(1) / (Exactly::of(area, area) + Exactly::of(cosine, cosine) * hidden);
    };
    const Exactly& area = area_.a;
    const double low = n.rho.lo > 1e-9 ? lit(area.hi, n.cos_view.hi, n.rho.lo, q.hi).lo : 0;
    const double high = n.rho.hi > 1e-9 ? lit(area.lo, n.cos_view.lo, n.rho.hi, q.lo).hi
                                        : (Exactly(1) / Exactly::of(area.lo, area.lo)).hi;
    return density(cut(n.up, 0, 1.01)) * cut(n.facing, 0, 1.01) * Exactly::of(low, high);
  }

 private:
  static Slopes area_of(const FacetView& view) {
    const BeckmannMasking m(view.turn.cosine, view.turn.sine);
    const Slopes cosines = view.turn.cosines<Slopes>(2), sines = view.turn.sines<Slopes>(2);
    return {m.area(), cosines.v * (m.by_x() + Exactly(1)) + sines.v * m.by_y()};
  }
  static Exactly root(const Exactly& x) { return sqrt(cut(x, 0, 1e300)); }
  Slopes area_;
};

template <class W>
struct WardBoundedCell : BeckmannDensity {
  using Slopes = typename W::Slopes;
  static Exactly scale() { return Exactly(2); }
  explicit WardBoundedCell(const FacetView&) {}

  std::optional<Slopes> smooth(const FacetCell<W, Slopes>& n) const {
    if (!smoothly_lit(n)) return std::nullopt;
    return density(n.up) * n.up * (n.rho / (n.rho + n.cos_view));
  }
  Exactly anywhere(const FacetCell<W, Exactly>& n) const {
    if (n.rho.hi <= 0 || n.up.hi <= 0) return Exactly();
    const auto ratio = [](double rho, double cosine) {  // increasing in rho, decreasing in c
      return rho > 1e-9 ? Exactly::of(rho, rho) / (Exactly::of(rho, rho) + Exactly::of(cosine, cosine))
                        : Exactly();
    };
    const double low = ratio(n.rho.lo, n.cos_view.hi).lo,
                 high = n.rho.hi > 1e-9 ? std::min(ratio(n.rho.hi, n.cos_view.lo).hi, 1.0) : 1;
    const Exactly up = cut(n.up, 0, 1.01);
    return density(up) * up * Exactly::of(low, high);
  }
};

// Returns F of a dielectric of relative index eta >= 1, with the exact terms of fresnel_dielectric. For eta
// = 1 returns 0.
template <class T>
T dielectric_at(double eta, const T& c) {
  const Exactly step = (Exactly(eta) - Exactly(1)) * (Exactly(eta) + Exactly(1));
  const T sum = math::sqrt(square(c) + step) + c, difference = step / sum, s = difference / sum;
  const T p = (c * sum - Exactly(1)) / (c * difference + Exactly(1));
  return square(s) * (square(p) + Exactly(1)) * Exactly(0.5);
}
// Return the value of a number, without its slopes.
inline const Exactly& value_of(const Exactly& x) {
  return x;
}
template <int N>
const Exactly& value_of(const Dual<Exactly, N>& x) {
  return x.a;
}

// Returns F of a conductor of index n + i k, n and k > 0, with the terms of fresnel_conductor.
template <class T>
T conductor_at(double n, double k, const T& c) {
  const Exactly nk = Exactly(n) * Exactly(k),
                excess = (Exactly(n) - Exactly(1)) * (Exactly(n) + Exactly(1)) - square(Exactly(k));
  const T re = square(c) + excess;
  const Exactly& real = value_of(re);
  const bool metal = real.lo + real.hi < 0;  // both formulas are right; one cancels less
  const T length = math::sqrt(square(re) + Exactly(4) * square(nk));
  const T big = math::sqrt((metal ? length - re : length + re) * Exactly(0.5)), small = nk / big;
  const T a = metal ? small : big, b = metal ? big : small;
  const T sin2 = Exactly(1) - square(c);
  const T s = (square(a - c) + square(b)) / (square(a + c) + square(b));
  const T p = s * ((square(a * c - sin2) + square(b * c)) / (square(a * c + sin2) + square(b * c)));
  return (s + p) * Exactly(0.5);
}
// Returns (1 - c)^5.
template <class T>
T schlick_at(const T& c) {
  const T x = Exactly(1) - c;
  return square(square(x)) * x;
}

}  // namespace brdf::prove
