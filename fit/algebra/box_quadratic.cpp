#include "fit/algebra/box_quadratic.h"

#include <algorithm>
#include <cmath>

#include "fit/algebra/eigen_view.h"

namespace brdf::fit {

std::vector<double> box_quadratic(const Matrix& hessian, std::span<const double> gradient,
                                  std::span<const double> low, std::span<const double> high) {
  const std::size_t n = gradient.size();
  const Eigen::Map<const RowMatrix> h(hessian.a.data(), Eigen::Index(n), Eigen::Index(n));
  std::vector<double> x(n);
  std::vector<bool> free(n, true);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = std::clamp(0.0, low[k], high[k]);
    free[k] = low[k] < high[k] && h(Eigen::Index(k), Eigen::Index(k)) > 0;
  }
  // Start with every unknown free. Then bind unknowns that leave the bounds, and release unknowns that the
  // gradient pushes inward.
  for (int round = 0; round < 10 * int(n) + 10; ++round) {
    std::vector<Eigen::Index> set;
    for (std::size_t k = 0; k < n; ++k)
      if (free[k]) set.push_back(Eigen::Index(k));
    const Eigen::Index m = Eigen::Index(set.size());
    Eigen::VectorXd target(m);
    if (m > 0) {
      Eigen::MatrixXd a(m, m);
      Eigen::VectorXd b(m);
      for (Eigen::Index i = 0; i < m; ++i) {
        b(i) = -gradient[std::size_t(set[std::size_t(i)])];
        for (std::size_t k = 0; k < n; ++k)
          if (!free[k]) b(i) -= h(set[std::size_t(i)], Eigen::Index(k)) * x[k];
        for (Eigen::Index j = 0; j < m; ++j) a(i, j) = h(set[std::size_t(i)], set[std::size_t(j)]);
        a(i, i) *= 1 + 1e-15;
      }
      target = a.ldlt().solve(b);
    }
    // Move towards the solution of the free set as far as the bounds allow.
    double step = 1;
    std::size_t blocked = n;
    for (Eigen::Index i = 0; i < m; ++i) {
      const std::size_t k = std::size_t(set[std::size_t(i)]);
      const double d = target(i) - x[k];
      double limit = 1;
      if (target(i) < low[k]) limit = (low[k] - x[k]) / d;
      if (target(i) > high[k]) limit = (high[k] - x[k]) / d;
      if (limit < step || (limit == step && blocked == n && limit < 1)) {
        step = limit;
        blocked = k;
      }
    }
    for (Eigen::Index i = 0; i < m; ++i) {
      const std::size_t k = std::size_t(set[std::size_t(i)]);
      x[k] = std::clamp(x[k] + step * (target(i) - x[k]), low[k], high[k]);
    }
    if (blocked < n) {
      x[blocked] =
          target(Eigen::Index(std::ranges::find(set, Eigen::Index(blocked)) - set.begin())) < low[blocked]
              ? low[blocked]
              : high[blocked];
      free[blocked] = false;
      continue;
    }
    double worst = 0;
    std::size_t release = n;
    for (std::size_t k = 0; k < n; ++k) {
      if (free[k] || low[k] >= high[k] || h(Eigen::Index(k), Eigen::Index(k)) <= 0) continue;
      double slope = gradient[k], size = std::abs(gradient[k]);
      for (std::size_t j = 0; j < n; ++j) {
        slope += h(Eigen::Index(k), Eigen::Index(j)) * x[j];
        size += std::abs(h(Eigen::Index(k), Eigen::Index(j)) * x[j]);
      }
      const double inward = x[k] <= low[k] ? -slope : slope;
      if (inward > 1e-12 * size && inward > worst) {
        worst = inward;
        release = k;
      }
    }
    if (release == n) break;
    free[release] = true;
  }
  return x;
}

}  // namespace brdf::fit
