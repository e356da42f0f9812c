#include "fit/assess/left_out.h"

#include <cmath>

#include "fit/assess/errors.h"
#include "io/files/parallel.h"

namespace brdf::fit {
namespace {

// Computes the mean loss of every group, and of all values.
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

LeftOut leave_out(const SampleStream& all, std::vector<std::vector<double>> solutions, double loss_scale,
                  const FitOptions& options) {
  const FitData& data = all.data();
  LeftOut out;
  out.solutions = std::move(solutions);
  std::vector predictions(data.channels.size(), std::vector<double>(data.rows()));
  std::vector<double> medians(out.solutions.size());
  const auto predict_fold = [&](std::size_t k) {
    const RowRange held = rows_of_fold(data.groups, k);
    SampleStream(all, {held}).values(out.solutions[k], predictions);
    medians[k] = relative_errors(data, predictions, held).median;
  };
  io::parallel_for(out.solutions.size(), predict_fold, options.threads);
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
