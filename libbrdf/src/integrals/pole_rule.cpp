// The pole rule: polar angle and azimuth about the mirror direction, with phi = 0 in the mirror plane.
//
// With D = theta - theta_o, the denominator of a lobe of width a is d + 4 sin sin_o sin^2(phi/2),
// d = 4 cos^2((theta + theta_o)/2) (sin^2(D/2) + a^2 cos^2(D/2)). Its poles are at phi = +-i eta and at
// tan(D/2) = +-i a. Smith's root lies at tan(elevation) = +-i a. d and the correlated denominator also
// vanish at theta = pi - theta_o. A map x = scale sinh(s) moves a pole at +-i scale to s = +-i pi/2.
#include <algorithm>
#include <cmath>

#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/functions.h"
#include "libbrdf/src/integrals/integrand.h"
#include "libbrdf/src/integrals/rows.h"

namespace brdf::integrals {
namespace {

// A point of the outer integral, with the difference from the fixed polar angle. The maps about the mirror
// direction compute the difference without cancellation.
struct Polar {
  double elevation, delta;
};

// The kink of a row, given by the cosine of its azimuth in (0, pi).
struct RowKink {
  double cosine;  // of the azimuth; outside (-1, 1) if this row has no kink
  bool present() const { return cosine > -1 && cosine < 1; }
};

RowKink row_kink(Kink kind, double sin_i, double cos_i, double sin_o, double cos_o) {
  const double ss = std::max(sin_i * sin_o, 1e-300);
  switch (kind) {
    case Kink::azimuth:
      return {0};
    case Kink::mirror_edge:
      return {-cos_i * cos_o / ss};
    case Kink::v_cavity:  // |h|^2 = 4 h_z min(cos): the edge of G = 1
      return {(1 + cos_i * cos_o - 2 * (cos_i + cos_o) * std::min(cos_i, cos_o)) / ss};
    case Kink::none:
    case Kink::unplaced:
      break;
  }
  return {2};
}

class PoleRule {
 public:
  PoleRule(const Integrand& integrand, const FixedDirection& fixed, int n)
      : features_(integrand.features()),
        a_(features_.width_x),
        e_o_(std::max(fixed.elevation, 0.0)),
        sin_o_(integrals::cos(e_o_)),
        cos_o_(integrals::sin(e_o_)),
        rule_(gauss_legendre(n)),
        sum_(integrand, {-sin_o_, 0, cos_o_}) {}

  Sums run() {
    const double theta_o = kPi / 2 - e_o_;
    const bool limit = e_o_ < kGrazing;
    // No part of a compact lobe is farther from theta_o than this.
    const double reach = features_.compact ? 2 * integrals::atan(kReach * a_) : kPi;
    // From the normal to theta_o.
    const double b = limit ? a_ : std::min(a_, integrals::tan(e_o_));
    const bool root = limit && features_.kink == Kink::mirror_edge;  // the row behaves like sin^n
    outer(-integrals::asinh(integrals::tan(std::min(theta_o, reach) / 2) / b), 0, root,
          [&](double s, double& jacobian) { return from_mirror(b, s, jacobian); });
    if (limit) return {sum_.sums(), sum_.evaluations()};
    // From theta_o half way to the horizon, and from the horizon up to the same point.
    outer(0, integrals::asinh(integrals::tan(std::min(e_o_ / 2, reach) / 2) / a_), false,
          [&](double s, double& jacobian) { return from_mirror(a_, s, jacobian); });
    const double lowest = std::max(e_o_ - reach, 0.0);
    outer(integrals::asinh(integrals::tan(lowest) / a_), integrals::asinh(integrals::tan(e_o_ / 2) / a_),
          features_.root_at_horizon && lowest == 0, [&](double s, double& jacobian) {
            const double t = a_ * integrals::sinh(s);
            jacobian = a_ * integrals::cosh(s) / (1 + t * t);
            const double e = integrals::atan(t);
            return Polar{e, e_o_ - e};
          });
    return {sum_.sums(), sum_.evaluations()};
  }

 private:
  Polar from_mirror(double scale, double s, double& jacobian) const {
    const double t = scale * integrals::sinh(s);
    jacobian = 2 * scale * integrals::cosh(s) / (1 + t * t);
    const double delta = 2 * integrals::atan(t);
    return {e_o_ - delta, delta};
  }

  // Integrates over s in [low, high], split at the points at which the kinks of the rows appear or vanish.
  template <class Map>
  void outer(double low, double high, bool root_low, Map&& map) {
    if (!(high > low)) return;
    std::vector<double> breaks{low};
    if (features_.kink == Kink::mirror_edge || features_.kink == Kink::v_cavity)
      add_breaks(low, high, map, breaks);
    breaks.push_back(high);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const double s0 = breaks[k], length = breaks[k + 1] - s0;
      const bool at_low = k == 0 ? root_low : true, at_high = k + 2 < breaks.size();
      for (std::size_t j = 0; j < rule_.node.size(); ++j) {
        const UnitNode node = unit_node(rule_, j, at_low, at_high);
        double jacobian;
        const Polar p = map(s0 + length * node.v, jacobian);
        row(p, node.weight * length * jacobian);
      }
    }
  }

