#include "fit/solve/minima.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/solve/equivalence.h"
#include "fit/solve/few_channels.h"
#include "fit/solve/starts.h"
#include "fit/solve/varpro.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/parallel.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kCoarseRows = 4096;  // rows on which the starts are solved
constexpr std::size_t kMiddleShare = 16;   // next, every 16th row is used, then all rows
constexpr std::size_t kReseats = 12;       // widths at which a lobe of a sum is tried again
constexpr std::size_t kPolished = 6;       // number of minima that are solved on all rows

void add_minimum(const SampleStream& stream, Minimum m, std::vector<Minimum>& minima) {
  for (Minimum& other : minima) {
    if (!same_minimum(stream, m, other)) continue;
    const int basin = other.basin + m.basin;
    if (m.cost < other.cost) other = std::move(m);
    other.basin = basin;
    return;
  }
  minima.push_back(std::move(m));
}

void sort_minima(std::vector<Minimum>& minima) {
  std::ranges::sort(minima, {}, &Minimum::cost);
}

Minimum to_minimum(const Model& model, Solution s) {
  Minimum m{std::move(s.p), s.cost, 1, std::move(s.at_bound), s.termination, std::move(s.message)};
  canonicalise(model, m);
  return m;
}

// The work of solving.
struct Tally {
  int passes = 0, iterations = 0;
  bool interrupted = false;

  void add_to(SearchResult& result) const {
    result.passes += passes;
    result.iterations += iterations;
    result.interrupted = result.interrupted || interrupted;
  }
};

class Search {
 public:
  Search(const FitData& data, const Model& model, const Residual& residual, const FitOptions& options)
      : data_(data), model_(model), residual_(residual), options_(options) {}

  SearchResult run() {
    std::vector<std::vector<double>> starts = all_starts();
    result_.starts = int(starts.size());
    const bool coarse = data_.rows() > 2 * kCoarseRows;
    const FitData few = coarse ? thinned(data_, kCoarseRows) : FitData();
    const FitData& first = coarse ? few : data_;
    estimate_loss_scale(first, starts);
    std::vector<Minimum> minima = solve_all(first, starts, coarse ? 1e-8 : 1e-12);
    minima = with_scale_of_best(first, std::move(minima));
    if (coarse) {
      if (data_.rows() > kMiddleShare * kCoarseRows) {
        const FitData middle = thinned(data_, data_.rows() / kMiddleShare);
        minima = polish(middle, minima, 1e-8);
      }
      minima = polish(data_, minima, 1e-10);
    }
    return finished(std::move(minima));
  }

  // Starts from the minima of a few channels (few_channels.h) and keeps their shapes as starts.
  SearchResult run_from(SearchResult few, std::size_t shapes) {
    estimated_scale_ = residual_.loss.kind != LossFunction::Kind::none && residual_.loss.scale <= 0;
    if (estimated_scale_) residual_.loss.scale = few.loss_scale;
    std::vector<Minimum> starts = std::move(few.minima);
    result_ = std::move(few);
    result_.minima.clear();
    const SampleStream stream(data_, model_, residual_, options_.resolved_aperture());
    for (Minimum& m : starts) {
      std::vector<double> p = model_.initial();
      std::copy_n(m.p.begin(), shapes, p.begin());
      start_weights(stream, p);
      m.p = std::move(p);
    }
    return finished(with_scale_of_best(data_, polish(data_, starts, 1e-12)));
  }

 private:
  SearchResult finished(std::vector<Minimum> minima) {
    result_.minima = std::move(minima);
    result_.loss_scale = residual_.loss.scale;
    return std::move(result_);
  }

  // The scale was estimated from crude weights. Estimate the scale again from the best fit, and solve again
  // from there.
  std::vector<Minimum> with_scale_of_best(const FitData& data, std::vector<Minimum> minima) {
    if (!estimated_scale_ || minima.empty()) return minima;
    const SampleStream stream(data, model_, residual_, options_.resolved_aperture());
    residual_.loss.scale =
        std::max(robust_scale(stream, residual_.loss, minima[0].p), 1e-3 * residual_.loss.scale);
    return polish(data, minima, 1e-12);
  }

