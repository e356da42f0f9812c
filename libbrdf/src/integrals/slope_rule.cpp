// The slope rule integrates over the slopes (p, q) of the half vector (p, q, 1). A lobe of the half vector
// lies at the origin. The directions above the horizon fill the disc around (o_x, o_y)/o_z with radius 1/o_z.
//
// The outer variable p is the axis of the smaller width. At fixed p the poles of a lobe are at
// q = +-i width_q sqrt(1 + (p/width_p)^2), afterwards at p = +-i width_p. Smith's root lies within one width
// of the horizon. Another near pole of the outer integrand lies at the crossing of the horizon's circle with
// the ridge q = 0. Each of these points is the end of a panel and is mapped by sinh with its scale.
#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/clones.h"
#include "brdf/geometry.h"
#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/functions.h"
#include "libbrdf/src/integrals/integrand.h"
#include "libbrdf/src/integrals/v_cavity.h"

namespace brdf::integrals {
namespace {

struct End {
  double at, scale;
  bool root;
};

class SlopeRule {
 public:
  SlopeRule(const Integrand& integrand, const FixedDirection& fixed, int n)
      : features_(integrand.features()),
        swapped_(features_.width_y < features_.width_x),
        wp_(std::min(features_.width_x, features_.width_y)),
        wq_(std::max(features_.width_x, features_.width_y)),
        oz_(std::max(integrals::sin(fixed.elevation), kMinCosine<double>)),
        rule_(gauss_legendre(n)),
        sum_(integrand, direction_of(fixed)) {
    const Vec3<double> o = direction_of(fixed);
    ox_ = swapped_ ? o.y : o.x;
    oy_ = swapped_ ? o.x : o.y;
  }

  Sums run() {
    const std::vector<End> ends = outer_ends();
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      segment(ends[k], ends[k + 1], [&](double p, double, double, double weight) { row(p, weight); });
    add_nodes();
    return {sum_.sums(), sum_.evaluations(), longest_};
  }

 private:
  static Vec3<double> direction_of(const FixedDirection& d) {
    const double s = integrals::cos(d.elevation);
    return {s * integrals::cos(d.phi), s * integrals::sin(d.phi), integrals::sin(d.elevation)};
  }

  // Calls visit(x, x - low, high - x, weight). The distances are computed without cancellation.
  template <class Visit>
  void segment(const End& low, const End& high, Visit&& visit) {
    const double length = high.at - low.at, half = length / 2;
    if (!(length > 0)) return;
    const double at_low = graded_panel(rule_, half, low.scale, low.root,
                                       [&](double d, double w) { visit(low.at + d, d, length - d, w); });
    const double at_high = graded_panel(rule_, half, high.scale, high.root,
                                        [&](double d, double w) { visit(high.at - d, length - d, d, w); });
    longest_ = std::max({longest_, at_low, at_high});
  }

  // Returns the width of the lobe along q at this p, limited to the scale on which the half vector itself
  // varies.
  double ridge_width(double p) const {
    return std::min(wq_ * std::sqrt(1 + square(p / wp_)), std::sqrt(1 + p * p));
  }

  // Returns the cosine on which masking varies at the horizon, for the moving direction with slopes (p, q).
  double horizon_cosine(double p, double q) const {
    const double scale = 2 * (oz_ + ox_ * p + oy_ * q) / (1 + p * p + q * q);
    const double x = scale * p - ox_, y = scale * q - oy_;
    const double width = std::sqrt(square(wp_ * x) + square(wq_ * y));
    return std::max(oz_ < kGrazing ? width : std::min(width, oz_), 1e-14);
  }

  std::vector<End> outer_ends() {
    std::vector<End> ends = disc_ends();
    if (!features_.compact) return ends;
    const double reach = kReach * wp_;
    std::erase_if(ends, [&](const End& end) { return std::abs(end.at) >= reach; });
    // The integrand is negligible beyond the reach; the new ends have no feature of their own.
    const auto insert = [&](double p) {
      if (p > disc_low_ && p < disc_high_) ends.push_back({p, 1e300, false});
    };
    insert(-reach);
    insert(reach);
    return sorted(std::move(ends));
  }

