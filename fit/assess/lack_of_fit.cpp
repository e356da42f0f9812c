#include "fit/assess/lack_of_fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fit/assess/budget.h"
#include "fit/assess/reported.h"
#include "fit/assess/student.h"
#include "fit/solve/minima.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

constexpr double kThetaH[] = {0, 2, 5, 10, 20, 30, 45, 60, 90}, kThetaD[] = {0, 15, 30, 45, 60, 75, 90};
constexpr std::size_t kFewestRows = 8;
// Degrees added before the cell is determined. Instruments measure at the edges of cells, and rounding must
// not decide.
constexpr double kInside = 1e-6;
constexpr double kRoundingOfRatios = 1e-9;  // of ln(measured/model)
constexpr double kNormal = 1.4826;  // standard deviation over median deviation of the normal distribution

template <std::size_t n>
std::size_t cell(const double (&edges)[n], double angle) {
  return std::size_t(std::clamp(std::upper_bound(edges, edges + n, angle + kInside) - edges,
                                std::ptrdiff_t(1), std::ptrdiff_t(n - 1))) -
         1;
}

struct Cell {
  std::size_t rows = 0;
  double loss = 0;
  std::vector<double> excess;  // ln(measured/model)
};

// Returns whether the median of a cell deviates from a ratio of 1 by more than five of its standard errors,
// and by a fifth of its scatter. A cell is not off if the noise is unknown, or if the deviation is
// rounding.
bool is_off(const std::vector<double>& excess, double noise) {
  const double middle = io::median(excess);
  if (!(noise > 0) || std::abs(middle) < kRoundingOfRatios) return false;
  std::vector<double> sizes;
  for (double x : excess) sizes.push_back(std::abs(x - middle));
  const double scatter = std::max(noise, kNormal * io::median(std::move(sizes)));
  return std::abs(middle) > scatter * std::max(0.2, 5 * 1.2533 / std::sqrt(double(excess.size())));
}

LackOfFit of_cells(const SampleStream& stream, const std::vector<std::vector<double>>& model, double noise) {
  const FitData& data = stream.data();
  const auto residuals = stream.residuals_of(model);
  std::map<std::pair<std::size_t, std::size_t>, Cell> cells;
  double all = 0;
  for (std::size_t k = 0; k < data.rows(); ++k) {
    const HalfAngles angles = half_angles(data, k);
    Cell& c = cells[{cell(kThetaH, angles.theta_h), cell(kThetaD, angles.theta_d)}];
    ++c.rows;
    for (std::size_t channel = 0; channel < model.size(); ++channel) {
      double rho = 0, root = 0, curvature = 0;
      apply_loss(stream.residual().loss, 1, &residuals[channel][k], &rho, &root, &curvature);
      c.loss += rho;
      all += rho;
      const double f = model[channel][k], g = data.values[channel][k];
      if (f > 0 && g > 0) c.excess.push_back(std::log(g / f));
    }
  }
  LackOfFit out;
  double largest = 0;
  for (auto& [at, c] : cells) {
    const double mean = c.loss / double(c.rows);
    if (c.rows < kFewestRows || c.excess.empty()) continue;
    const bool off = is_off(c.excess, noise), is_worst = mean > largest;
    out.beyond_scatter = out.beyond_scatter || off;
    if (!off && !is_worst) continue;
    const WorstRegion region{
        {{kThetaH[at.first], kThetaD[at.second]}, {kThetaH[at.first + 1], kThetaD[at.second + 1]}},
        c.rows,
        std::exp(io::median(std::move(c.excess))),
        c.loss / all};
    if (is_worst) largest = mean, out.worst = region;
    if (off) out.others.push_back(region);
  }
  std::erase_if(out.others, [&](const WorstRegion& r) {
    const HalfAngles &own = r.range.low, &of_worst = out.worst->range.low;
    return own.theta_h == of_worst.theta_h && own.theta_d == of_worst.theta_d;
  });
  std::ranges::stable_sort(out.others, std::greater(), &WorstRegion::share);
  if (out.others.size() > LackOfFit::kMostOthers) out.others.resize(LackOfFit::kMostOthers);
  return out;
}

Extent range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

// Returns the values of one reported parameter on the scale on which its intervals are symmetric.
std::vector<double> on_interval_scale(const Reported& r, const std::vector<double>& natural,
                                      const Model& model) {
  if (r.scale == kNoSlot) return natural;
  std::vector<double> out;
  for (double v : natural) out.push_back(model.slots()[r.scale].to_solver(v));
  return out;
}

