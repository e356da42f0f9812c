// Bisection of cells in (t, phi), elevation = pi/2 t^2, phi from the mirror plane: each cell by two product
// Gauss-Legendre rules whose difference is its error; the worst cell is halved along its worse direction.
// The first cells close in on the lobe by its widths. A kink is looked for where it could hide from both
// rules.
#include <algorithm>
#include <cmath>
#include <queue>

#include "integrals/gauss_legendre.h"
#include "integrals/integrand.h"

namespace brdf::integrals {
namespace {

constexpr int kFine = 10, kCoarse = 7;

struct Cell {
  double t0, t1, phi0, phi1;
  std::vector<double> value, error;  // per output
  double priority = 0;
  bool halve_t = true;
  bool operator<(const Cell& other) const { return priority < other.priority; }
};

class Adaptive {
 public:
  Adaptive(const Integrand& integrand, const FixedDirection& fixed)
      : integrand_(integrand), elevation_(std::max(fixed.elevation, 0.0)), phi_(fixed.phi) {
    const double s = std::cos(elevation_);
    fixed_ = {s * std::cos(phi_), s * std::sin(phi_), std::sin(elevation_)};
  }

  std::vector<AlbedoResult> run(double tolerance, long max_evaluations) {
    const std::size_t outputs = integrand_.outputs();
    std::priority_queue<Cell> cells;
    std::vector<double> total(outputs, 0.0), error(outputs, 0.0);
    const auto insert = [&](Cell cell) {
      for (std::size_t k = 0; k < outputs; ++k) {
        total[k] += cell.value[k];
        error[k] += cell.error[k];
      }
      cells.push(std::move(cell));
    };
    for (Cell& cell : first_cells()) insert(measure(cell));
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
      insert(measure(low));
      insert(measure(high));
    }
    return results(cells, outputs, tolerance);
  }

 private:
  std::vector<AlbedoResult> results(std::priority_queue<Cell>& cells, std::size_t outputs, double tolerance) {
    // Summed afresh: the running totals carry the rounding of everything subtracted.
    std::vector<AlbedoResult> found(outputs);
    for (; !cells.empty(); cells.pop())
      for (std::size_t k = 0; k < outputs; ++k) {
        found[k].value += cells.top().value[k];
        found[k].error_bound += cells.top().error[k];
      }
    for (AlbedoResult& r : found) {
      r.evaluations = evaluations_;
      r.converged = r.error_bound <= tolerance * std::abs(r.value);
      r.rule = Rule::adaptive;
    }
    return found;
  }

  // The half vector of a point, in units of the lobe's widths (its sines: bounded).
  std::array<double, 2> in_widths(double t, double phi) const {
    const double e = kPi / 2 * t * t, s = std::cos(e), azimuth = phi_ + kPi + phi;
    const Vec3<double> h = Vec3<double>{s * std::cos(azimuth), s * std::sin(azimuth), std::sin(e)} + fixed_;
    const double length = std::sqrt(std::max(dot(h, h), 1e-30));
    return {h.x / length / integrand_.features().width_x, h.y / length / integrand_.features().width_y};
  }

  // Halves a cell until it is small beside the lobe's width or its distance from the lobe: then no lobe is
  // missed, however narrow, nor the wide one that grazing light draws together.
  void cover(Cell cell, int depth, std::vector<Cell>& cells) const {
    const double t = (cell.t0 + cell.t1) / 2, phi = (cell.phi0 + cell.phi1) / 2;
    const auto apart = [](const auto& a, const auto& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); };
    const auto centre = in_widths(t, phi);
    const double along_t =
        std::max(apart(centre, in_widths(cell.t0, phi)), apart(centre, in_widths(cell.t1, phi)));
    const double along_phi =
        std::max(apart(centre, in_widths(t, cell.phi0)), apart(centre, in_widths(t, cell.phi1)));
    const double size = along_t + along_phi;
    const double from_lobe = std::max(0.0, std::hypot(centre[0], centre[1]) - size);
    if (depth == 0 || size < 0.7 + from_lobe / 2) {
      cells.push_back(cell);
      return;
    }
    Cell low = cell, high = cell;
    if (along_t > along_phi)
      low.t1 = high.t0 = t;
    else
      low.phi1 = high.phi0 = phi;
    cover(low, depth - 1, cells);
    cover(high, depth - 1, cells);
  }

