#include "fit/solve/solve.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/algebra/eigen_view.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kManyUnknowns = 32;

// Computes rows of J and residuals r with J'J = H, J'r = g, r'r = 2 cost, in the unknowns `free`. A pivot
// below the rounding error of its diagonal is a direction without effect on the samples; its row is 0.
void compress(const NormalEquations& n, const std::vector<int>& free, Eigen::Ref<RowMatrix> jacobian,
              Eigen::Ref<Eigen::VectorXd> r) {
  const Eigen::Index size = Eigen::Index(free.size()), all = Eigen::Index(n.gradient.size());
  RowMatrix upper = Eigen::Map<const RowMatrix>(n.hessian.a.data(), all, all)(free, free);
  const Eigen::VectorXd diagonal = upper.diagonal();
  r.setZero();
  jacobian.setZero();
  double rest = 2 * n.cost;
  for (Eigen::Index i = 0; i < size; ++i) {
    double pivot = upper(i, i);
    if (!(pivot > 1e-14 * diagonal(i))) continue;
    pivot = std::sqrt(pivot);
    double g = n.gradient[std::size_t(free[std::size_t(i)])];
    for (Eigen::Index k = 0; k < i; ++k) g -= jacobian(k, i) * r(k);
    r(i) = g / pivot;
    rest -= r(i) * r(i);
    jacobian.row(i).segment(i, size - i) = upper.row(i).segment(i, size - i) / pivot;
    jacobian(i, i) = pivot;
    for (Eigen::Index j = i + 1; j < size; ++j)
      upper.row(j).tail(size - j) -= jacobian(i, j) * jacobian.row(i).segment(j, size - j);
  }
  r(size) = std::sqrt(std::max(rest, 0.0));
}

// The cost in the free parameters. Ceres requests cost and Jacobian separately. It does not take a step that
// changes the cost by less than its tolerance, and returns to the point before. Therefore two passes are
// kept, and a new pass replaces the one with the higher cost.
class CompressedCost : public ceres::CostFunction {
 public:
  explicit CompressedCost(const Objective& objective) : objective_(objective) {}

  // Makes the parameters that are not held the unknowns; the others keep their values in p. (A manifold of
  // Ceres would multiply the Jacobian by a matrix at every step.)
  void hold(const std::vector<int>& held, const std::vector<double>& p) {
    p_ = p;
    free_.clear();
    for (std::size_t k = 0; k < held.size(); ++k)
      if (!held[k]) free_.push_back(int(k));
    set_num_residuals(int(free_.size()) + 1);
    mutable_parameter_block_sizes()->assign(1, int(free_.size()));
    for (Pass& pass : kept_) pass.compressed = false;
  }
  const std::vector<int>& free() const { return free_; }

