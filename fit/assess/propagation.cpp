#include "fit/assess/propagation.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace brdf::fit {

Eigen::VectorXd gradient_vector(const Reported& r, Eigen::Index n) {
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n);
  for (const auto& [slot, slope] : r.gradient) g(Eigen::Index(slot)) = slope;
  return g;
}

namespace {

// A covariance C as coordinates in which it is the identity: whiten C whiten^T = 1, and whiten back = 1. The
// coordinates leave out the directions without variance.
struct Whitened {
  RowMatrix whiten, back;
};

// The correlations are decomposed, because the variances of parameters may differ by many orders.
Whitened whitened(const RowMatrix& covariance) {
  constexpr double kRounding = 1e-12;
  const Eigen::VectorXd error = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const Eigen::VectorXd over = error.unaryExpr([](double x) { return x > 0 ? 1 / x : 0; });
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(
      RowMatrix(over.asDiagonal() * covariance * over.asDiagonal()));
  const Eigen::VectorXd& variances = eigen.eigenvalues();  // the largest is the last
  const double most = variances.size() > 0 ? std::max(variances(variances.size() - 1), 0.0) : 0;
  const Eigen::Index count = (variances.array() > kRounding * most).count();
  const Eigen::VectorXd root = variances.tail(count).cwiseSqrt();
  const RowMatrix directions = eigen.eigenvectors().rightCols(count);
  return {root.cwiseInverse().asDiagonal() * directions.transpose() * over.asDiagonal(),
          error.asDiagonal() * directions * root.asDiagonal()};
}

}  // namespace

RowMatrix larger_of(const RowMatrix& covariance, const RowMatrix& other, double trust, double limit) {
  // In the coordinates of the sum, both have the same directions, and variances with the sum 1. Either may
  // have a variance of 0 in a direction.
  const Whitened sum = whitened(covariance + other);
  if (sum.whiten.rows() == 0) return covariance;  // no variance, or no numbers
  const Eigen::SelfAdjointEigenSolver<RowMatrix> own(
      RowMatrix(sum.whiten * covariance * sum.whiten.transpose()));
  const Eigen::VectorXd excess = own.eigenvalues().unaryExpr([&](double variance) {
    const double a = std::clamp(variance, 0.0, 1.0), of_other = 1 - a;
    return of_other > limit * a ? trust * (of_other - a) : 0;
  });
  const RowMatrix back = sum.back * own.eigenvectors();
  return covariance + back * excess.asDiagonal() * back.transpose();
}

RowMatrix shrunk(const RowMatrix& covariance, const RowMatrix& before, const RowMatrix& after) {
  const Whitened w = whitened(before);
  if (w.whiten.rows() == 0) return covariance;
  const Eigen::SelfAdjointEigenSolver<RowMatrix> share(RowMatrix(w.whiten * after * w.whiten.transpose()));
  const Eigen::VectorXd change =
      share.eigenvalues().unaryExpr([](double x) { return std::sqrt(std::clamp(x, 0.0, 1.0)) - 1; });
  const RowMatrix directions = share.eigenvectors();
  const RowMatrix factor = RowMatrix::Identity(covariance.rows(), covariance.cols()) +
                           w.back * directions * change.asDiagonal() * directions.transpose() * w.whiten;
  return factor * covariance * factor.transpose();
}

namespace {

std::string name_of_parameter(const Reported& r, const Model& model) {
  if (r.slot != kNoSlot) return model.slots()[r.slot].name;
  return r.scale == kNoSlot ? label(r.estimate) : label(model.slots()[r.scale].name, r.estimate.channel);
}

// Adds the sources that rows share to the covariance of the parameters, each as components of its own.
void add_shared(std::span<const SourceCovariance> sources, const std::vector<Eigen::VectorXd>& gradients,
                ParameterCovariance& to) {
  if (sources.empty()) return;
  to.sources.assign(to.components.rows, "");
  const Eigen::Index n = Eigen::Index(gradients.size());
  for (const SourceCovariance& s : sources) {
    if (!s.is_shared) continue;
    RowMatrix natural(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j)
        natural(i, j) = gradients[std::size_t(i)].dot(s.covariance * gradients[std::size_t(j)]);
    // Scaled to correlations, so that a parameter with small numbers keeps its digits.
    const Eigen::VectorXd error = natural.diagonal().cwiseMax(0).cwiseSqrt();
    const Eigen::VectorXd over = error.unaryExpr([](double x) { return x > 0 ? 1 / x : 0; });
    const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(
        RowMatrix(over.asDiagonal() * natural * over.asDiagonal()));
    for (Eigen::Index k = 0; k < n; ++k) {
      constexpr double kRounding = 1e-12;
      const double variance = eigen.eigenvalues()(k);
      if (!(variance > kRounding)) continue;
      for (Eigen::Index i = 0; i < n; ++i)
        to.components.a.push_back(std::sqrt(variance) * eigen.eigenvectors()(i, k) * error(i));
      ++to.components.rows;
      to.freedom.push_back(ParameterCovariance::kStated);
      to.sources.push_back(s.source);
    }
  }
}

}  // namespace