  // Finds the points at which the azimuth of the kink reaches 0 or pi. These are sign changes of
  // cosine -+ 1, which are bracketed on a grid and bisected.
  template <class Map>
  void add_breaks(double low, double high, Map&& map, std::vector<double>& breaks) const {
    const auto excess = [&](double s, double target) {
      double jacobian;
      const Polar p = map(s, jacobian);
      const double sin_i = integrals::cos(p.elevation), cos_i = integrals::sin(p.elevation);
      return row_kink(features_.kink, sin_i, cos_i, sin_o_, cos_o_).cosine - target;
    };
    constexpr int kGrid = 128;
    for (const double target : {-1.0, 1.0}) {
      double left = low, value = excess(low, target);
      for (int k = 1; k <= kGrid; ++k) {
        const double right = low + (high - low) * k / kGrid, next = excess(right, target);
        if ((value < 0) != (next < 0)) breaks.push_back(bisect(left, right, value < 0, excess, target));
        left = right;
        value = next;
      }
    }
    std::ranges::sort(breaks);
  }

  template <class Excess>
  static double bisect(double left, double right, bool negative_left, Excess&& excess, double target) {
    for (int step = 0; step < 60; ++step) {
      const double middle = (left + right) / 2;
      if ((excess(middle, target) < 0) == negative_left)
        left = middle;
      else
        right = middle;
    }
    return (left + right) / 2;
  }

  void row(const Polar& p, double weight) {
    const double sin_i = integrals::cos(p.elevation), cos_i = integrals::sin(p.elevation);
    const double sd = integrals::sin(p.delta / 2), cd = integrals::cos(p.delta / 2);
    const double tilt = features_.mirror_lobe ? 1 : integrals::sin((p.elevation + e_o_) / 2);
    const double d = 4 * square(tilt) * (sd * sd + a_ * a_ * cd * cd);
    const double ratio = std::sqrt(d / std::max(4 * sin_i * sin_o_, 1e-300));
    const double eta =
        std::min(2 * integrals::asinh(ratio), 1e6);  // theta_o = 0: all azimuths are equivalent
    double s_end = integrals::asinh(kPi / eta);
    if (features_.compact) {  // the exponent is t^2 + (1 + t^2)(phi/eta)^2, t = tan(D/2)/a
      const double steepness = 1 + square(sd / (a_ * cd));
      s_end = std::min(s_end, integrals::asinh(std::sqrt((kReach * kReach + 1) / steepness)));
    }
    const RowKink kink = row_kink(features_.kink, sin_i, cos_i, sin_o_, cos_o_);
    const double s_kink =
        kink.present() ? std::min(integrals::asinh(integrals::acos(kink.cosine) / eta), s_end) : s_end;
    // The row is even in phi; twice the integral over [0, pi].
    panel(0, s_kink, eta, sin_i, cos_i, 2 * weight * sin_i);
    if (s_kink < s_end) panel(s_kink, s_end, eta, sin_i, cos_i, 2 * weight * sin_i);
  }

  void panel(double s0, double s1, double eta, double sin_i, double cos_i, double weight) {
    // At the edge of a cosine lobe x^n is not a polynomial. Five more powers make it nearly one.
    const bool edge = features_.kink == Kink::mirror_edge;
    std::array<double, kRow> s, w, sinh, cosh, phi, sine, cosine;
    for (std::size_t first = 0; first < rule_.node.size(); first += kRow) {
      const std::size_t count = std::min(kRow, rule_.node.size() - first);
      for (std::size_t k = 0; k < count; ++k) {
        const double u = 1 - rule_.node[first + k], lower = edge ? square(square(u)) * u : 1;
        s[k] = s1 - (s1 - s0) * u * lower;
        w[k] = weight * rule_.weight[first + k] * (edge ? 6 : 1) * lower * (s1 - s0) * eta;
      }
      sinh_cosh(count, s.data(), sinh.data(), cosh.data());
      for (std::size_t k = 0; k < count; ++k) phi[k] = eta * sinh[k];
      sin_cos(count, phi.data(), sine.data(), cosine.data());
      for (std::size_t k = 0; k < count; ++k)
        sum_.add(sin_i * cosine[k], sin_i * sine[k], cos_i, w[k] * cosh[k]);
    }
  }

  const Features features_;
  const double a_, e_o_, sin_o_, cos_o_;
  const GaussRule& rule_;
  NodeSum sum_;
};

}  // namespace

Sums pole_rule(const Integrand& integrand, const FixedDirection& fixed, int n) {
  return PoleRule(integrand, fixed, n).run();
}

}  // namespace brdf::integrals