  // Returns whether cost and Jacobian are finite at this point. Ceres would find out by itself, but with a
  // message on the terminal.
  bool finite_at(const double* unknowns) const { return compressed_at(unknowns).finite; }
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Pass& pass = compressed_at(parameters[0]);
    if (!pass.finite) return false;
    std::copy(pass.residuals.begin(), pass.residuals.end(), residuals);
    if (jacobians && jacobians[0])
      std::copy(pass.jacobian.data(), pass.jacobian.data() + pass.jacobian.size(), jacobians[0]);
    return true;
  }
  const NormalEquations& equations(std::span<const double> p) const { return pass_at(p).equations; }
  int passes() const { return passes_; }
  // Returns whether the next step from the best point is predicted to lower the cost by less than its
  // rounding. The squares of all residuals but the last one are the part that the step would remove.
  bool is_settled() const {
    constexpr double kRounding = 1e-14;
    const Pass& best = *std::ranges::min_element(kept_, {}, [](const Pass& k) { return k.equations.cost; });
    const Eigen::Index n = Eigen::Index(free_.size());
    return best.compressed && best.finite &&
           best.residuals.head(n).squaredNorm() <= kRounding * best.residuals.squaredNorm();
  }
  // Takes the undamped step from a minimum, without a pass for the cost there: the step is predicted to
  // lower the cost by less than `tolerance` of it. The cost alone places a minimum to half of its digits. No
  // step is taken that would leave the bounds.
  void take_last_step(std::vector<double>& p, std::span<const double> low, std::span<const double> high,
                      double tolerance) const {
    std::vector<double> unknowns;
    for (int k : free_) unknowns.push_back(p[std::size_t(k)]);
    const Pass& here = compressed_at(unknowns.data());
    const Eigen::Index n = Eigen::Index(free_.size());
    if (!here.finite || here.residuals.head(n).squaredNorm() > tolerance * here.residuals.squaredNorm())
      return;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = n; i-- > 0;)
      if (const auto row = here.jacobian.row(i); row(i) > 0)
        step(i) = -(here.residuals(i) + row.dot(step)) / row(i);
    std::vector<double> there = p;
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t k = std::size_t(free_[std::size_t(i)]);
      there[k] += step(i);
      if (!(there[k] >= low[k] && there[k] <= high[k])) return;
    }
    p = std::move(there);
  }

 private:
  struct Pass {
    std::vector<double> p;  // empty before the first pass
    NormalEquations equations{.cost = HUGE_VAL};
    bool compressed = false, finite = false;
    RowMatrix jacobian;
    Eigen::VectorXd residuals;
  };

  Pass& pass_at(std::span<const double> p) const {
    const auto known = std::ranges::find_if(kept_, [&](const Pass& k) { return std::ranges::equal(k.p, p); });
    if (known != kept_.end()) return *known;
    // fmin: a cost that is not a number is not the best.
    const auto cost = [&](std::size_t k) { return std::fmin(kept_[k].equations.cost, HUGE_VAL); };
    Pass& pass = kept_[cost(0) < cost(1) ? 1 : 0];
    pass.equations = objective_(p);
    pass.p.assign(p.begin(), p.end());
    pass.compressed = false;
    ++passes_;
    return pass;
  }
  const Pass& compressed_at(const double* unknowns) const {
    for (std::size_t k = 0; k < free_.size(); ++k) p_[std::size_t(free_[k])] = unknowns[k];
    Pass& pass = pass_at(p_);
    if (pass.compressed) return pass;
    pass.compressed = true;
    pass.finite = false;
    if (!std::isfinite(pass.equations.cost)) return pass;
    const Eigen::Index n = Eigen::Index(free_.size());
    pass.jacobian.resize(n + 1, n);
    pass.residuals.resize(n + 1);
    compress(pass.equations, free_, pass.jacobian, pass.residuals);
    pass.finite = pass.jacobian.allFinite() && pass.residuals.allFinite();
    return pass;
  }

  const Objective& objective_;
  std::vector<int> free_;
  mutable std::vector<double> p_;
  mutable std::array<Pass, 2> kept_;
  mutable int passes_ = 0;
};

// Ends a run that is interrupted or that fails. Without it, Ceres writes to the terminal when it gives up.
class Watch : public ceres::IterationCallback {
 public:
  Watch(const std::atomic<bool>* interrupted, const CompressedCost& cost)
      : interrupted_(interrupted), cost_(cost) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& iteration) override {
    if (interrupted_ && interrupted_->load()) return ceres::SOLVER_TERMINATE_SUCCESSFULLY;
    invalid_ = iteration.iteration == 0 || iteration.step_is_valid ? 0 : invalid_ + 1;
    if (gave_up()) return ceres::SOLVER_ABORT;
    settled_ = cost_.is_settled();
    return settled_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }
  bool gave_up() const { return invalid_ >= kMostInvalid; }
  bool settled() const { return settled_; }

 private:
  static constexpr int kMostInvalid = 5;  // the default of Ceres
  const std::atomic<bool>* interrupted_;
  const CompressedCost& cost_;
  int invalid_ = 0;
  bool settled_ = false;
};

Termination termination_of(const ceres::Solver::Summary& summary) {
  switch (summary.termination_type) {
    case ceres::CONVERGENCE:
      return Termination::converged;
    case ceres::NO_CONVERGENCE:
      return Termination::iteration_limit;
    case ceres::USER_SUCCESS:
      return Termination::interrupted;
    default:
      return Termination::failed;
  }
}

