// Adaptive bisection of cells in (t, phi), with elevation = pi/2 t^2 and phi measured from the mirror
// plane. Each cell is integrated by a product Gauss-Legendre rule. Its error is estimated by rules with
// fewer points. One kind of these (Lobatto) includes the edges and corners of the cell and thereby detects
// a kink that cuts off a part without Gauss nodes. Two rules may agree on a kink by chance; the estimate
// for a half is therefore not allowed to be much better than that of its whole cell. The worst cell is
// halved along its worse direction. The initial cells close in on the lobe according to its widths.
#include <algorithm>
#include <cmath>
#include <queue>

#include "brdf/quadrature.h"
#include "libbrdf/src/integrals/functions.h"
#include "libbrdf/src/integrals/integrand.h"

namespace brdf::integrals {
namespace {

constexpr int kFine = 10, kOpen = 7, kClosed = 8;
// Evaluations per cell.
constexpr long kPerCell = kFine * (kFine + 2 * kOpen + 2 * kClosed) + kClosed * kClosed;
// Upper bound for the number of initial cells, from the evaluations that an integral may use by default.
constexpr std::size_t kMostFirst = std::size_t(AlbedoOptions().max_evaluations / kPerCell);
constexpr double kGain = 4;     // a half may improve on its whole cell by this factor at most
constexpr double kCaution = 8;  // allows for errors common to all rules, such as a lobe's edge in a corner

struct Cell {
  double t0, t1, phi0, phi1;
  std::vector<double> value, error;  // per output
  bool halve_t = true;
  double worst() const { return *std::ranges::max_element(error); }
  bool operator<(const Cell& other) const { return worst() < other.worst(); }
};

class Adaptive {
 public:
  Adaptive(const Integrand& integrand, const FixedDirection& fixed)
      : integrand_(integrand), elevation_(std::max(fixed.elevation, 0.0)), phi_(fixed.phi) {
    const double s = integrals::cos(elevation_);
    fixed_ = {s * integrals::cos(phi_), s * integrals::sin(phi_), integrals::sin(elevation_)};
  }

  std::vector<AlbedoResult> run(double tolerance, long max_evaluations) {
    const std::size_t outputs = integrand_.outputs();
    std::priority_queue<Cell> cells;
    std::vector<double> total = integrand_.constant_outputs(), error(outputs, 0.0);
    const auto insert = [&](Cell cell) {
      for (std::size_t k = 0; k < outputs; ++k) {
        total[k] += cell.value[k];
        error[k] += cell.error[k];
      }
      cells.push(std::move(cell));
    };
    for (Cell& cell : first_cells(kMostFirst)) insert(measure(cell));
    const auto met = [&] {
      for (std::size_t k = 0; k < outputs; ++k)
        if (error[k] > tolerance * std::abs(total[k])) return false;
      return true;
    };
    while (!met() && evaluations_ < max_evaluations) {
      const Cell worst = cells.top();
      cells.pop();
      for (std::size_t k = 0; k < outputs; ++k) {
        total[k] -= worst.value[k];
        error[k] -= worst.error[k];
      }
      Cell low = worst, high = worst;
      if (worst.halve_t)
        low.t1 = high.t0 = (worst.t0 + worst.t1) / 2;
      else
        low.phi1 = high.phi0 = (worst.phi0 + worst.phi1) / 2;
      low = measure(low);
      high = measure(high);
      for (std::size_t k = 0; k < outputs; ++k) {
        const double least = std::abs(low.value[k] + high.value[k] - worst.value[k]) / kGain / 2;
        for (Cell* half : {&low, &high}) half->error[k] = std::max(half->error[k], least);
      }
      insert(std::move(low));
      insert(std::move(high));
    }
    return results(cells, outputs, tolerance);
  }

