// Compares partial derivatives with respect to every parameter: dual numbers against extrapolated
// differences.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include "validate/form/checks.h"
#include "validate/search/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kLargestGap = 1e-5;

// The derivatives of a subject that were compared, and the derivatives without a reference.
struct ComparedDerivatives {
  long compared = 0, without = 0;
};

// Returns an estimate of the rounding of f: how much it deviates from a straight line at steps much smaller
// than h. Sums of both sides remove the curvature. `f_at`: f at a value of the number.
template <class F>
double rounding_of(const F& f_at, double x, double slope, double h) {
  double most = DBL_EPSILON * std::abs(f_at(x));
  for (double step = h / 8; step > h / 256; step *= 0.8)
    most = std::max(most, std::abs((f_at(x + step) - f_at(x - step)) / 2 - slope * step));
  return most;
}

// Largest error of the derivatives at this pair, relative to the derivative or to 1e-3 f over the
// parameter's size, whichever is larger.
double worst_error(const Term& term, const Pair& pair, ComparedDerivatives& of) {
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
    const auto f_at = [&](double value) {
      std::vector<double> moved = x;
      moved[k] = value;
      double out;
      term.form->eval(values(moved), directions, &out);
      return out;
    };
    const auto central = [&](double h) { return (f_at(x[k] + h) - f_at(x[k] - h)) / (2 * h); };
    const double size = std::max(std::abs(x[k]), 1e-3), h = 2e-4 * size;
    const double coarse = central(h), fine = central(h / 2), best = (4 * fine - coarse) / 3;
    const double scale = std::max(std::abs(f[1 + k]), 1e-3 * std::abs(f[0]) / size);
    // If the differences themselves have not converged, they are no reference.
    if (scale < 1e-12 || !std::isfinite(best) || std::abs(fine - coarse) > 1e-3 * scale) {
      ++of.without;
      continue;
    }
    double error = std::abs(f[1 + k] - best) / scale;
    if (error > kLargestGap) {
      // The quotients divide the rounding of four values of f by small steps: 3 of it per step h at most. A
      // few values show a part of the rounding only.
      constexpr double kUnseen = 4;
      const double rounding = 3 * kUnseen * rounding_of(f_at, x[k], best, h) / h / scale;
      if (error <= rounding) {
        ++of.without;
        continue;
      }
      error -= std::min(rounding, error);
    }
    ++of.compared;
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
  ComparedDerivatives of;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> x = cover_point(k, dimensions, options.seed);
    // Parameters inside the tables' ranges, so that differences to both sides exist; directions off the
    // horizon.
    for (std::size_t d = 0; d < subject.dimensions(); ++d) x[d] = 0.02 + 0.96 * x[d];
    for (std::size_t d = subject.dimensions(); d < subject.dimensions() + 2; ++d) x[d] *= 0.3;
    const Material m = subject.at(x);
    const Pair pair = pair_of(subject, x);
    const double error = worst_error(m.terms[0], pair, of);
    if (!is_worst(error, finding.value)) continue;
    finding.value = error;
    finding.witness = pair_witness(subject, m, pair);
  }
  finding.evaluations = long(count * (4 * subject.dimensions() + 1));
  finding.bound = kLargestGap;
  finding.conclude(finding.value <= kLargestGap,
                   "derivatives by dual numbers agree with finite differences at " +
                       std::to_string(of.compared) + " values",
                   "derivatives by dual numbers disagree with finite differences");
  if (of.without > 0)
    finding.statement += "; at " + std::to_string(of.without) +
                         " more the differences are no reference, because they are rounding, have not "
                         "converged, or are nearly 0";
  if (of.compared == 0) finding.outcome = Outcome::undecided;
  return finding;
}

}  // namespace brdf::validate
