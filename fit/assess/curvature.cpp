#include "fit/assess/curvature.h"

#include <algorithm>
#include <cmath>

#include "fit/assess/assess.h"
#include "io/files/numbers.h"

namespace brdf::fit {
namespace {

// Eigenvalues of the scaled normal matrix below this share of the largest belong to directions without
// effect.
constexpr double kSingular = 1e-12;
// A parameter is not identifiable if more than this share of its direction lies in such a subspace.
constexpr double kInNullSpace = 1e-3;
// Floors to be tried, as shares of the median value, in addition to no floor.
constexpr double kFloors[] = {0.03, 0.1, 0.3, 1, 3, 10, 30};
// A floor is accepted only if it raises twice the log-likelihood by this amount. An unnecessary floor makes
// bright values appear too certain.
constexpr double kLikelier = 6;
// Lower limit of the share of a value's variance that remains after its own influence on the fit.
constexpr double kLeastLeft = 1e-4;
// Values of a higher leverage contain too little information on the noise to determine a floor.
constexpr double kFreeLeverage = 0.2;

using Values = std::vector<std::vector<double>>;  // [channel][row]

// Computes the inverse, null space and condition of the normal matrix.
void invert(const RowMatrix& bread, Curvature& out) {
  const Eigen::Index n = bread.rows();
  out.scale = Eigen::VectorXd::Zero(n);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index k = 0; k < n; ++k)
    if (bread(k, k) > 0) {
      seen.push_back(k);
      out.scale(k) = 1 / std::sqrt(bread(k, k));
    }
  const Eigen::Index f = Eigen::Index(seen.size());
  out.inverse = out.covariance = RowMatrix::Zero(n, n);
  out.null_space = RowMatrix::Zero(n, f);
  out.weakest = RowMatrix::Zero(n, 1);
  if (f == 0) return;
  const RowMatrix scaled = (out.scale.asDiagonal() * bread * out.scale.asDiagonal())(seen, seen);
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(scaled);
  const double largest = eigen.eigenvalues()(f - 1);
  RowMatrix inverse = RowMatrix::Zero(f, f);
  Eigen::Index nulls = 0;
  for (Eigen::Index k = 0; k < f; ++k) {
    const auto v = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()(k) <= kSingular * largest) {
      for (Eigen::Index i = 0; i < f; ++i) out.null_space(seen[std::size_t(i)], nulls) = v(i);
      ++nulls;
    } else {
      inverse += v * v.transpose() / eigen.eigenvalues()(k);
    }
  }
  for (Eigen::Index i = 0; i < f; ++i) out.weakest(seen[std::size_t(i)], 0) = eigen.eigenvectors()(i, 0);
  out.null_space.conservativeResize(n, nulls);
  out.condition = std::sqrt(largest / std::max(eigen.eigenvalues()(0), largest * 1e-32));
  for (Eigen::Index i = 0; i < f; ++i)
    for (Eigen::Index j = 0; j < f; ++j) {
      const Eigen::Index a = seen[std::size_t(i)], b = seen[std::size_t(j)];
      out.inverse(a, b) = inverse(i, j) * out.scale(a) * out.scale(b);
    }
}

}  // namespace

bool Curvature::without_effect(const Eigen::VectorXd& gradient) const {
  double inside = 0, all = 0;
  for (Eigen::Index k = 0; k < gradient.size(); ++k) {
    if (gradient(k) == 0) continue;
    if (scale(k) == 0) return true;
    all += gradient(k) * gradient(k) * scale(k) * scale(k);
  }
  for (Eigen::Index k = 0; k < null_space.cols(); ++k) {
    const double along = gradient.cwiseProduct(scale).dot(null_space.col(k));
    inside += along * along;
  }
  return all > 0 && inside > kInNullSpace * all;
}

Curvature curvature(const SampleStream& stream, const Minimum& m, const KnownMatrices* known) {
  // With many rows, no leverage justifies a second pass.
  const bool many = stream.data().rows() > kManyRows;
  ScoreMatrices scores =
      many ? stream.scores(m.p) : ScoreMatrices{known ? known->bread : stream.bread(m.p), {}};
  Curvature out;
  out.bread = view_of(scores.bread);
  invert(out.bread, out);
  Matrix freed = std::move(scores.meat);
  if (!many) {
    const RowMatrix noise = view_of(known ? known->expected_meat : stream.expected_meat(m.p));
    const Matrix inverse = matrix_of(out.inverse);
    const Matrix expected = matrix_of(out.inverse * noise * out.inverse);
    freed = stream.meat(m.p, inverse, &expected);
  }
  out.covariance = out.inverse * view_of(freed) * out.inverse;
  return out;
}