  std::vector<std::vector<double>> all_starts() {
    std::vector<std::vector<double>> starts;
    if (!options_.start.empty()) {
      std::vector<double> p = model_.initial();
      model_.apply_start(p);
      starts.push_back(std::move(p));
    }
    if (model_.shape_slots() == 0) {
      if (starts.empty()) starts.push_back(model_.initial());
      return starts;
    }
    if (options_.grid_starts)
      for (auto& p : grid_starts(model_)) starts.push_back(std::move(p));
    std::mt19937_64 random(options_.seed);
    for (int k = 0; k < options_.random_starts; ++k) starts.push_back(random_start(model_, random));
    return starts;
  }

  void estimate_loss_scale(const FitData& data, const std::vector<std::vector<double>>& starts) {
    const auto kind = residual_.loss.kind;
    if (kind == LossFunction::Kind::none || residual_.loss.scale > 0) return;
    double smallest = std::numeric_limits<double>::infinity();
    const SampleStream stream(data, model_, residual_, options_.resolved_aperture());
    for (std::vector<double> p : starts) {
      if (options_.stop()) break;
      start_weights(stream, p);
      smallest = std::min(smallest, robust_scale(stream, residual_.loss, p));
    }
    residual_.loss.scale = std::isfinite(smallest) && smallest > 1e-12 ? smallest : 1e-12;
    estimated_scale_ = true;
  }

  SolveOptions solver(double tolerance) const {
    SolveOptions o;
    o.tolerance = tolerance;
    o.interrupted = options_.interrupted;
    return o;
  }

  // In a sum, a lobe can be trapped by a few outliers and keep the other lobe from its place. Each lobe in
  // turn is removed and tried at every width of the grid, with the others held. The best result is solved
  // again.
  Minimum reseat_lobes(const SampleStream& stream, Minimum m, double tolerance, Tally& tally) const {
    if (model_.terms().size() < 2) return m;
    for (std::size_t s = 0; s < model_.shape_slots(); ++s) {
      const Slot& slot = model_.slots()[s];
      if (slot.kind != Slot::Kind::shape || slot.node > 0 || !slot.in_group(0) || options_.stop()) continue;
      std::vector<double> best;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < kReseats; ++k) {
        std::vector<double> p = m.p;
        for (std::size_t other = 0; other < model_.shape_slots(); ++other) {
          const Slot& same = model_.slots()[other];  // includes the same parameter of other channels
          if (same.same_parameter(slot)) p[other] = grid_value(same, k, kReseats);
        }
        start_weights(stream, p);
        ++tally.passes;
        const double cost = stream.normal_equations(p).cost;
        if (cost < least) {
          least = cost;
          best = std::move(p);
        }
      }
      if (best.empty()) continue;
      Minimum other = solve_one(stream, best, tolerance, tally);
      if (other.cost < m.cost) m = std::move(other);
    }
    return m;
  }

  Minimum solve_one(const SampleStream& stream, std::span<const double> start, double tolerance,
                    Tally& tally) const {
    Solution s = refine(stream, start, solver(tolerance));
    tally.passes += s.passes;
    tally.iterations += s.iterations;
    if (s.termination == Termination::interrupted) tally.interrupted = true;
    return to_minimum(model_, std::move(s));
  }

  // Solves the starts in parallel. The minima are compared in the order of the starts, so no result depends
  // on the threads.
  std::vector<Minimum> solve_all(const FitData& data, const std::vector<std::vector<double>>& starts,
                                 double tolerance) {
    const SampleStream stream(data, model_, residual_, options_.resolved_aperture());
    std::vector<std::optional<Minimum>> solved(starts.size());
    std::vector<Tally> tallies(starts.size());
    const auto solve_start = [&](std::size_t k) {
      if (options_.stop() && k > 0) {
        tallies[k].interrupted = true;
        return;
      }
      std::vector<double> p = starts[k];
      start_weights(stream, p);
      if (k == 0 && !options_.start.empty()) model_.apply_start_weights(p);
      solved[k] = reseat_lobes(stream, solve_one(stream, p, tolerance, tallies[k]), tolerance, tallies[k]);
    };
    io::parallel_for(starts.size(), solve_start, options_.threads);
    for (std::optional<Minimum>& s : solved)
      if (s && !std::isfinite(s->cost)) s.reset();
    return collected(stream, solved, tallies);
  }

  // Solves the best few minima again on other rows. The other minima are dropped.
  std::vector<Minimum> polish(const FitData& data, const std::vector<Minimum>& minima, double tolerance) {
    // A minimum far above the best cannot become the result, so it is dropped.
    std::size_t count = std::min<std::size_t>(minima.size(), 1);
    while (count < std::min(minima.size(), kPolished) && minima[count].cost <= 1.5 * minima[0].cost + 1e-300)
      ++count;
    const SampleStream stream(data, model_, residual_, options_.resolved_aperture());
    std::vector<std::optional<Minimum>> solved(count);
    std::vector<Tally> tallies(count);
    const auto solve_minimum = [&](std::size_t k) {
      if (options_.stop() && k > 0) {
        tallies[k].interrupted = true;
        return;
      }
      solved[k] = solve_one(stream, minima[k].p, tolerance, tallies[k]);
      solved[k]->basin = minima[k].basin;
    };
    io::parallel_for(count, solve_minimum, options_.threads);
    return collected(stream, solved, tallies);
  }

  // Collects the minima in the order of the starts.
  std::vector<Minimum> collected(const SampleStream& stream, std::vector<std::optional<Minimum>>& solved,
                                 const std::vector<Tally>& tallies) {
    std::vector<Minimum> minima;
    for (std::size_t k = 0; k < solved.size(); ++k) {
      tallies[k].add_to(result_);
      if (solved[k]) add_minimum(stream, std::move(*solved[k]), minima);
    }
    sort_minima(minima);
    return minima;
  }

  const FitData& data_;
  const Model& model_;
  Residual residual_;
  const FitOptions& options_;
  SearchResult result_;
  bool estimated_scale_ = false;
};

}  // namespace

