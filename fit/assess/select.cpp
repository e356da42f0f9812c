#include "fit/assess/select.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/assess.h"
#include "fit/solve/minima.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kFolds = 5;
constexpr std::size_t kMostRows = 20000;
constexpr double kPerfect = 1e-9;  // errors below this are rounding

// Without a solution no error is known: such a form ranks last.
double error_of(const FormFit& f) {
  const double error = f.cross_validated_error.value_or(f.median_relative_error);
  return f.solved() && std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

// Three significant digits: differences beyond them say nothing about a surface.
double rounded(double error) {
  if (std::isinf(error)) return error;
  const double e = std::max(error, kPerfect);
  const double unit = std::pow(10.0, std::floor(std::log10(e)) - 2);
  return std::round(e / unit) * unit;
}

}  // namespace

CrossValidation cross_validate(const FitData& all, const Model& model, const Residual& residual,
                               std::span<const double> solution, const FitOptions& options) {
  const bool many = all.rows() > kMostRows;
  const FitData few = many ? thinned(all, kMostRows) : FitData();
  const FitData& data = many ? few : all;
  const std::uint32_t incidences =
      data.rows() ? *std::max_element(data.incidence.begin(), data.incidence.end()) + 1 : 0;
  std::vector<std::size_t> fold(data.rows());
  for (std::size_t k = 0; k < data.rows(); ++k)
    fold[k] = (incidences >= kFolds ? data.incidence[k] : k) % kFolds;
  std::vector predictions(data.channels.size(), std::vector<double>(data.rows()));
  std::vector<double> medians;
  SolveOptions solver;
  solver.tolerance = 1e-8;
  solver.interrupted = options.interrupted;
  for (std::size_t f = 0; f < kFolds; ++f) {
    std::vector<bool> train(data.rows()), test(data.rows());
    for (std::size_t k = 0; k < data.rows(); ++k) (fold[k] == f ? test : train)[k] = true;
    const FitData training = subset(data, train), held = subset(data, test);
    if (training.rows() == 0 || held.rows() == 0) continue;
    const SampleStream stream(training, model, residual, options.aperture);
    const Solution s = refine(stream, solution, solver);
    const auto values = SampleStream(held, model, residual, options.aperture).values(s.p);
    medians.push_back(median_relative_error(held, values));
    for (std::size_t c = 0; c < values.size(); ++c) {
      std::size_t next = 0;
      for (std::size_t k = 0; k < data.rows(); ++k)
        if (test[k]) predictions[c][k] = values[c][next++];
    }
  }
  CrossValidation out;
  out.error = median_relative_error(data, predictions);
  double mean = 0, square = 0;
  for (double m : medians) mean += m / double(medians.size());
  for (double m : medians) square += (m - mean) * (m - mean);
  if (medians.size() > 1)
    out.standard_error = std::sqrt(square / double(medians.size() * (medians.size() - 1)));
  return out;
}

void rank(FitResult& result) {
  std::stable_sort(result.ranking.begin(), result.ranking.end(), [](const FormFit& a, const FormFit& b) {
    const double x = rounded(error_of(a)), y = rounded(error_of(b));
    if (x != y) return x < y;
    if (usable(a.verdict) != usable(b.verdict)) return usable(a.verdict);
    return a.parameters < b.parameters;
  });
  // One standard error: a simpler model that is no worse than the best one's own uncertainty is preferred.
  result.recommended = 0;
  if (result.ranking.empty()) return;
  const FormFit* best = nullptr;
  for (const FormFit& f : result.ranking)
    if (!best && usable(f.verdict)) best = &f;
  if (!best) return;
  const double limit = error_of(*best) + best->cross_validated_standard_error.value_or(0) + kPerfect;
  const FormFit* simplest = best;
  for (const FormFit& f : result.ranking)
    if (usable(f.verdict) && error_of(f) <= limit && f.parameters < simplest->parameters) simplest = &f;
  result.recommended = std::size_t(simplest - result.ranking.data());
}

}  // namespace brdf::fit