namespace {

// Returns the noise of every value under a floor, up to the common factor, in units of the residual.
Values unit_noise(const SampleStream& stream, const Values& values, const Values& slopes, double floor) {
  const FitData& data = stream.data();
  Values out = slopes;
  for (std::size_t c = 0; c < values.size(); ++c)
    for (std::size_t k = 0; k < data.rows(); ++k) {
      if (!data.sigma.empty())
        out[c][k] = data.weight.empty() ? 1 : std::sqrt(data.weight[k]);
      else
        out[c][k] *= std::hypot(values[c][k], floor);
    }
  return out;
}

// Returns -2 ln of the likelihood, up to a constant, of the residuals that are nearly free of the fit's
// influence.
double unlikelihood(const Values& residuals, const Values& noise, const Values& leverage) {
  double squares = 0, logarithms = 0, count = 0;
  for (std::size_t c = 0; c < noise.size(); ++c)
    for (std::size_t k = 0; k < noise[c].size(); ++k) {
      if (!(noise[c][k] > 0) || leverage[c][k] > kFreeLeverage) continue;
      squares += square(residuals[c][k] / noise[c][k]);
      logarithms += 2 * std::log(noise[c][k]);
      ++count;
    }
  return logarithms + count * std::log(std::max(squares / std::max(count, 1.0), 1e-300));
}

double likeliest_floor(const SampleStream& stream, const Values& values, const Values& slopes,
                       const Values& residuals, const Values& leverage) {
  if (!stream.data().sigma.empty()) return 0;
  std::vector<double> sizes;
  for (const auto& channel : values)
    for (const double f : channel) sizes.push_back(std::abs(f));
  const double middle = io::median(std::move(sizes));
  double best = 0,
         least = unlikelihood(residuals, unit_noise(stream, values, slopes, 0), leverage) - kLikelier;
  for (const double share : kFloors) {
    const double floor = share * middle;
    const double value = unlikelihood(residuals, unit_noise(stream, values, slopes, floor), leverage);
    if (value < least) least = value, best = floor;
  }
  return best;
}

struct Standardised {
  double variance = 0, correlation = 0;
};

// Computes statistics of the residuals divided by their noise, corrected for the part that the fit
// absorbed. `left` is the share of each residual's variance that remains after the fit.
Standardised standardised(const Values& residuals, const Values& noise, const Values& left) {
  double squares = 0, expected = 0, products = 0, pairs = 0;
  for (std::size_t k = 0; k < noise.front().size(); ++k) {
    double sum = 0, own = 0, count = 0;
    for (std::size_t c = 0; c < noise.size(); ++c) {
      if (!(noise[c][k] > 0)) continue;
      const double z = residuals[c][k] / noise[c][k];
      squares += z * z;
      expected += left[c][k];
      sum += z;
      own += z * z;
      ++count;
    }
    products += sum * sum - own;
    pairs += count * (count - 1);
  }
  if (!(squares > 0)) return {};
  Standardised out{squares / std::max(expected, kLeastLeft), 0};
  const double count = double(noise.size()) * double(noise.front().size());
  if (pairs > 0) out.correlation = std::clamp(products / pairs / (squares / count), 0.0, 1.0);
  return out;
}

}  // namespace

WorkingNoise working_noise(const SampleStream& stream, const Minimum& m, const Curvature& c) {
  const Matrix inverse = matrix_of(c.inverse);
  const auto [values, reach] = stream.value_errors(m.p, inverse);
  const Values residuals = stream.residuals_of(values), slopes = stream.slopes_of(values);
  Values leverage = reach;
  for (std::size_t channel = 0; channel < leverage.size(); ++channel)
    for (std::size_t k = 0; k < leverage[channel].size(); ++k)
      leverage[channel][k] = std::min(square(slopes[channel][k] * reach[channel][k]), 1.0);
  WorkingNoise out;
  out.floor = likeliest_floor(stream, values, slopes, residuals, leverage);
  const Values noise = unit_noise(stream, values, slopes, out.floor);
  const RowMatrix apart = c.inverse * view_of(stream.meat_of(m.p, noise, Clusters::values)) * c.inverse;
  const auto [same, spread] = stream.value_errors(m.p, matrix_of(apart));
  Values left = noise;
  for (std::size_t channel = 0; channel < noise.size(); ++channel)
    for (std::size_t k = 0; k < noise[channel].size(); ++k) {
      const double d = noise[channel][k], own = leverage[channel][k];
      const double kept = d > 0 ? 1 - 2 * own + square(slopes[channel][k] * spread[channel][k] / d) : 0;
      left[channel][k] = std::clamp(kept, square(1 - own), 1.0);
    }
  const Standardised found = standardised(residuals, noise, left);
  out.relative = std::sqrt(found.variance);
  out.correlation = found.correlation;
  out.covariance = found.variance * (1 - found.correlation) * apart;
  if (found.correlation > 0)
    out.covariance += found.variance * found.correlation * c.inverse *
                      view_of(stream.meat_of(m.p, noise, Clusters::rows)) * c.inverse;
  return out;
}

}  // namespace brdf::fit