struct Jackknife {
  double error = 0, freedom = 0;
};

// Computes the jackknife error of a value from its values without each fold: the root of its variance plus
// its squared bias. The degrees of freedom belong to a variance of values with this kurtosis
// (Satterthwaite), in case a few folds dominate.
Jackknife jackknife(double value, const std::vector<double>& without) {
  const double n = double(without.size());
  double mean = 0, square = 0, fourth = 0;
  for (double v : without) mean += v / n;
  for (double v : without) {
    const double d = (v - mean) * (v - mean);
    square += d;
    fourth += d * d;
  }
  if (!(square > 0)) return {0, n - 1};
  const double kurtosis = n * fourth / (square * square);
  return {std::hypot(std::sqrt(square * (n - 1) / n), (n - 1) * (mean - value)),
          std::clamp(2 * n / std::max(kurtosis - 1, 1e-9), 1.0, n - 1)};
}

}  // namespace

LackOfFit lack_of_fit(const SampleStream& stream, const std::vector<std::vector<double>>& model,
                      std::optional<double> noise) {
  LackOfFit out = of_cells(stream, model, noise.value_or(0));
  std::vector<double> sizes;
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = 0; k < stream.data().rows(); ++k)
      if (const double f = model[c][k], g = stream.data().values[c][k]; f > 0 && g > 0)
        sizes.push_back(std::abs(std::log(g / f)));
  const double residual = sizes.empty() ? kUnknown : kNormal * io::median(std::move(sizes));
  out.exact = residual < kRoundingOfRatios;
  if (noise && *noise > 0 && !out.exact && !std::isnan(residual))
    out.residual_over_scatter = residual / *noise;
  out.beyond_scatter = out.beyond_scatter || out.residual_over_scatter.value_or(0) > kBeyond;
  return out;
}

std::vector<std::vector<double>> under_other_metrics(const SampleStream& stream,
                                                     std::span<const double> solution,
                                                     const FitOptions& options) {
  constexpr int kIterations = 10;
  std::vector<std::vector<double>> out;
  for (const Metric metric : kResiduals) {
    FitOptions other = options;
    other.metric = metric;
    other.loss_scale = 0;
    if (metric == options.metric || options.stop()) continue;
    if (metric == Metric::cube_root) other.loss = Loss::none;
    const FitData& data = stream.data();
    const FitData part = within_domain(data, metric);
    const FitData& defined = part.rows() > 0 ? part : data;
    Residual residual = chosen_residual(defined, other);
    if (other.loss != Loss::none)
      residual.loss.scale =
          robust_scale(SampleStream(defined, stream.model(), residual, options.resolved_aperture()),
                       residual.loss, solution);
    SolveOptions solver;
    solver.tolerance = 1e-5;
    solver.max_iterations = kIterations;
    solver.interrupted = options.interrupted;
    const Solution s = refine(SampleStream(defined, stream.model(), residual, options.resolved_aperture()),
                              solution, solver);
    if (std::isfinite(s.cost)) out.push_back(s.p);
  }
  return out;
}

void add_movement(const Model& model, std::span<const double> solution,
                  const std::vector<std::vector<double>>& folds,
                  const std::vector<std::vector<double>>& metrics, std::vector<Estimate>& estimates) {
  const std::vector<Reported> all = reported_parameters(model, solution);
  const auto values = [&](const std::vector<std::vector<double>>& points) {
    std::vector<std::vector<double>> out(all.size());
    for (const auto& p : points) {
      const std::vector<Reported> there = reported_parameters(model, p);
      for (std::size_t k = 0; k < all.size(); ++k) out[k].push_back(there[k].estimate.value);
    }
    return out;
  };
  const auto by_fold = values(folds), by_metric = values(metrics);
  for (std::size_t k = 0; k < all.size(); ++k) {
    Estimate& e = estimates[k];
    if (e.status == Status::fixed) continue;
    if (!metrics.empty()) e.other_metrics = range_of(by_metric[k]);
    if (folds.size() < 2) continue;
    e.left_out = range_of(by_fold[k]);
    const Jackknife moved = jackknife(on_interval_scale(all[k], {all[k].estimate.value}, model)[0],
                                      on_interval_scale(all[k], by_fold[k], model));
    Extent extent = extent_of(all[k], model, solution, t_quantile(moved.freedom) * moved.error);
    if (e.budget) extent = with_budget(all[k], model, extent, 1, e.budget->shared);
    e.with_lack_of_fit = {std::min(extent.low, e.low), std::max(extent.high, e.high)};
  }
}

}  // namespace brdf::fit