 private:
  std::vector<AlbedoResult> results(std::priority_queue<Cell>& cells, std::size_t outputs, double tolerance) {
    // Sum again, because the running totals carry the rounding errors of all subtracted terms.
    const std::vector<double> constant = integrand_.constant_outputs();
    std::vector<AlbedoResult> found(outputs);
    for (std::size_t k = 0; k < outputs; ++k) found[k].value = constant[k];
    for (; !cells.empty(); cells.pop())
      for (std::size_t k = 0; k < outputs; ++k) {
        found[k].value += cells.top().value[k];
        found[k].error_bound += cells.top().error[k];
      }
    // The rounding of a single evaluation: many evaluations share elevation and azimuth, and errors do not
    // average out.
    const double rounding = rounding_of(integrand_, {elevation_, phi_}, 1);
    for (AlbedoResult& r : found) {
      r.error_bound += rounding * std::abs(r.value);
      r.evaluations = evaluations_;
      r.converged = !coarse_ && r.error_bound <= tolerance * std::abs(r.value);
      r.rule = Rule::adaptive;
    }
    return found;
  }

  // Returns the half vector of a point, in units of the widths of the lobe (its sines, which are bounded).
  std::array<double, 2> in_widths(double t, double phi) const {
    const double e = kPi / 2 * t * t, s = integrals::cos(e), azimuth = phi_ + kPi + phi;
    const Vec3<double> h =
        Vec3<double>{s * integrals::cos(azimuth), s * integrals::sin(azimuth), integrals::sin(e)} + fixed_;
    const double length = std::sqrt(std::max(dot(h, h), 1e-30));
    return {h.x / length / integrand_.features().width_x, h.y / length / integrand_.features().width_y};
  }

  // Halves a cell until it is small compared with the width of the lobe or with its distance from the lobe.
  // This finds any lobe, however narrow, and also the wide lobe that grazing light contracts. If more than
  // `most` cells are needed the remaining cells stay coarse, and the result is not marked as converged.
  void cover(Cell cell, int depth, std::size_t most, std::vector<Cell>& cells) {
    const double t = (cell.t0 + cell.t1) / 2, phi = (cell.phi0 + cell.phi1) / 2;
    const auto apart = [](const auto& a, const auto& b) {
      return integrals::hypot(a[0] - b[0], a[1] - b[1]);
    };
    const auto centre = in_widths(t, phi);
    const double along_t =
        std::max(apart(centre, in_widths(cell.t0, phi)), apart(centre, in_widths(cell.t1, phi)));
    const double along_phi =
        std::max(apart(centre, in_widths(t, cell.phi0)), apart(centre, in_widths(t, cell.phi1)));
    const double size = along_t + along_phi;
    const double from_lobe = std::max(0.0, integrals::hypot(centre[0], centre[1]) - size);
    const bool small = size < 0.7 + from_lobe / 2, full = cells.size() >= most;
    coarse_ = coarse_ || (full && !small);
    if (depth == 0 || small || full) {
      cells.push_back(cell);
      return;
    }
    Cell low = cell, high = cell;
    if (along_t > along_phi)
      low.t1 = high.t0 = t;
    else
      low.phi1 = high.phi0 = phi;
    cover(low, depth - 1, most, cells);
    cover(high, depth - 1, most, cells);
  }

  std::vector<Cell> first_cells(std::size_t most) {
    const double mirror = std::sqrt(elevation_ * 2 / kPi);
    const bool anisotropic = integrand_.features().anisotropic();
    std::vector<Cell> cells;
    for (const auto& [t0, t1] : {std::pair{0.0, mirror}, std::pair{mirror, 1.0}}) {
      if (!(t1 > t0)) continue;
      cover({t0, t1, 0, kPi, {}, {}}, 60, most, cells);
      if (anisotropic) cover({t0, t1, -kPi, 0, {}, {}}, 60, most, cells);
    }
    return cells;
  }

  std::vector<double> product(const Cell& c, const GaussRule& rule_t, const GaussRule& rule_phi) {
    NodeSum sum(integrand_, fixed_);
    const double twice = integrand_.features().anisotropic() ? 1 : 2;
    for (std::size_t i = 0; i < rule_t.node.size(); ++i) {
      const double t = c.t0 + (c.t1 - c.t0) * rule_t.node[i];
      const double e = kPi / 2 * t * t, s = integrals::cos(e), z = integrals::sin(e);
      const double weight = twice * s * kPi * t * (c.t1 - c.t0) * rule_t.weight[i] * (c.phi1 - c.phi0);
      for (std::size_t j = 0; j < rule_phi.node.size(); ++j) {
        const double phi = phi_ + kPi + c.phi0 + (c.phi1 - c.phi0) * rule_phi.node[j];
        sum.add(s * integrals::cos(phi), s * integrals::sin(phi), z, weight * rule_phi.weight[j]);
      }
    }
    auto columns = sum.sums();
    evaluations_ += sum.evaluations();
    return integrand_.combine_varying(columns);
  }

