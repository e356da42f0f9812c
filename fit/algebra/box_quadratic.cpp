#include "fit/algebra/box_quadratic.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/algebra/eigen_view.h"

namespace brdf::fit {
namespace {

constexpr Eigen::Index kSparseFrom = 24;  // unknowns; a smaller matrix is not worth a search for zeros
constexpr double kFilledShare = 0.25;     // of the entries; the most that a sparse matrix has
constexpr double kInward = 1e-12;         // share of its terms from which on a slope is not rounding

using Sparse = Eigen::SparseMatrix<double>;

// Returns the lower triangle of a matrix of many unknowns in which most entries are zero. The unknowns of
// different channels meet only in the parameters that the channels share.
std::optional<Sparse> lower_if_sparse(const Eigen::Map<const RowMatrix>& h) {
  if (h.rows() < kSparseFrom) return std::nullopt;
  const Sparse all = h.sparseView();
  if (double(all.nonZeros()) > kFilledShare * double(h.size())) return std::nullopt;
  return all.triangularView<Eigen::Lower>();
}

// The unknowns on their way to the minimum: some are free, the others keep their values.
class ActiveSet {
 public:
  ActiveSet(const Matrix& hessian, std::span<const double> gradient, std::span<const double> low,
            std::span<const double> high)
      : h_(view_of(hessian)),
        lower_(lower_if_sparse(h_)),
        gradient_(gradient),
        low_(low),
        high_(high),
        x_(gradient.size()),
        free_(gradient.size()) {
    set_.reserve(size());
    bound_.reserve(size());
    for (std::size_t k = 0; k < size(); ++k) {
      x_[k] = std::clamp(0.0, low[k], high[k]);
      free_[k] = may_move(k) && !starts_bound(k);
    }
  }

  const std::vector<double>& x() const { return x_; }

  // Moves towards the minimum of the free unknowns as far as the bounds allow. Returns false if an unknown
  // reached a bound on the way and was bound to it.
  bool reaches_free_minimum() {
    set_.clear();
    bound_.clear();
    for (std::size_t k = 0; k < size(); ++k) (free_[k] ? set_ : bound_).push_back(k);
    if (set_.empty()) return true;
    const Eigen::VectorXd target = free_minimum();
    double step = 1;
    Eigen::Index blocked = -1;  // its place in the set
    for (Eigen::Index i = 0; i < target.size(); ++i) {
      const std::size_t k = set_[std::size_t(i)];
      const double d = target(i) - x_[k];
      double limit = 1;
      if (target(i) < low_[k]) limit = (low_[k] - x_[k]) / d;
      if (target(i) > high_[k]) limit = (high_[k] - x_[k]) / d;
      if (limit < step || (limit == step && blocked < 0 && limit < 1)) {
        step = limit;
        blocked = i;
      }
    }
    for (Eigen::Index i = 0; i < target.size(); ++i) {
      const std::size_t k = set_[std::size_t(i)];
      x_[k] = std::clamp(x_[k] + step * (target(i) - x_[k]), low_[k], high_[k]);
    }
    if (blocked < 0) return true;
    const std::size_t k = set_[std::size_t(blocked)];
    x_[k] = target(blocked) < low_[k] ? low_[k] : high_[k];
    free_[k] = false;
    return false;
  }

  // Frees the unknown that the gradient pushes inward most. Returns false if the gradient pushes all bound
  // unknowns outward.
  bool releases_one() {
    double worst = 0;
    std::size_t release = size();
    for (std::size_t k = 0; k < size(); ++k) {
      if (free_[k] || !may_move(k)) continue;
      double slope = gradient_[k], terms = std::abs(gradient_[k]);
      for (std::size_t j = 0; j < size(); ++j) {
        slope += entry(k, j) * x_[j];
        terms += std::abs(entry(k, j) * x_[j]);
      }
      const double inward = x_[k] <= low_[k] ? -slope : slope;
      if (inward > kInward * terms && inward > worst) {
        worst = inward;
        release = k;
      }
    }
    if (release == size()) return false;
    return free_[release] = true;
  }

 private:
  std::size_t size() const { return gradient_.size(); }
  double entry(std::size_t i, std::size_t j) const { return h_(Eigen::Index(i), Eigen::Index(j)); }
  bool may_move(std::size_t k) const { return low_[k] < high_[k] && entry(k, k) > 0; }

  // With many unknowns, many are at their bounds already. Each of them that is free at first costs a round.
  bool starts_bound(std::size_t k) const {
    if (!lower_) return false;
    return (low_[k] == 0 && gradient_[k] > 0) || (high_[k] == 0 && gradient_[k] < 0);
  }

  // The diagonal is raised by its rounding, so that dependent unknowns have a solution.
  static constexpr double kRaised = 1 + 1e-15;

  Eigen::VectorXd free_minimum() const {
    const Eigen::Index m = Eigen::Index(set_.size());
    Eigen::VectorXd b(m);
    for (Eigen::Index i = 0; i < m; ++i) {
      const std::size_t row = set_[std::size_t(i)];
      double downhill = -gradient_[row];
      for (const std::size_t k : bound_) downhill -= entry(row, k) * x_[k];
      b(i) = downhill;
    }
    if (lower_) {
      const Eigen::SimplicialLDLT<Sparse> factors(sparse_free_part());
      if (factors.info() == Eigen::Success)
        if (Eigen::VectorXd x = factors.solve(b); x.allFinite()) return x;
    }
    Eigen::MatrixXd a(m, m);
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i) a(i, j) = entry(set_[std::size_t(i)], set_[std::size_t(j)]);
    a.diagonal() *= kRaised;
    const Eigen::LDLT<Eigen::Ref<Eigen::MatrixXd>> factors(a);
    factors.solveInPlace(b);
    return b;
  }

  Sparse sparse_free_part() const {
    std::vector<Eigen::Index> place(size(), -1);
    for (std::size_t i = 0; i < set_.size(); ++i) place[set_[i]] = Eigen::Index(i);
    Sparse out(Eigen::Index(set_.size()), Eigen::Index(set_.size()));
    out.reserve(lower_->nonZeros());
    for (const std::size_t column : set_) {
      const Eigen::Index j = place[column];
      out.startVec(j);
      for (Sparse::InnerIterator e(*lower_, Eigen::Index(column)); e; ++e)
        if (const Eigen::Index i = place[std::size_t(e.row())]; i >= 0)
          out.insertBack(i, j) = e.value() * (i == j ? kRaised : 1);
    }
    out.finalize();
    return out;
  }

  Eigen::Map<const RowMatrix> h_;
  std::optional<Sparse> lower_;  // of h_, if the matrix is sparse
  std::span<const double> gradient_, low_, high_;
  std::vector<double> x_;
  std::vector<bool> free_;
  std::vector<std::size_t> set_, bound_;  // the free unknowns and the others
};

}  // namespace

std::vector<double> box_quadratic(const Matrix& hessian, std::span<const double> gradient,
                                  std::span<const double> low, std::span<const double> high) {
  ActiveSet set(hessian, gradient, low, high);
  const int rounds = 10 * int(gradient.size()) + 10;
  for (int round = 0; round < rounds; ++round)
    if (set.reaches_free_minimum() && !set.releases_one()) break;
  return set.x();
}

}  // namespace brdf::fit