// Runs Ceres once with some parameters held.
void run_ceres(CompressedCost& cost, std::vector<double>& p, std::span<const double> low,
               std::span<const double> high, const std::vector<int>& held, const SolveOptions& options,
               Solution& solution) {
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  cost.hold(held, p);
  const std::vector<int>& free = cost.free();
  if (free.empty()) {
    solution.termination = Termination::converged;
    solution.message = "every parameter is fixed";
    return;
  }
  std::vector<double> unknowns;
  for (int k : free) unknowns.push_back(p[std::size_t(k)]);
  if (!cost.finite_at(unknowns.data())) {
    solution.termination = Termination::failed;
    solution.message = "The residuals and their derivatives could not be evaluated.";
    return;
  }
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&cost, nullptr, unknowns.data());
  for (std::size_t k = 0; k < free.size(); ++k) {
    const std::size_t of = std::size_t(free[k]);
    if (std::isfinite(low[of])) problem.SetParameterLowerBound(unknowns.data(), int(k), low[of]);
    if (std::isfinite(high[of])) problem.SetParameterUpperBound(unknowns.data(), int(k), high[of]);
  }
  ceres::Solver::Options o;
  o.max_num_iterations = options.max_iterations;
  o.function_tolerance = options.tolerance;
  o.parameter_tolerance = options.tolerance;
  o.gradient_tolerance = 0;  // its scale is that of the samples, which is unknown here
  // The Jacobian is already a Cholesky factor, so another Cholesky factorisation loses nothing, and it is
  // faster for many unknowns.
  o.linear_solver_type = free.size() > kManyUnknowns ? ceres::DENSE_NORMAL_CHOLESKY : ceres::DENSE_QR;
  o.logging_type = ceres::SILENT;
  o.num_threads = 1;
  Watch watch(options.interrupted, cost);
  o.callbacks.push_back(&watch);
  o.max_num_consecutive_invalid_steps = std::numeric_limits<int>::max();
  ceres::Solver::Summary summary;
  ceres::Solve(o, &problem, &summary);
  for (std::size_t k = 0; k < free.size(); ++k) p[std::size_t(free[k])] = unknowns[k];
  solution.termination = watch.settled() ? Termination::converged : termination_of(summary);
  solution.message = watch.gave_up()   ? "Five consecutive steps were invalid."
                     : watch.settled() ? "The next step would lower the cost by less than its rounding."
                                       : summary.message;
  solution.iterations += int(summary.iterations.size()) - watch.gave_up();
}

}  // namespace

std::vector<int> hold_at_bounds(const NormalEquations& n, std::vector<double>& p, std::span<const double> low,
                                std::span<const double> high) {
  std::vector<int> held(p.size(), 0);
  const double scale = std::sqrt(2 * n.cost);
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double reach = 1e-9 * std::min(1.0, high[k] - low[k]);
    const int side = p[k] <= low[k] + reach ? -1 : p[k] >= high[k] - reach ? 1 : 0;
    const double noise = 1e-12 * scale * std::sqrt(n.hessian(k, k));
    if (side == 0 || !(side * n.gradient[k] <= noise)) continue;
    held[k] = side;
    p[k] = side < 0 ? low[k] : high[k];
  }
  return held;
}

Solution solve(const Objective& objective, std::span<const double> start, std::span<const double> low,
               std::span<const double> high, const SolveOptions& options) {
  Solution s;
  s.p.assign(start.begin(), start.end());
  s.at_bound.assign(start.size(), 0);
  CompressedCost cost(objective);
  if (s.p.empty()) {
    s.cost = objective(s.p).cost;
    s.termination = Termination::converged;
    return s;
  }
  const auto held_now = [&] { return hold_at_bounds(cost.equations(s.p), s.p, low, high); };
  std::vector<int> held = options.starts_at_solution ? held_now() : std::vector<int>(start.size(), 0);
  const int rounds = 2 * int(start.size()) + 4;
  for (int round = 0; round < rounds; ++round) {
    run_ceres(cost, s.p, low, high, held, options, s);
    if (s.termination == Termination::failed || s.termination == Termination::interrupted) break;
    std::vector<int> next = held_now();
    if (next == held) break;
    held = std::move(next);
  }
  s.at_bound = held;
  s.cost = cost.equations(s.p).cost;
  if (s.termination == Termination::converged) cost.take_last_step(s.p, low, high, options.tolerance);
  s.passes = cost.passes();
  return s;
}

}  // namespace brdf::fit
