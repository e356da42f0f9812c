#include "fit/solve/profile.h"

#include <algorithm>
#include <cmath>

#include "fit/algebra/eigen_view.h"

namespace brdf::fit {
namespace {

// Eigenvalues of the scaled matrix below this share of the largest belong to directions without effect.
constexpr double kWithoutEffect = 1e-12;

RowMatrix pseudo_inverse(const RowMatrix& m) {
  Eigen::VectorXd scale(m.rows());
  for (Eigen::Index k = 0; k < m.rows(); ++k) scale(k) = m(k, k) > 0 ? 1 / std::sqrt(m(k, k)) : 0;
  const Eigen::SelfAdjointEigenSolver<RowMatrix> eigen(scale.asDiagonal() * m * scale.asDiagonal());
  RowMatrix out = RowMatrix::Zero(m.rows(), m.rows());
  for (Eigen::Index k = 0; k < m.rows(); ++k) {
    const double value = eigen.eigenvalues()(k);
    if (value <= kWithoutEffect * eigen.eigenvalues()(m.rows() - 1)) continue;
    const Eigen::VectorXd v = scale.asDiagonal() * eigen.eigenvectors().col(k);
    out += v * v.transpose() / value;
  }
  return out;
}

}  // namespace

Profile profile(const NormalEquations& n, std::span<const std::size_t> kept, std::span<const int> at_bound) {
  const std::size_t size = n.gradient.size();
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < size; ++k)
    if (at_bound[k] == 0 && std::ranges::find(kept, k) == kept.end()) others.push_back(k);
  const Eigen::Index f = Eigen::Index(others.size());
  RowMatrix own(f, f);
  for (std::size_t i = 0; i < others.size(); ++i)
    for (std::size_t j = 0; j < others.size(); ++j)
      own(Eigen::Index(i), Eigen::Index(j)) = n.hessian(others[i], others[j]);
  Profile out{{}, std::vector<double>(kept.size(), 0), Matrix(size, kept.size()), Matrix(size, size)};
  if (f > 0) {
    const RowMatrix inverse = pseudo_inverse(own);
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t j = 0; j < others.size(); ++j)
        out.inverse(others[i], others[j]) = inverse(Eigen::Index(i), Eigen::Index(j));
  }
  for (std::size_t s = 0; s < kept.size(); ++s) {
    for (const std::size_t i : others)
      for (const std::size_t j : others) out.follows(i, s) -= out.inverse(i, j) * n.hessian(j, kept[s]);
    out.follows(kept[s], s) = 1;
    for (std::size_t k = 0; k < size; ++k) out.gradient[s] += out.follows(k, s) * n.gradient[k];
  }
  out.hessian = congruent(out.follows, n.hessian);
  return out;
}

Matrix pseudo_inverse(const Matrix& m) {
  return matrix_of(pseudo_inverse(RowMatrix(view_of(m))));
}

Matrix sandwich(const Matrix& hessian, const Matrix& meat) {
  const RowMatrix inverse = pseudo_inverse(view_of(hessian));
  return matrix_of(inverse * view_of(meat) * inverse);
}

Matrix congruent(const Matrix& a, const Matrix& m) {
  return matrix_of(view_of(a).transpose() * view_of(m) * view_of(a));
}

}  // namespace brdf::fit