ParameterCovariance parameter_covariance(const SampleStream& stream, std::span<const double> p,
                                         const std::vector<Reported>& all, const SlotCovariance& c,
                                         double freedom, std::span<const SourceCovariance> sources) {
  const Model& model = stream.model();
  ParameterCovariance out;
  std::vector<Eigen::VectorXd> scaled;  // gradients, in standard errors
  std::vector<Eigen::VectorXd> gradients;
  std::vector<double> errors;
  std::set<std::string> seen;
  for (const Reported& r : all) {
    // If two widths are tied, the second is not a separate parameter.
    const std::string name = name_of_parameter(r, model);
    if (!seen.insert(name).second) continue;
    const Eigen::VectorXd g = gradient_vector(r, c.matrix.rows());
    const double variance = g.dot(c.matrix * g);
    if (!(variance > 0)) continue;
    out.names.push_back(name);
    errors.push_back(std::sqrt(variance));
    scaled.push_back(g / errors.back());
    gradients.push_back(g);
  }
  const std::size_t n = scaled.size();
  out.components = Matrix(n, n);
  if (n == 0) return out;
  RowMatrix correlation(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      correlation(Eigen::Index(i), Eigen::Index(j)) = scaled[i].dot(c.matrix * scaled[j]);
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(correlation);
  std::vector<std::vector<double>> influence;
  for (std::size_t k = 0; k < n; ++k) {
    const auto v = eigen.eigenvectors().col(Eigen::Index(k));
    const double size = std::sqrt(std::max(eigen.eigenvalues()(Eigen::Index(k)), 0.0));
    Eigen::VectorXd g = Eigen::VectorXd::Zero(c.matrix.rows());
    for (std::size_t i = 0; i < n; ++i) {
      out.components(k, i) = errors[i] * size * v(Eigen::Index(i));
      g += v(Eigen::Index(i)) * scaled[i];
    }
    const Eigen::VectorXd on = c.inverse * g;
    influence.emplace_back(on.data(), on.data() + on.size());
  }
  out.freedom.assign(n, std::max(freedom, 1.0));
  if (!c.pooled && stream.data().rows() <= kManyRows) {
    const std::vector<NoiseShares> shares = stream.noise_shares(p, influence);
    for (std::size_t k = 0; k < n; ++k)
      if (shares[k].any()) out.freedom[k] = std::clamp(shares[k].freedom(), 1.0, out.freedom[k]);
  }
  add_shared(sources, gradients, out);
  return out;
}

namespace {

constexpr double kShare = 0.95;  // share of the values, and of their light, that the prediction error covers

// A value of the model: its relative standard error and its light.
struct Predicted {
  double error, light;
};

// Returns the values above 0, channel by channel.
std::vector<Predicted> predicted(const SampleStream& stream, std::span<const double> p,
                                 const RowMatrix& covariance) {
  Matrix c{stream.model().size(), stream.model().size()};
  std::copy(covariance.data(), covariance.data() + covariance.size(), c.a.begin());
  const auto [values, errors] = stream.value_errors(p, c);
  std::vector<Predicted> all;
  all.reserve(values.size() * stream.data().rows());
  for (std::size_t channel = 0; channel < values.size(); ++channel)
    for (std::size_t k = 0; k < values[channel].size(); ++k)
      if (const double f = values[channel][k]; f > 0)
        all.push_back({errors[channel][k] / f, f * stream.data().wi_z[k]});
  return all;
}

double light_of(const std::vector<Predicted>& all) {
  double light = 0;
  for (const Predicted& value : all) light += value.light;
  return light;
}

}  // namespace

double prediction_error(const SampleStream& stream, std::span<const double> p, const RowMatrix& covariance) {
  std::vector<Predicted> all = predicted(stream, p, covariance);
  const double light = light_of(all);
  std::ranges::sort(all, {}, &Predicted::error);
  double below = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    below += all[k].light;
    if (below >= kShare * light && double(k + 1) >= kShare * double(all.size())) return all[k].error;
  }
  return 0;
}

bool predicts_within(double error, const SampleStream& stream, std::span<const double> p,
                     const RowMatrix& covariance) {
  const std::vector<Predicted> all = predicted(stream, p, covariance);
  double below = 0, count = 0;
  for (const Predicted& value : all)
    if (value.error <= error) {
      below += value.light;
      ++count;
    }
  return below >= kShare * light_of(all) && count >= kShare * double(all.size());
}

}  // namespace brdf::fit
