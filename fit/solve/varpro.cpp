#include "fit/solve/varpro.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/algebra/box_quadratic.h"
#include "fit/algebra/eigen_view.h"

namespace brdf::fit {
namespace {

// Cost relative to the square of the measurements above which nine digits of the cost survive the
// subtraction.
constexpr double kExactShare = 1e-7;

// The linear unknowns of one channel: the affine map to all lobes, and their places in p.
struct Unknowns {
  RowMatrix a;
  Eigen::VectorXd b;
  std::vector<std::size_t> slot;
  std::vector<double> low, high;
};

Unknowns unknowns_of(const Model& model, std::size_t channel) {
  Unknowns u;
  Eigen::Index count = 0;
  for (const TermModel& t : model.terms()) count += Eigen::Index(t.weights[channel].unknowns);
  u.a = RowMatrix::Zero(Eigen::Index(model.lobes()), count);
  u.b = Eigen::VectorXd::Zero(Eigen::Index(model.lobes()));
  for (const TermModel& t : model.terms()) {
    const WeightMap& map = t.weights[channel];
    for (std::size_t k = 0; k < map.lobes; ++k) {
      const Eigen::Index row = Eigen::Index(t.first_lobe + k);
      u.b(row) = map.b[k];
      for (std::size_t j = 0; j < map.unknowns; ++j)
        u.a(row, Eigen::Index(u.slot.size() + j)) = map.a[k * map.unknowns + j];
    }
    for (std::size_t j = 0; j < map.unknowns; ++j) {
      u.slot.push_back(map.first_slot + j);
      u.low.push_back(map.low[j]);
      u.high.push_back(map.high[j]);
    }
  }
  return u;
}

// The derivative columns of the Gram matrix that belong to one partial, combined with the weights.
struct PartialColumns {
  std::size_t slot, first_column, first_lobe, count;
  double slope;
};

std::vector<PartialColumns> partial_columns(const Model& model, std::span<const double> p,
                                            std::size_t group) {
  std::vector<PartialColumns> out;
  std::size_t column = model.lobes();
  for (const TermModel& t : model.terms())
    for (std::size_t q = t.first_partial; q < t.first_partial + t.partials; ++q, column += t.lobes)
      for (const auto& [slot, slope] : model.slopes_of_partial(p, q, group))
        out.push_back({slot, column, t.first_lobe, t.lobes, slope});
  return out;
}

void add_channel(const Model& model, const LobeGram& g, std::size_t member, std::size_t channel,
                 std::span<const PartialColumns> partials, std::vector<double>& p, NormalEquations& out) {
  const Eigen::Index lobes = Eigen::Index(g.lobes), columns = Eigen::Index(g.gram.rows);
  const Eigen::Map<const RowMatrix> gram(g.gram.a.data(), columns, columns);
  const Eigen::Map<const Eigen::VectorXd> cross(&g.cross.a[member * g.cross.cols], columns);
  const auto inner = gram.topLeftCorner(lobes, lobes);
  const Unknowns u = unknowns_of(model, channel);
  const Eigen::Index n = u.a.cols();

  const RowMatrix h = u.a.transpose() * inner * u.a;
  const Eigen::VectorXd linear = u.a.transpose() * (inner * u.b - cross.head(lobes));
  Matrix hessian{std::size_t(n), std::size_t(n)};
  std::copy(h.data(), h.data() + h.size(), hessian.a.begin());
  const std::vector<double> x =
      box_quadratic(hessian, std::span(linear.data(), std::size_t(n)), u.low, u.high);
  std::vector<Eigen::Index> free;
  for (std::size_t k = 0; k < x.size(); ++k) {
    p[u.slot[k]] = x[k];
    if (x[k] > u.low[k] && x[k] < u.high[k]) free.push_back(Eigen::Index(k));
  }
  const Eigen::VectorXd w = u.a * Eigen::Map<const Eigen::VectorXd>(x.data(), n) + u.b;
  // products of every column with the residual
  const Eigen::VectorXd residual = gram.leftCols(lobes) * w - cross;
  out.cost += std::max(0.0, 0.5 * (w.dot(inner * w) - 2 * w.dot(cross.head(lobes)) + g.square[member]));

  if (partials.empty()) return;  // only weights: Eigen does not solve for zero columns

  // D = derivative columns combined with the weights: the effect of a shape parameter on the model.
  const Eigen::Index m = Eigen::Index(partials.size());
  RowMatrix d = RowMatrix::Zero(columns, m);
  for (Eigen::Index s = 0; s < m; ++s) {
    const PartialColumns& c = partials[std::size_t(s)];
    for (std::size_t k = 0; k < c.count; ++k)
      d(Eigen::Index(c.first_column + k), s) = c.slope * w(Eigen::Index(c.first_lobe + k));
  }
  RowMatrix normal = d.transpose() * gram * d;
  if (!free.empty()) {
    RowMatrix active(lobes, Eigen::Index(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k) active.col(Eigen::Index(k)) = u.a.col(free[k]);
    RowMatrix inside = active.transpose() * inner * active;
    inside.diagonal() *= 1 + 1e-14;
    const RowMatrix mixed = active.transpose() * gram.topRows(lobes) * d;
    normal -= mixed.transpose() * inside.ldlt().solve(mixed);
  }
  const Eigen::VectorXd gradient = d.transpose() * residual;
  for (Eigen::Index s = 0; s < m; ++s) {
    const std::size_t i = partials[std::size_t(s)].slot;
    out.gradient[i] += gradient(s);
    for (Eigen::Index t = 0; t < m; ++t) out.hessian(i, partials[std::size_t(t)].slot) += normal(s, t);
  }
}

}  // namespace

bool projects(const SampleStream& stream) {
  const Model& model = stream.model();
  if (!model.linear() || !model.cuts().empty()) return false;
  if (stream.residual().metric != Metric::cosine_l2 ||
      stream.residual().loss.kind != LossFunction::Kind::none || !stream.data().sigma.empty())
    return false;
  for (std::size_t k = model.shape_slots(); k < model.size(); ++k)
    if (model.slots()[k].high < kWeightMax && model.slots()[k].high > model.slots()[k].low + 1) return false;
  return true;
}

NormalEquations project(const SampleStream& stream, std::vector<double>& p, double& square) {
  square = 0;
  const Model& model = stream.model();
  const std::size_t shapes = model.shape_slots();
  NormalEquations out{Matrix(shapes, shapes), std::vector<double>(shapes, 0), 0};
  for (std::size_t group = 0; group < model.groups(); ++group) {
    const LobeGram g = stream.lobe_gram(p, group);
    const std::vector<PartialColumns> partials = partial_columns(model, p, group);
    for (double s : g.square) square += 0.5 * s;
    std::size_t member = 0;
    for (std::size_t c = 0; c < model.channels().size(); ++c)
      if (model.group_of(c) == group) add_channel(model, g, member++, c, partials, p, out);
  }
  return out;
}

Solution solve_projected(const SampleStream& stream, std::span<const double> start,
                         const SolveOptions& options, bool& exact) {
  const std::size_t shapes = stream.model().shape_slots();
  // The weights at the two points that the solver keeps (solve.cpp).
  struct Point {
    double cost = HUGE_VAL;
    std::vector<double> p{};
  };
  std::array<Point, 2> kept;
  std::vector<double> p(start.begin(), start.end());
  double square = 0;
  const Objective objective = [&](std::span<const double> s) {
    std::copy(s.begin(), s.end(), p.begin());
    NormalEquations equations = project(stream, p, square);
    (kept[0].cost < kept[1].cost ? kept[1] : kept[0]) = {std::fmin(equations.cost, HUGE_VAL), p};
    return equations;
  };
  const std::vector<double> low = stream.model().low(), high = stream.model().high();
  Solution s = solve(objective, std::span(start).first(shapes), std::span(low).first(shapes),
                     std::span(high).first(shapes), options);
  const auto is_solution = [&](const std::vector<double>& q) {
    return !q.empty() && std::equal(s.p.begin(), s.p.end(), q.begin());
  };
  for (const Point& k : kept)
    if (is_solution(k.p)) p = k.p;
  if (!is_solution(p)) objective(std::vector<double>(s.p));
  exact = s.cost > kExactShare * square;
  s.p = p;
  s.at_bound.resize(p.size(), 0);
  for (std::size_t k = shapes; k < p.size(); ++k)
    s.at_bound[k] = p[k] <= low[k] ? -1 : p[k] >= high[k] ? 1 : 0;
  return s;
}

}  // namespace brdf::fit
