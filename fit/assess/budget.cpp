#include "fit/assess/budget.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/grounds.h"
#include "fit/assess/propagation.h"
#include "fit/assess/student.h"

namespace brdf::fit {
namespace {

using Values = std::vector<std::vector<double>>;  // [channel][row]

// Returns the errors of a source in units of the residual, with the sign of the change of the parameters.
Values scores_of(const io::BudgetSource& source, const RowBudget& rows, const Values& slopes) {
  Values scores = slopes;
  for (std::size_t c = 0; c < scores.size(); ++c)
    for (std::size_t k = 0; k < scores[c].size(); ++k)
      scores[c][k] *= rows.values[c][k] * rows.error(source, c, k);
  return scores;
}

std::vector<SourceCovariance> covariances(const SampleStream& stream, std::span<const double> p,
                                          const RowBudget& rows, const RowMatrix& inverse) {
  const FitData& data = stream.data();
  const Values slopes = stream.slopes_of(rows.values);
  std::vector<SourceCovariance> out;
  for (const io::BudgetSource& source : rows.budget->sources) {
    const Values scores = scores_of(source, rows, slopes);
    RowMatrix meat;
    switch (source.shared_by) {
      case io::SharedBy::row:
        meat = view_of(stream.meat_of(p, scores, Clusters::rows));
        break;
      case io::SharedBy::light: {
        const Matrix sums = stream.score_sums(p, scores, data.incidence);
        meat = view_of(sums).transpose() * view_of(sums);
        break;
      }
      case io::SharedBy::table: {
        const Matrix sums = stream.score_sums(p, scores, std::vector<std::uint32_t>(data.rows(), 0));
        meat = view_of(sums).transpose() * view_of(sums);
        break;
      }
    }
    out.push_back({source.name, source.shared_by != io::SharedBy::row, inverse * meat * inverse});
  }
  return out;
}

// Returns the columns of a matrix [value of a row][error that rows share], in units of the residual, and
// their products with the gradients of the residuals, [solver's parameter][error].
struct SharedErrors {
  RowMatrix columns, by_parameter;
};

SharedErrors shared_errors(const SampleStream& stream, std::span<const double> p, const RowBudget& rows) {
  constexpr std::size_t kMostErrors = 64;  // more errors of lights are left among the scatter
  const FitData& data = stream.data();
  const Values slopes = stream.slopes_of(rows.values);
  const std::size_t values = slopes.size() * data.rows();
  SharedErrors out{RowMatrix(values, 0), RowMatrix(stream.model().size(), 0)};
  for (const io::BudgetSource& source : rows.budget->sources) {
    if (source.shared_by == io::SharedBy::row || !(source.standard_uncertainty > 0)) continue;
    const std::vector<std::uint32_t> cluster =
        source.shared_by == io::SharedBy::light ? data.incidence : std::vector<std::uint32_t>(data.rows(), 0);
    const Values scores = scores_of(source, rows, slopes);
    const Matrix sums = stream.score_sums(p, scores, cluster);
    const Eigen::Index first = out.columns.cols(), count = Eigen::Index(sums.rows);
    if (std::size_t(first + count) > kMostErrors) continue;
    out.columns.conservativeResize(Eigen::NoChange, first + count);
    out.columns.rightCols(count).setZero();
    for (std::size_t c = 0; c < scores.size(); ++c)
      for (std::size_t k = 0; k < data.rows(); ++k)
        out.columns(Eigen::Index(c * data.rows() + k), first + cluster[k]) = scores[c][k];
    out.by_parameter.conservativeResize(Eigen::NoChange, first + count);
    out.by_parameter.rightCols(count) = view_of(sums).transpose();
  }
  return out;
}

// Returns the residuals without the most likely errors that rows share. Each of these errors has the standard
// deviation 1 that the budget states, and the noise of the residuals is what remains. The fit has already
// taken a part of each error into its parameters.
Values without_shared_errors(const SampleStream& stream, std::span<const double> p, const RowBudget& rows,
                             const RowMatrix& inverse) {
  const SharedErrors shared = shared_errors(stream, p, rows);
  Values out = stream.residuals_of(rows.values);
  Eigen::VectorXd r(shared.columns.rows());
  Eigen::Index next = 0;
  for (const std::vector<double>& channel : out)
    for (const double x : channel) r(next++) = x;
  const double all = r.squaredNorm();
  if (shared.columns.cols() == 0 || !(all > 0)) return out;
  const RowMatrix gram = shared.columns.transpose() * shared.columns -
                         shared.by_parameter.transpose() * inverse * shared.by_parameter;
  const Eigen::VectorXd cross = shared.columns.transpose() * r;
  constexpr int kPasses = 8;
  double left = all;
  Eigen::VectorXd errors;
  for (int pass = 0; pass < kPasses; ++pass) {
    const double noise = std::max(left, 1e-12 * all) / double(r.size());
    const RowMatrix ridge = gram + noise * RowMatrix::Identity(gram.rows(), gram.cols());
    errors = ridge.ldlt().solve(cross);
    left = std::clamp(all - 2 * errors.dot(cross) + errors.dot(gram * errors), 0.0, all);
  }
  // The parameters' part is a difference of residuals: a Jacobian is never stored.
  const Eigen::VectorXd moved = inverse * (shared.by_parameter * errors);
  std::vector<double> there(p.begin(), p.end());
  for (std::size_t k = 0; k < there.size(); ++k) there[k] += moved(Eigen::Index(k));
  const Values at_moved = stream.residual_values(there), at = out;
  r -= shared.columns * errors;
  next = 0;
  for (std::size_t c = 0; c < out.size(); ++c)
    for (std::size_t k = 0; k < out[c].size(); ++k) out[c][k] = r(next++) + at_moved[c][k] - at[c][k];
  return out;
}

// Returns the covariance from the scatter without the errors that rows share. With them these errors would
// count twice: as sources, and as the scatter that they cause. An error that all channels share leaves the
// differences between channels as uncertain as they were.
RowMatrix own_scatter(const SampleStream& stream, std::span<const double> p, const RowBudget& rows,
                      const RowMatrix& inverse, const RowMatrix& scatter) {
  if (stream.data().rows() > kManyRows) return scatter;
  const auto covariance = [&](const Values& residuals) -> RowMatrix {
    return inverse * view_of(stream.meat_of(p, residuals, Clusters::rows)) * inverse;
  };
  return shrunk(scatter, covariance(stream.residuals_of(rows.values)),
                covariance(without_shared_errors(stream, p, rows, inverse)));
}

// Returns the ratio up to which a variance of the scatter is not larger than the variance of the budget
// beyond chance: the 95 % quantile of an estimate with these degrees of freedom, of first order.
double chance_ratio(double freedom) {
  constexpr double kQuantile = 1.645;
  return 1 + kQuantile * std::sqrt(2 / std::max(freedom, 1.0));
}

// Returns a standard uncertainty with its parts. `scatter` is that of the scatter of the rows.
Combined combined_of(const Eigen::VectorXd& gradient, double scatter, double freedom,
                     const std::vector<SourceCovariance>& sources) {
  Combined out;
  double shared = 0, own = 0;
  std::vector<Combined::Part> own_parts;
  for (const SourceCovariance& s : sources) {
    const double variance = std::max(gradient.dot(s.covariance * gradient), 0.0);
    (s.is_shared ? shared : own) += variance;
    (s.is_shared ? out.parts : own_parts).push_back({s.source, std::sqrt(variance)});
  }
  const bool is_scatter = scatter * scatter > chance_ratio(freedom) * own;
  if (is_scatter)
    out.parts.push_back({kScatterSource, scatter});
  else
    out.parts.insert(out.parts.end(), own_parts.begin(), own_parts.end());
  out.rowwise = is_scatter ? scatter : std::sqrt(own);
  out.shared = std::sqrt(shared);
  out.standard_uncertainty = std::hypot(out.rowwise, out.shared);
  return out;
}

}  // namespace

Extent with_budget(const Reported& r, const Model& model, Extent interval, double kept, double extra) {
  const double reach = t_quantile(ParameterCovariance::kStated) * error_on_scale(r, model, extra);
  const Slot* slot = r.scale == kNoSlot ? nullptr : &model.slots()[r.scale];
  const auto scaled = [&](double x) { return slot ? slot->to_solver(x) : x; };
  const double middle = scaled(r.estimate.value);
  const auto end = [&](double limit, double sign) {
    const double u = middle + sign * std::hypot(kept * (scaled(limit) - middle), reach);
    return std::clamp(slot ? slot->to_natural(u) : u, r.min, r.max);
  };
  return {end(interval.low, -1), end(interval.high, 1)};
}

InstrumentCovariance instrument_covariance(const SampleStream& stream, std::span<const double> p,
                                           const RowMatrix& inverse, const RowMatrix& scatter,
                                           double freedom) {
  InstrumentCovariance out;
  out.rows = row_budget(stream, p);
  out.sources = covariances(stream, p, out.rows, inverse);
  RowMatrix own = RowMatrix::Zero(inverse.rows(), inverse.cols()), shared = own;
  for (const SourceCovariance& s : out.sources) (s.is_shared ? shared : own) += s.covariance;
  out.scatter = scatter;
  out.left = own_scatter(stream, p, out.rows, inverse, scatter);
  out.freedom = freedom;
  out.rowwise = own.isZero(0) ? out.left : larger_of(own, out.left, 1, chance_ratio(freedom));
  out.total = out.rowwise + shared;
  return out;
}

void add_budget(const InstrumentCovariance& instrument, const Model& model, Reported& r) {
  Estimate& e = r.estimate;
  if (r.gradient.empty() || std::isnan(e.low) || e.status == Status::unidentified) return;
  const Eigen::VectorXd g = gradient_vector(r, instrument.total.rows());
  const double before = g.dot(instrument.scatter * g), after = g.dot(instrument.left * g);
  const double kept = before > 0 ? std::sqrt(std::clamp(after / before, 0.0, 1.0)) : 1;
  const double scatter = e.standard_error, freedom = std::isnan(e.deciding)
                                                         ? instrument.freedom
                                                         : std::min(e.deciding, instrument.freedom);
  e.budget = combined_of(g, kept * scatter, freedom, instrument.sources);
  const bool has_scatter = scatter > 0;
  const Extent widened = with_budget(r, model, {e.low, e.high}, has_scatter ? e.budget->rowwise / scatter : 1,
                                     has_scatter ? e.budget->shared : e.budget->standard_uncertainty);
  if (!e.low_open) e.low = widened.low;
  if (!e.high_open) e.high = widened.high;
  e.low_open = e.low_open || e.low <= r.min;
  e.high_open = e.high_open || e.high >= r.max;
  // At a bound the interval has one side, and a standard uncertainty has no meaning.
  if (e.status == Status::at_bound)
    e.budget.reset();
  else
    e.standard_error = e.budget->standard_uncertainty;
}

}  // namespace brdf::fit
