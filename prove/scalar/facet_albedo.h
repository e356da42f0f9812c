// The directional albedo of isotropic facets at given parameters, enclosed over whole ranges of the view's angle.
//
// Stretched by the width, facets of every width are those of width 1 (Heitz 2014, section 5.3): with v the stretched view, of
// cosine c to the normal, and N the stretched normal of a facet, on the hemisphere,
//   E = 2/pi int (v.N) F rho/(rho + c l/k) dN                      GGX with Smith's height-correlated masking,
//   E = 1/pi int W(N_z) min((v.N)/c, 2 N_z, 2 N_z rho/c) F dN     Beckmann with Torrance and Sparrow's cavities,
// over normals for which the mirrored direction is above the horizon, rho > 0, where k is the length of v before it was made
// a unit vector, in unstretched directions: k = alpha/sqrt(s^2 + alpha^2 c^2), |M|^2 = alpha^2 + (1 - alpha^2) N_z^2,
// rho = cos_o/k = 2 (v.N) N_z/|M|^2 - c, cos_d = (v.N) k/|M|, l^2 = alpha^2 + (1 - alpha^2) cos_o^2, and W(z) = exp(1 - 1/z^2)/z^4.
// Nothing is 0/0 at grazing. N is (r cos phi, r sin phi, z), dN = dz dphi, z in [0, 1] and phi in [0, pi] twice; v is (s, 0, c).
#pragma once

#include <functional>
#include <optional>

#include "brdf/dual.h"
#include "prove/scalar/on_box.h"

namespace brdf::prove {

// In three variables: z, phi, and the turn of v from the normal (circle, on_box.h).
using Exactly = Interval<double>;
using Slopes = Dual<Exactly, 3>;

// A point or a range of normals and views, with what follows from each variable alone.
struct FacetRange {
  Bounds z, phi;  // phi in [0, pi/2], and
  bool second;    // pi/2 further on
  Bounds turn;
};

// What a cell of normals holds for views in a range.
template <class T>
struct FacetCell {
  T cos_view, sin_view;
  T up;        // N_z
  T facing;    // v.N
  T length2;   // |M|^2
  T stretch2;  // (alpha/k)^2 = s^2 + alpha^2 c^2
  T rho;
  Exactly alpha2;

  FacetCell(const FacetRange& at, double alpha) : FacetCell(at, square(Exactly(alpha)), Views(at.turn)) {}
  T cos_d() const { return facing / math::sqrt(length2 * stretch2 * (Exactly(1) / alpha2)); }

 private:
  struct Views {
    Exactly cosine, sine, speed;  // of the angle with its turn
    explicit Views(Bounds turn) {
      circle(turn, cosine, sine);
      const Exactly t = Exactly::of(turn.lo, turn.hi);
      speed = Exactly(1) / (square(Exactly(1) - t) + square(t));
    }
  };
  static T of(const Exactly& value, const Exactly& slope, std::size_t variable) {
    if constexpr (std::is_same_v<T, Exactly>) {
      return value;
    } else {
      T x = T::variable(value, variable);
      x.v.d[variable] = slope;
      return x;
    }
  }
  static T across(const Bounds& z) {  // r
    const Exactly r = Exactly::of(std::max(0.0, root(1 - z.hi, 1 + z.hi).lo), root(1 - z.lo, 1 + z.lo).hi);
    if constexpr (std::is_same_v<T, Exactly>)
      return r;
    else
      return of(r, -(Exactly::of(z.lo, z.hi) / r), 0);
  }
  static Exactly root(double a, double b) { return sqrt(Exactly::of(a, a) * Exactly::of(b, b)); }
  static T along(const FacetRange& at) {  // cos phi
    const Bounds first = cos_at(at.phi.lo), last = cos_at(at.phi.hi), low = sin_at(at.phi.lo),
                 high = sin_at(at.phi.hi);
    const Exactly cosine = Exactly::of(std::max(last.lo, -1e-15), first.hi),
                  sine = Exactly::of(low.lo, high.hi);
    return at.second ? of(-sine, -cosine, 1) : of(cosine, -sine, 1);
  }

