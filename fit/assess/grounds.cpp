#include "fit/assess/grounds.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/propagation.h"
#include "fit/assess/student.h"

namespace brdf::fit {
namespace {

// Effective numbers of deciding values. Up to the first, their residuals contain no information on their
// noise; from the second on they contain enough.
constexpr double kFewDeciding = 5, kManyDeciding = 15;

}  // namespace

double trust_in(double deciding) {
  return std::clamp((deciding - kFewDeciding) / (kManyDeciding - kFewDeciding), 0.0, 1.0);
}

double Grounds::error_of(const Eigen::VectorXd& g, double deciding) const {
  const double consistent = g.dot(curvature.covariance * g);
  if (!working || std::isnan(deciding)) return std::sqrt(std::max(consistent, 0.0));
  const double pooled = g.dot(*working * g);
  return std::sqrt(std::max(pooled + trust_in(deciding) * std::max(consistent - pooled, 0.0), 0.0));
}

bool at_bound(const Reported& r, const Minimum& m) {
  if (r.gradient.empty()) return false;
  bool all = true, any = false;
  for (const auto& [slot, slope] : r.gradient) {
    all = all && m.at_bound[slot] != 0;
    any = any || m.at_bound[slot] != 0;
  }
  const double v = r.estimate.value, reach = 1e-9 * (r.max - r.min);
  return all || (any && (v <= r.min + reach || v >= r.max - reach));
}

double error_on_scale(const Reported& r, const Model& model, double error) {
  if (r.scale == kNoSlot || error == 0) return error;
  const Slot& slot = model.slots()[r.scale];
  return error / slot.slope(slot.to_solver(r.estimate.value));
}

bool asks_for_turn(const Reported& r, const Model& model) {
  if (r.scale != kNoSlot ? model.slots()[r.scale].members.size() > 1 : r.slot == kNoSlot) return false;
  return r.info == &kTangentInfo || r.info->role == Role::width_across ||
         r.info->role == Role::exponent_across;
}

void judge_parameter(Reported& r, const Grounds& on, Uncertainty& out) {
  Estimate& e = r.estimate;
  if (r.gradient.empty() && !r.without_lobe) {
    e.status = Status::fixed;
    return;
  }
  e.status = Status::unidentified;
  if (r.without_lobe || on.few) return;
  const Eigen::VectorXd g = gradient_vector(r, on.curvature.inverse.rows());
  if ((on.unturned && asks_for_turn(r, on.model)) || on.curvature.without_effect(g)) {
    out.singular = true;
    return;
  }
  const double error = on.error_of(g, e.deciding), on_scale = error_on_scale(r, on.model, error);
  const Extent interval = extent_of(r, on.model, on.minimum.p, t_quantile(on.freedom) * on_scale);
  e.low = interval.low;
  e.high = interval.high;
  e.low_open = e.low <= r.min;
  e.high_open = e.high >= r.max;
  if (says_nothing(r, on.model, on_scale)) return;
  e.status = at_bound(r, on.minimum) ? Status::at_bound : Status::free;
  if (e.status == Status::at_bound) return;
  e.standard_error = error;
  e.freedom = on.freedom;
}

}  // namespace brdf::fit
