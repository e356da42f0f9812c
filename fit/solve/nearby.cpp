#include "fit/solve/nearby.h"

#include <algorithm>
#include <cmath>

#include "fit/algebra/box_quadratic.h"

namespace brdf::fit {
namespace {

constexpr double kFirstDamping = 1e-6, kLeastDamping = 1e-12, kMostDamping = 1e12;
constexpr double kStrongDamping = 0.1;  // from here on a step is short because of the damping
constexpr double kLeastFactor = 0.1;    // of the damping from one step to the next
// Predicted reductions below this share of the cost fall at a constant rate.
constexpr double kNear = 1e-6, kMargin = 10;
constexpr double kStepRounding = 1e-12;  // share of a parameter below which a step is rounding

struct Move {
  std::vector<double> by;
  double promised = 0;  // reduction of the quadratic

  bool is_rounding(std::span<const double> p) const {
    for (std::size_t k = 0; k < p.size(); ++k)
      if (std::abs(by[k]) > kStepRounding * std::abs(p[k])) return false;
    return true;
  }
};

// The damping of the steps (Nielsen 1999). After a step it falls by a factor that the kept share of the
// promised reduction decides, and it rises faster with every step that fails in succession. In a narrow
// curved valley, a damping that always falls by the same factor makes many steps fail.
class Damping {
 public:
  double value() const { return value_; }
  bool is_strong() const { return value_ >= kStrongDamping; }
  // After a step; `kept`: its reduction of the cost, as a share of the promised one.
  void after_success(double kept) {
    const double factor = 1 - std::pow(2 * std::min(kept, 1.0) - 1, 3);
    value_ = std::max(value_ * std::max(kLeastFactor, factor), kLeastDamping);
    rise_ = 2;
  }
  // Returns false if no further step is worth a try.
  bool after_failure() {
    value_ *= rise_;
    rise_ *= 2;
    return value_ <= kMostDamping;
  }

 private:
  double value_ = kFirstDamping, rise_ = 2;
};

Move step_of(const NormalEquations& n, std::span<const double> p, std::span<const double> low,
             std::span<const double> high, double damping) {
  const std::size_t size = p.size();
  Matrix h = n.hessian;
  std::vector<double> to_low(size), to_high(size);
  for (std::size_t k = 0; k < size; ++k) {
    h(k, k) *= 1 + damping;
    to_low[k] = low[k] - p[k];
    to_high[k] = high[k] - p[k];
  }
  Move step{box_quadratic(h, n.gradient, to_low, to_high), 0};
  for (std::size_t i = 0; i < size; ++i) {
    double slope = n.gradient[i];
    for (std::size_t j = 0; j < size; ++j) slope += 0.5 * n.hessian(i, j) * step.by[j];
    step.promised -= slope * step.by[i];
  }
  return step;
}

}  // namespace

Solution solve_nearby(const Objective& objective, std::span<const double> start, std::span<const double> low,
                      std::span<const double> high, const SolveOptions& options) {
  Solution s;
  s.p.assign(start.begin(), start.end());
  for (std::size_t k = 0; k < s.p.size(); ++k) s.p[k] = std::clamp(s.p[k], low[k], high[k]);
  NormalEquations here = objective(s.p);
  s.passes = 1;
  Damping damping;
  double last = 0;  // predicted reduction of the last step, if it was taken
  s.termination = std::isfinite(here.cost) ? Termination::iteration_limit : Termination::failed;
  for (; s.termination == Termination::iteration_limit && s.iterations < options.max_iterations;
       ++s.iterations) {
    if (options.interrupted && options.interrupted->load(std::memory_order_relaxed)) {
      s.termination = Termination::interrupted;
      break;
    }
    const Move step = step_of(here, s.p, low, high, damping.value());
    std::vector<double> p = s.p;
    for (std::size_t k = 0; k < p.size(); ++k) p[k] = std::clamp(p[k] + step.by[k], low[k], high[k]);
    const bool small = !damping.is_strong() && !(step.promised > options.tolerance * here.cost);
    // Near the minimum, the predicted reductions form a geometric series.
    const bool lands = last > 0 && !damping.is_strong() && step.promised <= kNear * here.cost &&
                       kMargin * step.promised * (step.promised / last) <= options.tolerance * here.cost;
    if (small || lands || step.is_rounding(s.p)) {
      s.p = std::move(p);  // the remaining gain is below the tolerance: not worth a pass
      s.termination = Termination::converged;
      break;
    }
    NormalEquations there = objective(p);
    ++s.passes;
    if (std::isfinite(there.cost) && there.cost <= here.cost) {
      damping.after_success((here.cost - there.cost) / step.promised);
      s.p = std::move(p);
      here = std::move(there);
      last = step.promised;
    } else {
      last = 0;
      if (!damping.after_failure()) s.termination = Termination::failed;
    }
  }
  s.at_bound = hold_at_bounds(here, s.p, low, high);
  s.cost = here.cost;
  s.message = s.termination == Termination::converged ? "The next step would not change the parameters."
              : s.termination == Termination::iteration_limit ? "The limit of iterations was reached."
                                                              : "No step reduces the cost.";
  return s;
}

}  // namespace brdf::fit