  std::vector<Cell> first_cells() const {
    const double mirror = std::sqrt(elevation_ * 2 / kPi);
    const bool anisotropic = integrand_.features().anisotropic();
    std::vector<Cell> cells;
    for (const auto& [t0, t1] : {std::pair{0.0, mirror}, std::pair{mirror, 1.0}}) {
      if (!(t1 > t0)) continue;
      cover({t0, t1, 0, kPi, {}, {}}, 60, cells);
      if (anisotropic) cover({t0, t1, -kPi, 0, {}, {}}, 60, cells);
    }
    return cells;
  }

  std::vector<double> product(const Cell& c, int n_t, int n_phi) {
    NodeSum sum(integrand_, fixed_);
    const GaussRule& rule_t = gauss_legendre(n_t);
    const GaussRule& rule_phi = gauss_legendre(n_phi);
    const double twice = integrand_.features().anisotropic() ? 1 : 2;
    for (int i = 0; i < n_t; ++i) {
      const double t = c.t0 + (c.t1 - c.t0) * rule_t.node[i];
      const double e = kPi / 2 * t * t, s = std::cos(e), z = std::sin(e);
      const double weight = twice * s * kPi * t * (c.t1 - c.t0) * rule_t.weight[i] * (c.phi1 - c.phi0);
      for (int j = 0; j < n_phi; ++j) {
        const double phi = phi_ + kPi + c.phi0 + (c.phi1 - c.phi0) * rule_phi.node[j];
        sum.add(s * std::cos(phi), s * std::sin(phi), z, weight * rule_phi.weight[j]);
      }
    }
    auto columns = sum.sums();
    evaluations_ += sum.evaluations();
    return integrand_.combine(columns);
  }

  Cell measure(Cell cell) {
    cell.value = product(cell, kFine, kFine);
    const auto less_t = product(cell, kCoarse, kFine), less_phi = product(cell, kFine, kCoarse);
    double along_t = 0, along_phi = 0;
    cell.error.assign(cell.value.size(), 0.0);
    for (std::size_t k = 0; k < cell.value.size(); ++k) {
      const double dt = std::abs(less_t[k] - cell.value[k]), dphi = std::abs(less_phi[k] - cell.value[k]);
      cell.error[k] = dt + dphi;
      along_t = std::max(along_t, dt);
      along_phi = std::max(along_phi, dphi);
    }
    cell.halve_t = along_t >= along_phi;
    if (integrand_.features().kink == Kink::v_cavity) {
      const Cut cut = hidden_cut(cell);
      for (std::size_t k = 0; k < cell.value.size(); ++k) {
        const double most = cut.depth * std::abs(cell.value[k]);
        if (most <= cell.error[k]) continue;
        cell.error[k] = most;
        cell.halve_t = cut.along_t;
        along_t = std::max(along_t, most);
      }
    }
    cell.priority = std::max(along_t, along_phi);
    return cell;
  }

  // Of V-cavities, G = min(1, r): r is 1 where the masking sets in.
  double masking(double t, double phi) const {
    const double e = kPi / 2 * t * t, s = std::cos(e), azimuth = phi_ + kPi + phi;
    const Vec3<double> w{s * std::cos(azimuth), s * std::sin(azimuth), std::sin(e)}, h = w + fixed_;
    return 4 * h.z * std::min(w.z, fixed_.z) / std::max(dot(h, h), 1e-300);
  }

  struct Cut {
    double depth = 0;  // how far G departs beyond the kink from its continuation to there
    bool along_t = true;
  };
  // A kink that cuts a corner off which no node lies in is seen by no difference of rules. G at the cell's
  // corners and the middles of its sides tells: the part beyond the kink is wrong by no more than this.
  Cut hidden_cut(const Cell& c) const {
    const double t = (c.t0 + c.t1) / 2, phi = (c.phi0 + c.phi1) / 2, centre = masking(t, phi);
    Cut cut;
    for (const double u : {c.t0, t, c.t1})
      for (const double v : {c.phi0, phi, c.phi1}) {
        const double r = masking(u, v);
        if ((r < 1) != (centre < 1)) cut.depth = std::max(cut.depth, std::min(std::abs(r - 1), 1.0));
      }
    cut.along_t = std::abs(masking(c.t0, phi) - masking(c.t1, phi)) >=
                  std::abs(masking(t, c.phi0) - masking(t, c.phi1));
    return cut;
  }

  const Integrand& integrand_;
  const double elevation_, phi_;
  Vec3<double> fixed_{};
  long evaluations_ = 0;
};

}  // namespace

std::vector<AlbedoResult> adaptive_rule(const Integrand& integrand, const FixedDirection& fixed,
                                        double tolerance, long max_evaluations) {
  return Adaptive(integrand, fixed).run(tolerance, max_evaluations);
}

}  // namespace brdf::integrals
