#include "fit/design/model_error.h"

#include <algorithm>
#include <cmath>

#include "io/files/error.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

// Ratios of the error to the noise that are tried.
constexpr double kRatios[] = {0, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 6, 8, 12};
constexpr double kDetected = 2.7;     // of the logarithm of the likelihood
constexpr double kDependent = 1e-10;  // of an eigenvalue relative to the largest
constexpr double kLeastNoise = 1e-7;  // relative; smaller residuals are rounding

// The residuals of the usable rows with their gradients, on scaled axes.
struct LinearResiduals {
  std::vector<std::size_t> rows;
  std::vector<Eigen::VectorXd> residuals;  // [channel]
  std::vector<RowMatrix> gradients;        // [channel]
  Eigen::Index rank = 0;
  double values() const { return double(rows.size() * residuals.size()); }
};

// Replaces the gradients by their components along the directions that the values determine.
void keep_determined(LinearResiduals& out) {
  const Eigen::Index n = out.gradients.front().cols();
  RowMatrix gram = RowMatrix::Zero(n, n);
  for (const RowMatrix& g : out.gradients) gram += g.transpose() * g;
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k)
    if (gram(k, k) > 0) scale(k) = 1 / std::sqrt(gram(k, k));
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(scale.asDiagonal() * gram * scale.asDiagonal());
  const double largest = eigen.eigenvalues()(n - 1);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < n; ++k)
    if (eigen.eigenvalues()(k) > kDependent * largest && largest > 0) kept.push_back(k);
  out.rank = Eigen::Index(kept.size());
  const RowMatrix axes = scale.asDiagonal() * eigen.eigenvectors()(Eigen::all, kept);
  for (RowMatrix& g : out.gradients) g = g * axes;
}

LinearResiduals linear_residuals(const DesignRows& rows, const std::vector<std::vector<double>>& residuals) {
  LinearResiduals out;
  for (std::size_t k = 0; k < rows.rows(); ++k) {
    bool counts = rows.usable[k];
    for (const std::vector<double>& column : residuals) counts = counts && std::isfinite(column[k]);
    if (counts) out.rows.push_back(k);
  }
  const auto n = Eigen::Index(out.rows.size());
  for (std::size_t c = 0; c < residuals.size(); ++c) {
    Eigen::VectorXd r(n);
    RowMatrix g(n, rows.parameters());
    for (Eigen::Index k = 0; k < n; ++k) {
      r(k) = residuals[c][out.rows[std::size_t(k)]];
      g.row(k) = rows.gradients[c].row(Eigen::Index(out.rows[std::size_t(k)]));
    }
    out.residuals.push_back(std::move(r));
    out.gradients.push_back(std::move(g));
  }
  if (n > 0) keep_determined(out);
  return out;
}

struct RestrictedLikelihood {
  double log = 0, noise = 0;
};

// Computes the restricted likelihood for a ratio of error to noise, at the most likely noise unless it is
// known.
RestrictedLikelihood restricted_likelihood(const LinearResiduals& l, const RowMatrix& correlations,
                                           double ratio, std::optional<double> known) {
  const Eigen::Index n = correlations.rows();
  RowMatrix variance = ratio * ratio * correlations;
  variance.diagonal().array() += 1;
  const Eigen::LLT<RowMatrix> root(variance);
  const RowMatrix lower = root.matrixL();
  double logs = 0, square_sum = 0;
  RowMatrix information = RowMatrix::Zero(l.rank, l.rank);
  Eigen::VectorXd along = Eigen::VectorXd::Zero(l.rank);
  for (std::size_t c = 0; c < l.residuals.size(); ++c) {
    const RowMatrix g = lower.triangularView<Eigen::Lower>().solve(l.gradients[c]);
    const Eigen::VectorXd r = lower.triangularView<Eigen::Lower>().solve(l.residuals[c]);
    information += g.transpose() * g;
    along += g.transpose() * r;
    square_sum += r.squaredNorm();
    for (Eigen::Index k = 0; k < n; ++k) logs += 2 * std::log(lower(k, k));
  }
  const Eigen::LDLT<RowMatrix> solved(information);
  if (l.rank > 0) {
    square_sum -= along.dot(solved.solve(along));
    for (Eigen::Index k = 0; k < l.rank; ++k) logs += std::log(std::max(solved.vectorD()(k), 1e-300));
  }
  const double freedom = l.values() - double(l.rank), sum = std::max(square_sum, 0.0);
  const double noise = known ? *known : std::max(std::sqrt(sum / freedom), kLeastNoise);
  return {-0.5 * logs - freedom * std::log(noise) - 0.5 * sum / (noise * noise), noise};
}

}  // namespace

NoiseAndError noise_and_error(const DesignRows& rows, const std::vector<std::vector<double>>& residuals,
                              const std::string& source, std::optional<double> noise,
                              std::optional<double> error) {
  const LinearResiduals l = linear_residuals(rows, residuals);
  NoiseAndError out;
  out.freedom = l.values() - double(l.rank);
  if (!noise && out.freedom < 1)
    throw InputError(source + ": " + io::plural(std::size_t(l.values()), "value") + " for " +
                     io::plural(std::size_t(rows.parameters()), "parameter") +
                     " leave nothing to estimate the noise from: state it with --noise (0.01 is 1 %), hold "
                     "parameters with --fix, or measure more rows first");
  const auto n = Eigen::Index(l.rows.size());
  RowMatrix correlations(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      correlations(i, j) =
          correlation(rows.places[l.rows[std::size_t(i)]], rows.places[l.rows[std::size_t(j)]]);
  RestrictedLikelihood best, without;
  double ratio = 0;
  const bool few = l.values() < kFewValues * double(l.rank);
  for (const double tried : kRatios) {
    if (error && noise && tried > 0) break;
    if (few && !error && tried != kAssumedError) continue;
    if (out.freedom < 1) break;
    const RestrictedLikelihood found = restricted_likelihood(l, correlations, tried, noise);
    if (tried == 0) without = found;
    if ((few && !error) || tried == 0 || found.log > best.log) best = found, ratio = tried;
  }
  if (!few && best.log - without.log <= kDetected) best = without, ratio = 0;
  if (!noise && !(best.noise > kLeastNoise))
    throw InputError(source +
                     ": the residuals are rounding, so that the noise of a reading is unknown: "
                     "state it with --noise (0.01 is 1 %)");
  out.noise = noise ? *noise : best.noise;
  out.error = error ? *error : few ? kAssumedError * out.noise : ratio * out.noise;
  out.error_from = error       ? ErrorFrom::option
                   : few       ? ErrorFrom::assumed
                   : ratio > 0 ? ErrorFrom::residuals
                               : ErrorFrom::undetected;
  out.noise_from = noise ? NoiseFrom::option : NoiseFrom::residuals;
  return out;
}

}  // namespace brdf::fit
