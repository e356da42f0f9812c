#include "fit/assess/profile_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/assess/propagation.h"
#include "fit/solve/nearby.h"

namespace brdf::fit {
namespace {

// With this penalty a point of the profile misses its value by 2e-4 of its distance.
constexpr double kPenalty = 1e4;
constexpr double kSolved = 1e-3;  // relative to the level: accuracy of a minimised cost
constexpr int kSteps = 24;        // of one minimisation

}  // namespace

ProfileCoordinate::ProfileCoordinate(const Model& model, const Reported& r, std::size_t index)
    : model_(model), r_(r), index_(index), slot_(r.slot) {
  // A weight that is set by a single unknown.
  if (slot_ == kNoSlot && r.scale == kNoSlot && r.times == kNoSlot && model.linear() && !r.divided &&
      r.gradient.size() == 1 && r.gradient[0].second == 1)
    slot_ = r.gradient[0].first;
}

double ProfileCoordinate::low() const {
  return r_.slot != kNoSlot ? model_.slots()[r_.slot].low : on_scale(r_.min);
}

double ProfileCoordinate::high() const {
  return r_.slot != kNoSlot ? model_.slots()[r_.slot].high : on_scale(r_.max);
}

double ProfileCoordinate::at(std::span<const double> p) const {
  return slot_ != kNoSlot ? p[slot_] : on_scale(there(p).estimate.value);
}

std::pair<double, Eigen::VectorXd> ProfileCoordinate::with_gradient(std::span<const double> p) const {
  const Eigen::Index n = Eigen::Index(p.size());
  if (slot_ != kNoSlot) return {p[slot_], Eigen::VectorXd::Unit(n, Eigen::Index(slot_))};
  const Reported here = there(p);
  const Eigen::VectorXd g = gradient_vector(here, n);
  if (r_.scale == kNoSlot) return {here.estimate.value, g};
  const double u = on_scale(here.estimate.value);
  return {u, g / model_.slots()[r_.scale].slope(u)};
}

Reported ProfileCoordinate::there(std::span<const double> p) const {
  std::vector<Reported> all = reported_parameters(model_, p);
  return r_.times == kNoSlot ? std::move(all[index_]) : product_of(all, index_, r_.times);
}

double ProfileCoordinate::on_scale(double value) const {
  return r_.scale == kNoSlot ? value : model_.slots()[r_.scale].to_solver(value);
}

ProfileSolver::ProfileSolver(const SampleStream& stream, const Minimum& minimum,
                             const ProfileCoordinate& coordinate, double level,
                             const std::atomic<bool>* interrupted)
    : stream_(stream),
      minimum_(minimum),
      coordinate_(coordinate),
      level_(level),
      origin_(coordinate.at(minimum.p)),
      interrupted_(interrupted),
      low_(stream.model().low()),
      high_(stream.model().high()) {}

ProfilePoint ProfileSolver::least_at(double x, std::vector<double> p, bool hold_shapes) const {
  std::vector<double> low = low_, high = high_;
  for (std::size_t k = 0; k < p.size(); ++k) p[k] = std::clamp(p[k], low[k], high[k]);
  for (std::size_t k = 0; hold_shapes && k < stream_.model().shape_slots(); ++k) low[k] = high[k] = p[k];
  const std::size_t held = coordinate_.slot();
  if (held != kNoSlot) low[held] = high[held] = p[held] = x;
  const double penalty = kPenalty * level_ / std::pow(std::max(std::abs(x - origin_), 1e-12), 2);
  ProfilePoint best{x, std::numeric_limits<double>::infinity(), p};
  double least = best.rise;
  const Objective objective = [&](std::span<const double> q) {
    NormalEquations n = stream_.normal_equations(q);
    const double rise = n.cost - minimum_.cost;
    double reached = x;
    if (held == kNoSlot) {
      const auto [value, gradient] = coordinate_.with_gradient(q);
      reached = value;
      n.cost += 0.5 * penalty * (value - x) * (value - x);
      for (std::size_t i = 0; i < q.size(); ++i) {
        const double own = penalty * gradient(Eigen::Index(i));
        n.gradient[i] += own * (value - x);
        for (std::size_t j = 0; j < q.size(); ++j) n.hessian(i, j) += own * gradient(Eigen::Index(j));
      }
    }
    if (n.cost < least) {
      least = n.cost;
      best = {reached, rise, {q.begin(), q.end()}};
    }
    return n;
  };
  SolveOptions options;
  options.max_iterations = kSteps;
  options.tolerance = kSolved * level_ / std::max(minimum_.cost, level_);
  options.interrupted = interrupted_;
  solve_nearby(objective, p, low, high, options);
  return best;
}

}  // namespace brdf::fit