  Cell measure(Cell cell) {
    const GaussRule &fine = gauss_legendre(kFine), &open = gauss_legendre(kOpen),
                    &closed = gauss_lobatto(kClosed);
    cell.value = product(cell, fine, fine);
    const auto open_t = product(cell, open, fine), closed_t = product(cell, closed, fine),
               open_phi = product(cell, fine, open), closed_phi = product(cell, fine, closed),
               corners = product(cell, closed, closed);
    const std::vector<double> pole = cell.t1 == 1 ? hidden_at_pole(cell) : std::vector<double>();
    double along_t = 0, along_phi = 0;
    cell.error.assign(cell.value.size(), 0.0);
    for (std::size_t k = 0; k < cell.value.size(); ++k) {
      const auto off = [&](const std::vector<double>& other) { return std::abs(other[k] - cell.value[k]); };
      const double dt = std::max(off(open_t), off(closed_t)), dphi = std::max(off(open_phi), off(closed_phi));
      cell.error[k] = kCaution * std::max({dt + dphi, off(corners), pole.empty() ? 0 : std::abs(pole[k])});
      along_t = std::max(along_t, dt);
      along_phi = std::max(along_phi, dphi);
    }
    cell.halve_t = along_t >= along_phi;
    return cell;
  }

  // The solid angle of the cell vanishes at the pole, and no rule samples the value there. Returns the
  // deviation of that value from the polynomial through the nodes, times the solid angle of the cap beyond
  // the last node.
  std::vector<double> hidden_at_pole(const Cell& c) {
    const GaussRule& rule = gauss_legendre(kFine);
    std::array<double, kFine + 1> x, y, z, weight;
    const double phi = phi_ + kPi + (c.phi0 + c.phi1) / 2;
    for (std::size_t i = 0; i <= kFine; ++i) {
      const double v = i < kFine ? rule.node[i] : 1, t = c.t0 + (c.t1 - c.t0) * v, e = kPi / 2 * t * t;
      x[i] = integrals::cos(e) * integrals::cos(phi);
      y[i] = integrals::cos(e) * integrals::sin(phi);
      z[i] = integrals::sin(e);
      weight[i] = 1;
      for (std::size_t j = 0; j < kFine; ++j)
        if (j != i) weight[i] *= i < kFine ? (1 - rule.node[j]) / (v - rule.node[j]) : 1;
    }
    std::vector<double> values((kFine + 1) * integrand_.columns());
    integrand_.evaluate(fixed_, x.size(), x.data(), y.data(), z.data(), values.data());
    evaluations_ += kFine + 1;
    const double cap = (integrand_.features().anisotropic() ? 1 : 2) * (c.phi1 - c.phi0) * (1 - z[kFine - 1]);
    std::vector<double> columns;
    for (std::size_t k = 0; k < integrand_.columns(); ++k) {
      const double* f = &values[k * x.size()];
      double off = f[kFine];
      for (std::size_t i = 0; i < kFine; ++i) off -= weight[i] * f[i];
      columns.push_back(cap * off);
    }
    return integrand_.combine_varying(columns);
  }

  const Integrand& integrand_;
  const double elevation_, phi_;
  Vec3<double> fixed_{};
  long evaluations_ = 0;
  bool coarse_ = false;  // the initial cells do not close in on the lobe
};

}  // namespace

std::vector<AlbedoResult> adaptive_rule(const Integrand& integrand, const FixedDirection& fixed,
                                        double tolerance, long max_evaluations) {
  return Adaptive(integrand, fixed).run(tolerance, max_evaluations);
}

}  // namespace brdf::integrals
