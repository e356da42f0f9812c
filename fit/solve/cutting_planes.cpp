#include "fit/solve/cutting_planes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brdf/least_of_matt.h"
#include "fit/solve/equivalence.h"
#include "fit/solve/limited.h"
#include "fit/solve/nearby.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr int kMostRounds = 40;
constexpr double kCutStiffness = 1e4;  // relative to the samples' own
constexpr double kMarginAtCut = 1e-3;  // of the median of the samples: f at a limit
constexpr double kAlbedoRoom = 1e-5;

double median_value(const FitData& data, std::size_t channel) {
  std::vector<double> values;
  for (const double v : data.values[channel])
    if (v > 0) values.push_back(v);
  return values.empty() ? 0 : io::median(std::move(values));
}

class Limits {
 public:
  Limits(const FitData& data, Model& model, const Residual& residual, const FitOptions& options)
      : data_(data), model_(model), residual_(residual), options_(options) {}

  std::optional<CuttingPlanes> run(Minimum& best) {
    for (int round = 0; round < kMostRounds; ++round) {
      const std::size_t before = model_.cuts().size();
      open_.clear();
      for (std::size_t c = 0; c < model_.channels().size(); ++c) add_limits(best.p, c);
      if (model_.cuts().size() == before) break;
      if (options_.stop()) break;
      solve_again(best);
      if (some_is_unmet(best.p)) break;  // held weights contradict it
    }
    if (done_.cuts == 0 && open_.empty()) return std::nullopt;
    done_.open = open_;
    return done_;
  }

 private:
  void add_limits(std::span<const double> p, std::size_t channel) {
    std::vector<double> weights(model_.lobes());
    model_.lobe_weights(p, channel, weights);
    for (const TermModel& term : model_.terms())
      if (term.info->basis)
        keep_above_zero(p, channel, term, std::span(weights).subspan(term.first_lobe, term.lobes));
    if (model_.limits_albedo()) keep_albedo(p, channel, weights);
  }

  void keep_above_zero(std::span<const double> p, std::size_t channel, const TermModel& term,
                       std::span<const double> weights) {
    // A fifth of the margin is left to the proofs, which add the rounding of the evaluation.
    const double margin = kMarginAtCut * median_value(data_, channel), floor = 0.2 * margin;
    const LeastOfMatt least = least_of_matt(*term.info->basis, weights, floor, 4000);
    if (least.bound >= floor || (least.bound >= 0 && (done_.cuts == 0 || least.value >= floor))) return;
    if (open_.empty())
      open_ = "f of " + std::string(term.info->name) + " reaches " + io::short_number(least.value, 3) +
              " /sr in " + model_.channels()[channel];
    if (done_.channel.empty() && least.value < 0) {
      done_.channel = model_.channels()[channel];
      done_.free_value = least.value;
      done_.wi = least.wi;
      done_.wo = least.wo;
    }
    std::vector<double> values(term.lobes);
    matt_values(*term.info->basis, least.wi, least.wo, values);
    Cut cut{channel, std::vector<double>(model_.lobes(), 0), margin};
    std::ranges::copy(values, cut.lobes.begin() + std::ptrdiff_t(term.first_lobe));
    add(p, std::move(cut));
  }

  // Returns the limit "the albedo at this cosine is at most 1". The albedo of a basis is a polynomial of the
  // cosine, and that of every other lobe is at most its weight.
  Cut limit_at(double cosine, std::size_t channel) const {
    Cut cut{channel, std::vector<double>(model_.lobes(), -1), -(1 - kAlbedoRoom)};
    for (const TermModel& term : model_.terms()) {
      if (!term.info->basis) continue;
      const std::span own = std::span(cut.lobes).subspan(term.first_lobe, term.lobes);
      matt_albedos(*term.info->basis, cosine, own);
      for (double& albedo : own) albedo = -albedo;
    }
    return cut;
  }

  // The polynomial is of the second degree at most (orders up to 5), so that its largest value is at an end
  // or at the vertex of the parabola through three values.
  void keep_albedo(std::span<const double> p, std::size_t channel, std::span<const double> weights) {
    const auto albedo_of = [&](const Cut& cut) {
      return -std::inner_product(weights.begin(), weights.end(), cut.lobes.begin(), 0.0);
    };
    std::vector<double> cosines{0, 0.5, 1};
    double at[3];
    for (std::size_t k = 0; k < 3; ++k) at[k] = albedo_of(limit_at(cosines[k], channel));
    const double bend = 2 * (at[0] - 2 * at[1] + at[2]), slope = at[2] - at[0] - bend;
    if (bend < 0) cosines.push_back(std::clamp(-slope / (2 * bend), 0.0, 1.0));
    const auto largest =
        std::ranges::max(cosines, {}, [&](double cosine) { return albedo_of(limit_at(cosine, channel)); });
    Cut worst = limit_at(largest, channel);
    const double albedo = albedo_of(worst);
    if (!(albedo > 1)) return;
    done_.limits_albedo = true;
    if (open_.empty())
      open_ = "the albedo reaches " + io::short_number(albedo, 6) + " in " + model_.channels()[channel];
    add(p, std::move(worst));
  }

  void add(std::span<const double> p, Cut cut) {
    const SampleStream stream(data_, model_, residual_, options_.resolved_aperture());
    if (stiffness_ == 0) {
      const Matrix hessian = stream.normal_equations(p).hessian;
      for (std::size_t k = model_.shape_slots(); k < model_.size(); ++k)
        stiffness_ = std::max(stiffness_, hessian(k, k));
    }
    double square = 0;
    for (const double x : cut.lobes) square += x * x;
    cut.stiffness = kCutStiffness * stiffness_ / square;
    model_.add_cut(std::move(cut));
    ++done_.cuts;
  }

  bool some_is_unmet(std::span<const double> p) const {
    std::vector<double> weights(model_.lobes());
    return std::ranges::any_of(model_.cuts(), [&](const Cut& cut) {
      model_.lobe_weights(p, cut.channel, weights);
      return cut.shortfall(weights) > 0.5 * std::abs(cut.least);
    });
  }

  void solve_again(Minimum& best) const {
    const SampleStream stream(data_, model_, residual_, options_.resolved_aperture());
    SolveOptions solver;
    solver.max_iterations = 100;
    solver.interrupted = options_.interrupted;
    Solution s = solve_limited(stream, best.p, solver);
    // From there the penalties of the limits are solved too, as in every later pass over the samples.
    const Objective objective = [&](std::span<const double> p) { return stream.normal_equations(p); };
    Solution near = solve_nearby(objective, s.p, model_.low(), model_.high(), solver);
    if (near.termination == Termination::converged) s = std::move(near);
    Minimum next{std::move(s.p),        s.cost,        best.basin,
                 std::move(s.at_bound), s.termination, std::move(s.message)};
    canonicalise(model_, next);
    best = std::move(next);
  }

  const FitData& data_;
  Model& model_;
  const Residual& residual_;
  const FitOptions& options_;
  double stiffness_ = 0;
  std::string open_;
  CuttingPlanes done_;
};

}  // namespace

std::optional<CuttingPlanes> keep_within_limits(const FitData& data, Model& model, const Residual& residual,
                                                const FitOptions& options, Minimum& best) {
  if (!model.is_signed()) return std::nullopt;
  return Limits(data, model, residual, options).run(best);
}

}  // namespace brdf::fit
