#include "fit/assess/left_out.h"

#include <atomic>
#include <cmath>

#include "fit/assess/errors.h"
#include "fit/solve/minima.h"
#include "io/parallel.h"

namespace brdf::fit {
namespace {

// Of the refits. Against a hundred iterations to 1e-10 the left-out values differ by less than 2e-3 of themselves
// where a fifth of the rows is left out, by less than 2e-4 for an eleventh.
constexpr int kIterations = 6;
constexpr double kTolerance = 1e-6;

struct Fold {
  RowRange held;
  std::vector<RowRange> kept;
};

std::vector<Fold> folds_of(const FitData& data) {
  std::vector<Fold> folds(data.groups.folds);
  for (const RowGroup& g : data.groups.groups) {
    RowRange& held = folds[g.fold].held;
    if (held.rows == 0) held.first = g.range.first;
    held.rows += g.range.rows;
  }
  for (Fold& f : folds) {
    const std::size_t last = f.held.first + f.held.rows;
    if (f.held.first > 0) f.kept.push_back({0, f.held.first});
    if (last < data.rows()) f.kept.push_back({last, data.rows() - last});
  }
  return folds;
}

// Mean loss of every group, and of all.
void add_losses(const FitData& data, const LossFunction& loss,
                const std::vector<std::vector<double>>& residuals, LeftOut& out) {
  std::vector<double> rho(kBlockRows), root(kBlockRows), curvature(kBlockRows);
  double all = 0;
  for (const RowGroup& g : data.groups.groups) {
    double sum = 0;
    for (const auto& channel : residuals)
      for (std::size_t done = 0; done < g.range.rows; done += kBlockRows) {
        const std::size_t rows = std::min(kBlockRows, g.range.rows - done);
        apply_loss(loss, rows, &channel[g.range.first + done], rho.data(), root.data(), curvature.data());
        for (std::size_t j = 0; j < rows; ++j) sum += rho[j];
      }
    all += sum;
    out.by_group.push_back(sum / double(g.range.rows * residuals.size()));
  }
  out.value = all / double(data.rows() * residuals.size());
}

double standard_error(const std::vector<double>& x) {
  const double n = double(x.size());
  double mean = 0, square = 0;
  for (double v : x) mean += v / n;
  for (double v : x) square += (v - mean) * (v - mean);
  return std::sqrt(square / (n * (n - 1)));
}

}  // namespace

std::optional<LeftOut> leave_out(const SampleStream& all, std::span<const double> solution, double loss_scale,
                                 const FitOptions& options) {
  const FitData& data = all.data();
  const std::vector<Fold> folds = folds_of(data);
  if (folds.size() < 2) return std::nullopt;
  LeftOut out;
  std::vector predictions(data.channels.size(), std::vector<double>(data.rows()));
  std::vector<double> medians(folds.size());
  out.solutions.resize(folds.size());
  SolveOptions solver;
  solver.tolerance = kTolerance;
  solver.max_iterations = kIterations;
  solver.starts_at_solution = true;
  solver.interrupted = options.interrupted;
  std::atomic<bool> stopped{false};
  const auto leave_fold_out = [&](std::size_t k) {
    if (options.stop()) stopped = true;
    if (stopped) return;
    const Fold& fold = folds[k];
    out.solutions[k] = refine(SampleStream(all, fold.kept), solution, solver).p;
    SampleStream(all, {fold.held}).values(out.solutions[k], predictions);
    medians[k] = relative_errors(data, predictions, fold.held).median;
  };
  io::parallel_for(folds.size(), leave_fold_out, options.threads);
  if (stopped) return std::nullopt;
  out.errors = relative_errors(data, predictions, {0, data.rows()});
  out.median_standard_error = standard_error(medians);
  LossFunction loss = all.residual().loss;
  loss.scale = loss_scale;
  add_losses(data, loss, all.residuals_of(std::move(predictions)), out);
  return out;
}

double black_loss(const FitData& data, const Model& model, const Residual& residual) {
  LeftOut black;
  const SampleStream stream(data, model, residual, 0);
  add_losses(data, residual.loss,
             stream.residuals_of(std::vector(data.channels.size(), std::vector<double>(data.rows()))), black);
  return black.value;
}

}  // namespace brdf::fit