  // At one end an integrand cannot vary more slowly than the distance to the pole of another end.
  void limit_scales(std::vector<End>& ends) {
    limited_.clear();
    for (const End& end : ends) {
      double scale = end.scale;
      for (const End& other : ends) scale = std::min(scale, integrals::hypot(end.at - other.at, other.scale));
      limited_.push_back(scale);
    }
    for (std::size_t k = 0; k < ends.size(); ++k) ends[k].scale = limited_[k];
  }

  static std::vector<End> sorted(std::vector<End> ends) {
    std::ranges::sort(ends, {}, &End::at);
    return ends;
  }

  std::vector<End> disc_ends() {
    // The extent of the disc. Each root is computed by the stable one of its two formulas.
    const double across = oy_ * oy_ + oz_ * oz_;
    const double p_low = ox_ <= 0 ? -(1 - ox_) / oz_ : -(across / (1 + ox_)) / oz_;
    const double p_high = ox_ >= 0 ? (1 + ox_) / oz_ : (across / (1 - ox_)) / oz_;
    disc_low_ = p_low;
    disc_high_ = p_high;
    std::vector<End> ends{{p_low, edge_scale(p_low), true}, {0, wp_, false}};
    const double along = integrals::hypot(ox_, oz_);
    for (const double sign : {-1.0, 1.0}) {
      // The circle crosses q = 0 at the roots of o_z (p^2 - 1) - 2 o_x p.
      const double p = ox_ * sign >= 0 ? (ox_ + sign * along) / oz_ : -oz_ / (ox_ - sign * along);
      if (p > p_low && p < p_high) {
        const double steepness = std::abs(oy_) / along;
        ends.push_back({p, std::max(ridge_width(p) * steepness, 1e-14 * (1 + std::abs(p))), false});
      }
    }
    if (features_.kink == Kink::v_cavity) add_v_cavity_ends(p_low, p_high, ends);
    ends.push_back({p_high, edge_scale(p_high), true});
    limit_scales(ends);
    return sorted(std::move(ends));
  }

  // The kinks of a row appear and vanish at breaks, as a square root of the distance. A crossing affects
  // the range in p that the curve of the kink covers while q passes the ridge. If a crossing is close to a
  // break (the curve turns back at the ridge) both become one end.
  void add_v_cavity_ends(double p_low, double p_high, std::vector<End>& ends) const {
    const std::size_t first = ends.size();
    for (const double p : v_cavity_breaks(ox_, oy_, oz_, p_low, p_high)) ends.push_back({p, 1e300, true});
    const std::size_t last = ends.size();
    for (const Crossing& c : v_cavity_crossings(ox_, oy_, oz_)) {
      if (!(c.p > p_low && c.p < p_high)) continue;
      const double ridge = ridge_width(c.p);
      const double scale =
          std::max(ridge * (c.steepness + ridge * c.curvature / 2), 1e-14 * (1 + std::abs(c.p)));
      bool merged = false;
      for (std::size_t k = first; k < last; ++k) {
        if (std::abs(ends[k].at - c.p) > 0.1 * scale) continue;
        ends[k].scale = std::min(ends[k].scale, scale);
        merged = true;
      }
      if (!merged) ends.push_back({c.p, scale, false});
    }
  }

  // At the left and right ends of the disc the length of a row is proportional to the square root of the
  // distance d.
  double edge_scale(double p) const {
    const double q = oy_ / oz_;
    const double lobe = (square(ridge_width(p)) + q * q) * oz_ / 2;
    const double horizon = horizon_cosine(p, q) * (1 + p * p + q * q) / 2;
    return std::min(lobe, horizon);
  }