  FacetCell(const FacetRange& at, const Exactly& a2, const Views& v)
      : cos_view(of(v.cosine, -(v.sine * v.speed), 2)),
        sin_view(of(v.sine, v.cosine * v.speed, 2)),
        up(of(Exactly::of(at.z.lo, at.z.hi), Exactly(1), 0)),
        facing(sin_view * across(at.z) * along(at) + cos_view * up),
        length2(square(up) * (Exactly(1) - a2) + a2),
        stretch2(square(sin_view) + square(cos_view) * a2),
        rho(facing * (up / length2) * Exactly(2) - cos_view),
        alpha2(a2) {}
};

// The masked weight of a cell's normals beside F and the measure, 0 <= it; nothing where it is not smooth there.
struct GgxSmithCell {
  static constexpr double kScale = 4;  // of 1/pi, with both signs of phi

  static std::optional<Slopes> smooth(const FacetCell<Slopes>& n) {
    if (!(n.rho.a.lo > 1e-9)) return std::nullopt;
    return n.facing / (masked(n, n.rho) + Exactly(1));
  }
  static Exactly anywhere(const FacetCell<Exactly>& n) {
    if (n.rho.hi <= 0) return Exactly();
    // Increasing in rho.
    const auto lit = [&](double rho) {
      return rho > 1e-9 ? Exactly(1) / (Exactly(1) + masked(n, Exactly::of(rho, rho))) : Exactly();
    };
    return cut(n.facing, 0, 1.01) * Exactly::of(lit(n.rho.lo).lo, n.rho.hi > 1e-9 ? lit(n.rho.hi).hi : 1);
  }

 private:
  // c l/(k rho)
  template <class T>
  static T masked(const FacetCell<T>& n, const T& rho) {
    return n.cos_view * math::sqrt(n.stretch2 / square(rho) + (Exactly(1) - n.alpha2));
  }
};

struct BeckmannCavityCell {
  static constexpr double kScale = 2;

  static std::optional<Slopes> smooth(const FacetCell<Slopes>& n) {
    if (!(n.rho.a.lo > 1e-9 && n.up.a.lo > 0.05)) return std::nullopt;
    const Slopes two = n.up * Exactly(2), blocked = two * n.rho, open = two * n.cos_view;  // times c
    const auto least = [](const Slopes& x, const Slopes& y, const Slopes& z) {
      return x.a.hi < y.a.lo && x.a.hi < z.a.lo;
    };
    const Slopes weight{density(n.up.a), n.up.v * slope(n.up.a)};
    if (least(open, n.facing, blocked)) return weight * two;
    if (!(n.cos_view.a.lo > 1e-9)) return std::nullopt;
    if (least(n.facing, open, blocked)) return weight * (n.facing / n.cos_view);
    if (least(blocked, open, n.facing)) return weight * (blocked / n.cos_view);
    return std::nullopt;
  }
  static Exactly anywhere(const FacetCell<Exactly>& n) {
    if (n.rho.hi <= 0 || n.up.hi <= 0) return Exactly();
    const Exactly up = cut(n.up, 0, 1.01), rho = cut(n.rho, 0, 1e300), facing = cut(n.facing, 0, 1.01);
    const Exactly two = Exactly(2) * up;
    const Exactly other = smaller(facing, two * rho);  // over c
    const double low = std::min(two.lo, over(other.lo, std::max(n.cos_view.hi, 1e-9)).lo);
    const double high = n.cos_view.lo > 1e-9 ? std::min(two.hi, over(other.hi, n.cos_view.lo).hi) : two.hi;
    return density(up) * Exactly::of(low, high);
  }