Residual chosen_residual(const FitData& data, const FitOptions& options) {
  Residual r;
  r.metric = options.metric;
  if (options.metric == Metric::cube_root) {
    if (options.loss != Loss::none)
      throw InputError("--robust: cannot be used with --metric cube_root, which is already robust");
    // The cube root of a square has an infinite slope at 0. It is smoothed below a thousandth of the data.
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t c = 0; c < data.values.size(); ++c)
      for (std::size_t k = 0; k < data.rows(); ++k, ++count)
        sum += std::pow(data.values[c][k] * data.wi_z[k] / (data.sigma.empty() ? 1 : data.sigma[c][k]), 2);
    r.loss.kind = LossFunction::Kind::cube_root;
    r.loss.scale = std::max(1e-3 * std::sqrt(sum / double(count)), 1e-12);
    return r;
  }
  if (options.loss == Loss::huber) r.loss.kind = LossFunction::Kind::huber;
  if (options.loss == Loss::cauchy) r.loss.kind = LossFunction::Kind::cauchy;
  r.loss.scale = options.loss_scale;
  return r;
}

// Uses tuning constants with 95 % efficiency for the normal distribution.
double robust_scale(const SampleStream& stream, const LossFunction& loss, std::span<const double> p) {
  std::vector<double> size;
  for (const auto& channel : stream.residual_values(p))
    for (double r : channel) size.push_back(std::abs(r));
  const double deviation = 1.4826 * io::median(std::move(size));
  return deviation * (loss.kind == LossFunction::Kind::huber ? 1.345 : 2.385);
}

Solution refine(const SampleStream& stream, std::span<const double> start, const SolveOptions& options) {
  const Model& model = stream.model();
  const std::vector<double> low = model.low(), high = model.high();
  const Objective objective = [&](std::span<const double> p) { return stream.normal_equations(p); };
  if (!projects(stream)) return solve(objective, start, low, high, options);
  bool exact = false;
  Solution projected = solve_projected(stream, start, options, exact);
  if (exact) return projected;
  // Finish on the residuals themselves, which lose no digits.
  Solution s = solve(objective, projected.p, low, high, options);
  s.passes += projected.passes;
  s.iterations += projected.iterations;
  return s;
}

SearchResult find_minima(const FitData& data, const Model& model, const Residual& residual,
                         const FitOptions& options) {
  Search all(data, model, residual, options);
  const std::optional<FewChannels> few = few_channels(data, model, options);
  if (!few) return all.run();
  return all.run_from(Search(few->data, few->model, residual, options).run(), model.shape_slots());
}

}  // namespace brdf::fit
