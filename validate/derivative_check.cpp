// Partial derivatives with respect to every parameter, by dual numbers and by extrapolated differences.
#include <algorithm>
#include <cmath>

#include "brdf/dual.h"
#include "validate/checks.h"
#include "validate/pair_search.h"

namespace brdf::validate {
namespace {

constexpr double kBound = 1e-5;

// Value with the parameters x: the shape's, then the weights.
template <class F, class T>
T value_of(F form, const std::vector<T>& x, const Geometry<double>& g) {
  using Shape = typename F::template Shape<T>;
  using Weights = typename F::template Weights<T>;
  const std::span<const T> all(x);
  const auto shape = from_values<Shape>(all.first(parameter_count<Shape>));
  const auto weights = from_values<Weights>(all.subspan(parameter_count<Shape>));
  return eval(form, weights, weights, shape, g);
}

// Largest error of the form's derivatives there, relative to the derivative and to f over the parameter's
// size.
template <class F>
double worst_error(F form, const Term& term, const Geometry<double>& g) {
  constexpr int kCount = int(parameter_count<typename F::template Shape<double>> +
                             parameter_count<typename F::template Weights<double>>);
  using D = Dual<double, kCount>;
  std::vector<double> x(term.shape[0].begin(), term.shape[0].end());
  x.insert(x.end(), term.weights[0].begin(), term.weights[0].end());
  std::vector<D> dual;
  for (std::size_t k = 0; k < x.size(); ++k) dual.push_back(D::variable(x[k], k));
  const D f = value_of(form, dual, g);
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const auto central = [&](double h) {
      std::vector<double> up = x, down = x;
      up[k] += h;
      down[k] -= h;
      return (value_of(form, up, g) - value_of(form, down, g)) / (2 * h);
    };
    const double size = std::max(std::abs(x[k]), 1e-3), h = 2e-4 * size;
    const double coarse = central(h), fine = central(h / 2), best = (4 * fine - coarse) / 3;
    const double scale = std::max(std::abs(f.v[k]), 1e-3 * std::abs(f.a) / size);
    // Where the differences themselves have not settled nothing can be said.
    if (scale < 1e-12 || !std::isfinite(best) || std::abs(fine - coarse) > 1e-3 * scale) continue;
    worst = std::max(worst, std::abs(f.v[k] - best) / scale);
  }
  return worst;
}

}  // namespace

Finding check_derivatives(const Subject& subject, const CheckOptions& options) {
  Finding finding{subject.name(), "derivatives"};
  if (!subject.of_form()) {
    finding.verdict = Verdict::not_applicable;
    finding.statement = "derivatives are a property of forms";
    return finding;
  }
  const std::size_t count = options.effort == Effort::full ? 20000 : 2000,
                    dimensions = pair_dimensions(subject);
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> x = cover_point(k, dimensions, options.seed);
    // Inside the tables' ranges, where differences to both sides exist; directions off the horizon.
    for (std::size_t d = 0; d < subject.dimensions(); ++d) x[d] = 0.02 + 0.96 * x[d];
    for (std::size_t d = subject.dimensions(); d < subject.dimensions() + 2; ++d) x[d] *= 0.3;
    const Material m = subject.at(x);
    const Pair pair = pair_of(subject, x);
    const double error =
        std::visit([&](auto form) { return worst_error(form, m.terms[0], geometry(pair.wi, pair.wo)); },
                   m.terms[0].form);
    if (error < finding.value) continue;
    finding.value = error;
    finding.witness = pair_witness(subject, m, pair);
  }
  finding.evaluations = long(count * (4 * subject.dimensions() + 1));
  finding.bound = kBound;
  finding.verdict = finding.value <= kBound ? Verdict::pass : Verdict::fail;
  finding.statement = finding.verdict == Verdict::pass
                          ? "derivatives by dual numbers agree with differences"
                          : "derivatives by dual numbers disagree with differences";
  return finding;
}

}  // namespace brdf::validate