  void row(double p, double weight) {
    // Roots of o_z q^2 - 2 o_y q + o_z (p^2 - 1) - 2 o_x p.
    const double c = oz_ * (p * p - 1) - 2 * ox_ * p;
    const double discriminant = oy_ * oy_ - oz_ * c;
    if (!(discriminant > 0)) return;
    const double t = oy_ + std::copysign(std::sqrt(discriminant), oy_);
    double q_low = t / oz_, q_high = c / t;
    if (q_high < q_low) std::swap(q_low, q_high);
    const double length = q_high - q_low, ridge = ridge_width(p);
    double from = q_low, to = q_high;
    if (features_.compact) {
      const double reach = wq_ * std::sqrt(std::max(square(kReach) - square(p / wp_), 0.0));
      from = std::max(from, -reach);
      to = std::min(to, reach);
      if (!(from < to)) return;
    }
    const auto end_at = [&](double q) {
      if (q != q_low && q != q_high) return End{q, 1e300, false};
      const double slope = oz_ * length / (1 + p * p + q * q);  // of the moving cosine, at the horizon
      double scale = std::max(horizon_cosine(p, q) / slope, 1e-14 * length);
      // If the ridge lies outside, the integrand varies on the distance to the ridge at the fastest.
      if (from > 0 || to < 0) scale = std::min(scale, integrals::hypot(q, ridge));
      return End{q, scale, features_.root_at_horizon};
    };
    std::vector<End>& ends = row_ends_;
    ends.assign({end_at(from)});
    if (from < 0 && to > 0) ends.push_back({0, ridge, false});
    if (features_.kink == Kink::v_cavity)
      for (const double q : v_cavity_kinks(ox_, oy_, oz_, p, from, to)) ends.push_back({q, 1e300, false});
    ends.push_back(end_at(to));
    if (ends.size() > 3) ends = sorted(std::move(ends));
    limit_scales(ends);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double before = ends[k].at - q_low, after = q_high - ends[k + 1].at;
      segment(ends[k], ends[k + 1], [&](double q, double from_low, double to_high, double w) {
        node(p, q, before + from_low, after + to_high, w * weight);
      });
    }
  }

  void node(double p, double q, double from_low, double to_high, double weight) {
    nodes_.p[used_] = p;
    nodes_.q[used_] = q;
    nodes_.from_low[used_] = from_low;
    nodes_.to_high[used_] = to_high;
    nodes_.weight[used_] = weight;
    if (++used_ == kBlock) add_nodes();
  }

  // The moving direction is the fixed direction mirrored at the half vector. Its solid angle is 4 o.h times
  // that of h.
  void add_nodes() {
    if (used_ == 0) return;
    const auto body = [n = &nodes_, ox = ox_, oy = oy_, oz = oz_](std::size_t k) {
      const double p = n->p[k], q = n->q[k];
      const double hz2 = 1 / (1 + p * p + q * q);
      const double oh = oz + ox * p + oy * q;  // divided by h_z
      const double scale = 2 * hz2 * oh;
      n->x[k] = scale * p - ox;
      n->y[k] = scale * q - oy;
      n->z[k] = oz * hz2 * n->from_low[k] * n->to_high[k];
      n->weight[k] = n->weight[k] * 4 * oh * hz2 * hz2;
    };
    repeat(body, used_);
    const double *x = nodes_.x.data(), *y = nodes_.y.data();
    sum_.add(used_, swapped_ ? y : x, swapped_ ? x : y, nodes_.z.data(), nodes_.weight.data());
    used_ = 0;
  }

  static constexpr std::size_t kBlock = Integrand::kBlock;
  struct Nodes {
    std::array<double, kBlock> p, q, from_low, to_high, weight, x, y, z;
  };

  const Features features_;
  const bool swapped_;
  const double wp_, wq_, oz_;
  double ox_ = 0, oy_ = 0, disc_low_ = 0, disc_high_ = 0;
  double longest_ = 0;  // length of the longest panel, in e-folds
  const GaussRule& rule_;
  NodeSum sum_;
  std::vector<End> row_ends_;
  std::vector<double> limited_;
  Nodes nodes_;
  std::size_t used_ = 0;
};

}  // namespace

Sums slope_rule(const Integrand& integrand, const FixedDirection& fixed, int n) {
  return SlopeRule(integrand, fixed, n).run();
}

}  // namespace brdf::integrals
