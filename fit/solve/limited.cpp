#include "fit/solve/limited.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/algebra/box_quadratic.h"
#include "fit/algebra/eigen_view.h"

namespace brdf::fit {
namespace {

constexpr double kDampingAtFirst = 1e-8, kDampingAtMost = 1e8;
// Of the cost. Limits that nearly depend on each other leave this much rounding in a step.
constexpr double kPrecise = 1e-9;
constexpr int kMostSteps = 50;
constexpr double kMet = 1e-5;  // of the limit: a shortfall that counts as none

// The conditions of a step: rows times the step are at least `least`.
struct Conditions {
  RowMatrix rows;
  Eigen::VectorXd least;
  double shortfall = 0;  // the largest relative shortfall of a limit before the step
};

Conditions conditions_at(const Model& model, std::span<const double> p) {
  const std::vector<double> low = model.low(), high = model.high();
  std::vector<std::vector<double>> rows;
  std::vector<double> least;
  Conditions out;
  std::vector<double> weights(model.lobes());
  for (const Cut& cut : model.cuts()) {
    model.lobe_weights(p, cut.channel, weights);
    double value = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) value += cut.lobes[k] * weights[k];
    std::vector<double>& row = rows.emplace_back(p.size(), 0.0);
    for (const WeightSlope& w : model.weight_slopes(p, cut.channel))
      row[w.slot] += cut.lobes[w.lobe] * w.value;
    least.push_back(cut.least - value);
    out.shortfall = std::max(out.shortfall, (cut.least - value) / std::abs(cut.least));
  }
  for (std::size_t k = 0; k < p.size(); ++k)
    for (const double side : {1.0, -1.0}) {
      const double bound = side > 0 ? low[k] : high[k];
      if (std::abs(bound) >= kWeightMax) continue;
      rows.emplace_back(p.size(), 0.0)[k] = side;
      least.push_back(side * (bound - p[k]));
    }
  out.rows = RowMatrix::Zero(Eigen::Index(rows.size()), Eigen::Index(p.size()));
  out.least = Eigen::Map<const Eigen::VectorXd>(least.data(), Eigen::Index(least.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < p.size(); ++k) out.rows(Eigen::Index(i), Eigen::Index(k)) = rows[i][k];
  return out;
}

using Factors = Eigen::LDLT<Eigen::MatrixXd>;

// Returns the change of the free step that brings it to these conditions, by the dual: a quadratic in
// multipliers that are not negative.
Eigen::VectorXd towards_conditions(const Factors& solver, const Eigen::VectorXd& free,
                                   const Conditions& conditions, const std::vector<Eigen::Index>& of) {
  const std::size_t count = of.size();
  RowMatrix rows(Eigen::Index(count), free.size());
  std::vector<double> gradient(count);
  for (std::size_t k = 0; k < count; ++k) {
    rows.row(Eigen::Index(k)) = conditions.rows.row(of[k]);
    gradient[k] = rows.row(Eigen::Index(k)).dot(free) - conditions.least(of[k]);
  }
  const Eigen::MatrixXd back = solver.solve(Eigen::MatrixXd(rows.transpose()));
  const RowMatrix dual = rows * back;
  Matrix quadratic{count, count};
  std::copy(dual.data(), dual.data() + dual.size(), quadratic.a.begin());
  // Conditions may depend on each other.
  for (std::size_t k = 0; k < count; ++k) quadratic(k, k) *= 1 + 1e-10;
  const std::vector<double> zero(count, 0.0), any(count, std::numeric_limits<double>::max());
  const std::vector<double> multipliers = box_quadratic(quadratic, gradient, zero, any);
  return back * Eigen::Map<const Eigen::VectorXd>(multipliers.data(), Eigen::Index(count));
}

// Returns the step that minimises the damped quadratic under these conditions.
Eigen::VectorXd limited_step(const NormalEquations& n, const Conditions& conditions, double damping) {
  const Eigen::Index size = Eigen::Index(n.gradient.size()), count = conditions.least.size();
  RowMatrix h = Eigen::Map<const RowMatrix>(n.hessian.a.data(), size, size);
  const double most = h.diagonal().maxCoeff();
  h.diagonal() += damping * h.diagonal() + Eigen::VectorXd::Constant(size, 1e-14 * most);
  const Factors solver{Eigen::MatrixXd(h)};
  const Eigen::VectorXd free = -solver.solve(Eigen::Map<const Eigen::VectorXd>(n.gradient.data(), size));
  // Only conditions that a step breaks are solved for, so that many conditions cost little.
  constexpr int kMostAdditions = 20;
  Eigen::VectorXd step = free;
  std::vector<Eigen::Index> broken;
  std::vector<bool> added(std::size_t(count), false);
  for (int addition = 0; addition < kMostAdditions; ++addition) {
    const std::size_t before = broken.size();
    const Eigen::VectorXd values = conditions.rows * step;
    for (Eigen::Index k = 0; k < count; ++k)
      if (!added[std::size_t(k)] && conditions.least(k) - values(k) > kMet * std::abs(conditions.least(k))) {
        broken.push_back(k);
        added[std::size_t(k)] = true;
      }
    if (broken.size() == before) break;
    step = free + towards_conditions(solver, free, conditions, broken);
  }
  return step;
}

double promised_reduction(const NormalEquations& n, const Eigen::VectorXd& step) {
  const Eigen::Index size = step.size();
  const Eigen::Map<const RowMatrix> h(n.hessian.a.data(), size, size);
  return -step.dot(Eigen::Map<const Eigen::VectorXd>(n.gradient.data(), size) + 0.5 * (h * step));
}

}  // namespace

Solution solve_limited(const SampleStream& stream, std::span<const double> start,
                       const SolveOptions& options) {
  const Model& model = stream.model();
  const std::vector<double> low = model.low(), high = model.high();
  Solution s;
  s.p.assign(start.begin(), start.end());
  NormalEquations here = stream.without_cuts(s.p);
  s.passes = 1;
  s.termination = Termination::iteration_limit;
  double damping = kDampingAtFirst;
  for (; s.iterations < std::min(options.max_iterations, kMostSteps); ++s.iterations) {
    const Conditions conditions = conditions_at(model, s.p);
    const bool met = conditions.shortfall <= kMet;
    const Eigen::VectorXd step = limited_step(here, conditions, damping);
    const double promised = promised_reduction(here, step);
    std::vector<double> p = s.p;
    for (std::size_t k = 0; k < p.size(); ++k)
      p[k] = std::clamp(p[k] + step(Eigen::Index(k)), low[k], high[k]);
    if (met && damping < 1 && promised <= std::max(options.tolerance, kPrecise) * here.cost) {
      s.termination = Termination::converged;
      break;
    }
    NormalEquations there = stream.without_cuts(p);
    ++s.passes;
    if (std::isfinite(there.cost) && (!met || there.cost <= here.cost)) {
      s.p = std::move(p);
      here = std::move(there);
      damping = std::max(damping / 10, kDampingAtFirst);
    } else if ((damping *= 10) > kDampingAtMost) {
      s.termination = met ? Termination::converged : Termination::failed;  // no step lowers the cost
      break;
    }
  }
  s.at_bound = hold_at_bounds(here, s.p, low, high);
  s.cost = here.cost;
  s.message = s.termination == Termination::converged ? "The next step would not change the parameters."
                                                      : "The limits of the weights could not be met.";
  return s;
}

}  // namespace brdf::fit