 private:
  static Exactly over(double x, double y) { return Exactly::of(x, x) / Exactly::of(y, y); }
  // W: increasing to z^2 = 1/2, where it is 4/e, then decreasing.
  static Exactly density_at(double z) {
    if (z <= 0.04) return Exactly::of(0, 1e-200);  // e^-624 * 390625 is less
    const Exactly z2 = square(Exactly::of(z, z));
    return exp(Exactly(1) - Exactly(1) / z2) / square(z2);
  }
  static Exactly density(const Exactly& z) {
    Exactly w = hull(density_at(z.lo), density_at(z.hi));
    if (z.lo <= 0.70711 && z.hi >= 0.70710) w = hull(w, Exactly::of(1.4715, 1.4716));
    return w;
  }
  static Exactly slope(const Exactly& z) {
    const Exactly z2 = square(z);
    return density(z) * (Exactly(2) - Exactly(4) * z2) / (z2 * z);
  }
};

// One cell's part of the integral, over turns in its range: base + (turn - its middle) slope.
struct FacetPart {
  Exactly base, slope;
  double width = 0;
};
// Cells of (z, phi), cut where they know least, until all together know the integral to `accuracy` or are 6/accuracy.
Bounds integrate_cells(const std::function<FacetPart(const FacetRange&)>& part, Bounds turn, double accuracy);

// F of a dielectric of relative index eta >= 1, of exact terms as fresnel_dielectric has them; eta = 1: 0.
template <class T>
T dielectric_at(double eta, const T& c) {
  const Exactly step = (Exactly(eta) - Exactly(1)) * (Exactly(eta) + Exactly(1));
  const T sum = math::sqrt(square(c) + step) + c, difference = step / sum, s = difference / sum;
  const T p = (c * sum - Exactly(1)) / (c * difference + Exactly(1));
  return square(s) * (square(p) + Exactly(1)) * Exactly(0.5);
}
// (1 - c)^5
template <class T>
T schlick_at(const T& c) {
  const T x = Exactly(1) - c;
  return square(square(x)) * x;
}

// The facets' albedo with the reflectance F(cos_d) over views of this range of turns, 0 to 1.
template <class Cell, class Fresnel>
Bounds facet_albedo(double alpha, const Fresnel& fresnel, Bounds turn, double accuracy) {
  const auto point = [](double x) { return Exactly::of(x, x); };
  const auto middle = [](Bounds b) {
    const double m = b.lo + 0.5 * (b.hi - b.lo);
    return Bounds{m, m};
  };
  const double half = std::max(middle(turn).lo - turn.lo, turn.hi - middle(turn).lo);
  const auto anywhere = [&](const FacetRange& at) {
    const FacetCell<Exactly> n(at, alpha);
    const Exactly lit = Cell::anywhere(n);
    return lit.is(0) ? lit : lit * cut(fresnel(cut(n.cos_d(), 0, 1)), 0, 1e300);
  };
  // Beside its value in the middle, a function with a slope between l and h has a mean within (h - l)/8 of the width; the
  // middle is rounded.
  const auto rest = [&](const Exactly& slope, const Exactly& size) {
    const Exactly r =
        (point(slope.hi) - point(slope.lo)) * size * Exactly(0.125) + point(slope.magnitude() * 1e-15);
    return Exactly::of(-r.hi, r.hi);
  };
  const auto part = [&](const FacetRange& at) {
    const Exactly tall = point(at.z.hi) - point(at.z.lo), wide = point(at.phi.hi) - point(at.phi.lo),
                  area = tall * wide;
    FacetPart found{anywhere(at) * area, Exactly(), 0};
    found.width = found.base.hi - found.base.lo;
    if (found.width == 0) return found;
    const FacetCell<Slopes> n(at, alpha);
    const std::optional<Slopes> lit = Cell::smooth(n);
    if (!lit) return found;
    const Slopes j = *lit * fresnel(n.cos_d());
    const Exactly centre = anywhere({middle(at.z), middle(at.phi), at.second, middle(turn)});
    const Exactly base = area * (centre + rest(j.v.d[0], tall) + rest(j.v.d[1], wide)),
                  slope = area * j.v.d[2];
    if (base.poisoned() || slope.poisoned()) return found;
    const double width = base.hi - base.lo;
    if (width + 2 * half * slope.magnitude() < found.width) found = {base, slope, width};
    return found;
  };
  const Bounds sum = integrate_cells(part, turn, accuracy);
  const Exactly scale = Exactly(Cell::kScale) / Exactly::of(kPiBounds.lo, kPiBounds.hi);
  // The last cells reach a unit beyond pi/2.
  const Exactly albedo = scale * Exactly::of(std::max(sum.lo - 1e-14, 0.0), sum.hi);
  return {albedo.lo, albedo.hi};
}

}  // namespace brdf::prove
