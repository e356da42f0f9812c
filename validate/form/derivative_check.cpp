// Compares partial derivatives with respect to every parameter: dual numbers against extrapolated
// differences.
#include <algorithm>
#include <cmath>

#include "validate/form/checks.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kLargestGap = 1e-5;

// Largest error of the derivatives at this pair, relative to the derivative or to 1e-3 f over the
// parameter's size, whichever is larger.
double worst_error(const Term& term, const Pair& pair) {
  const std::size_t shapes = term.shape[0].size();
  std::vector<double> x = term.shape[0];
  x.insert(x.end(), term.weights[0].begin(), term.weights[0].end());
  const auto values = [&](const std::vector<double>& at) {
    const std::span<const double> all(at), weights = all.subspan(shapes);
    return ParameterValues<double>{weights, weights, all.first(shapes)};
  };
  const Directions<double> directions = one_pair(pair.wi, pair.wo);
  std::vector<double> f(1 + x.size());
  term.form->gradient(values(x), directions, {f.data(), 1});
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto central = [&](double h) {
      std::vector<double> up = x, down = x;
      up[k] += h;
      down[k] -= h;
      double above, below;
      term.form->eval(values(up), directions, &above);
      term.form->eval(values(down), directions, &below);
      return (above - below) / (2 * h);
    };
    const double size = std::max(std::abs(x[k]), 1e-3), h = 2e-4 * size;
    const double coarse = central(h), fine = central(h / 2), best = (4 * fine - coarse) / 3;
    const double scale = std::max(std::abs(f[1 + k]), 1e-3 * std::abs(f[0]) / size);
    // If the differences themselves have not converged, they are no reference.
    if (scale < 1e-12 || !std::isfinite(best) || std::abs(fine - coarse) > 1e-3 * scale) continue;
    const double error = std::abs(f[1 + k] - best) / scale;
    if (is_worst(error, worst)) worst = error;
  }
  return worst;
}

}  // namespace

Finding check_derivatives(const Subject& subject, const CheckOptions& options) {
  if (!subject.of_form())
    return not_applicable(subject.name(), "derivatives", "derivatives are a property of forms");
  if (!info(*subject.of_form()).differentiable)
    return not_applicable(subject.name(), "derivatives", "the form has no derivatives");
  Finding finding{subject.name(), "derivatives"};
  const std::size_t count = options.effort == Effort::full ? 20000 : 2000,
                    dimensions = pair_dimensions(subject);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> x = cover_point(k, dimensions, options.seed);
    // Parameters inside the tables' ranges, so that differences to both sides exist; directions off the
    // horizon.
    for (std::size_t d = 0; d < subject.dimensions(); ++d) x[d] = 0.02 + 0.96 * x[d];
    for (std::size_t d = subject.dimensions(); d < subject.dimensions() + 2; ++d) x[d] *= 0.3;
    const Material m = subject.at(x);
    const Pair pair = pair_of(subject, x);
    const double error = worst_error(m.terms[0], pair);
    if (!is_worst(error, finding.value)) continue;
    finding.value = error;
    finding.witness = pair_witness(subject, m, pair);
  }
  finding.evaluations = long(count * (4 * subject.dimensions() + 1));
  finding.bound = kLargestGap;
  finding.conclude(finding.value <= kLargestGap, "derivatives by dual numbers agree with finite differences",
                   "derivatives by dual numbers disagree with finite differences");
  return finding;
}

}  // namespace brdf::validate
