#include "fit/solve/starts.h"
#include "fit/algebra/box_quadratic.h"

#include <algorithm>
#include <cmath>

#include "brdf/random.h"
#include "fit/solve/solve.h"

namespace brdf::fit {
namespace {

constexpr double kWidthFloor = 0.004;  // narrowest width in the grid, as a share of the widest

std::size_t points_per_dimension(std::size_t dimensions) {
  switch (dimensions) {
    case 0:
    case 1:
      return 12;
    case 2:
      return 6;
    case 3:
      return 4;
    default:
      return 3;
  }
}

}  // namespace

double grid_value(const Slot& slot, std::size_t k, std::size_t n) {
  const double high = slot.to_solver(slot.grid_max);
  double low = slot.low;
  const bool exponent = slot.role == Role::exponent || slot.role == Role::exponent_across;
  if (slot.scale == Scale::log && !exponent) low = std::max(low, slot.to_solver(slot.grid_max * kWidthFloor));
  low = std::min(low, high);
  return n == 1 ? 0.5 * (low + high) : low + (high - low) * (double(k) + 0.5) / double(n);
}

std::vector<std::vector<double>> grid_starts(const Model& model) {
  std::vector<std::vector<std::size_t>> dimensions;  // slots that share a value
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    const Slot& slot = model.slots()[s];
    if (slot.kind == Slot::Kind::normal) continue;  // keeps its starting value
    const auto same = [&](const std::vector<std::size_t>& d) {
      return model.slots()[d[0]].same_parameter(slot);
    };
    const auto found = std::ranges::find_if(dimensions, same);
    if (found == dimensions.end())
      dimensions.push_back({s});
    else
      found->push_back(s);
  }
  const std::size_t n = points_per_dimension(dimensions.size());
  std::size_t total = 1;
  for (std::size_t d = 0; d < dimensions.size(); ++d) total *= n;
  std::vector<std::vector<double>> starts;
  for (std::size_t code = 0; code < total; ++code) {
    std::vector<double> p = model.initial();
    std::size_t rest = code;
    for (const std::vector<std::size_t>& d : dimensions) {
      const std::size_t k = rest % n;
      rest /= n;
      for (std::size_t s : d) {
        const Slot& slot = model.slots()[s];
        p[s] = slot.kind == Slot::Kind::tangent ? kPi / 2 * (double(k) / double(n)) : grid_value(slot, k, n);
      }
    }
    starts.push_back(std::move(p));
  }
  return starts;
}

std::vector<double> random_start(const Model& model, std::mt19937_64& random) {
  std::vector<double> p = model.initial();
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    const Slot& slot = model.slots()[s];
    const double u = uniform01(random);
    if (slot.kind == Slot::Kind::normal) continue;
    if (slot.kind == Slot::Kind::tangent) {
      p[s] = kPi * u;
      continue;
    }
    if (slot.node > 0) {  // constant over wavelength
      p[s] = p[s - 1];
      continue;
    }
    const double low = grid_value(slot, 0, 1000000), high = slot.to_solver(slot.grid_max);
    p[s] = low + (high - low) * u;
  }
  return p;
}

namespace {

// Share of a range by which a start keeps away from its ends, at which a product has zero slope.
constexpr double kMarginInside = 0.02;

// Returns the best weights with every lobe free, in the order of the tables.
WeightTable free_weights(const Model& model, const LobeQuadratic& q) {
  std::vector<double> low(model.lobes(), 0);
  const std::vector<double> high(model.lobes(), kWeightMax);
  for (const TermModel& term : model.terms())
    for (std::size_t k = 0; k < term.lobes; ++k)
      low[term.first_lobe + k] = std::min(term.info->weights[term.info->lobes[k].weight].min, 0.0);
  WeightTable out(model.terms().size());
  for (std::size_t c = 0; c < q.hessian.size(); ++c) {
    const std::vector<double> lobes =
        box_quadratic(q.hessian[c], std::span(&q.gradient.a[c * model.lobes()], model.lobes()), low, high);
    for (std::size_t t = 0; t < out.size(); ++t) {
      const TermModel& term = model.terms()[t];
      std::vector<double>& weights = out[t].emplace_back();
      for (const auto& w : term.form->weights_of(std::span(lobes).subspan(term.first_lobe, term.lobes)))
        weights.push_back(w.value);
    }
  }
  return out;
}

// Returns cost, gradient and Gauss-Newton matrix of the quadratic by the unknowns of the weights.
NormalEquations by_unknowns(const Model& model, const LobeQuadratic& q, std::span<const double> p) {
  const std::size_t first = model.shape_slots(), count = model.size() - first, lobes = model.lobes();
  NormalEquations out{Matrix(count, count), std::vector<double>(count, 0), q.cost};
  std::vector<double> weights(lobes), slope(lobes);
  for (std::size_t c = 0; c < q.hessian.size(); ++c) {
    const Matrix& h = q.hessian[c];
    model.lobe_weights(p, c, weights);
    for (std::size_t i = 0; i < lobes; ++i) {
      slope[i] = q.gradient(c, i);
      for (std::size_t j = 0; j < lobes; ++j) slope[i] += h(i, j) * weights[j];
      out.cost += 0.5 * weights[i] * (slope[i] + q.gradient(c, i));
    }
    const std::vector<WeightSlope> slopes = model.weight_slopes(p, c);
    for (const WeightSlope& a : slopes) {
      out.gradient[a.slot - first] += a.value * slope[a.lobe];
      for (const WeightSlope& b : slopes)
        out.hessian(a.slot - first, b.slot - first) += a.value * h(a.lobe, b.lobe) * b.value;
    }
  }
  out.cost = std::max(out.cost, 0.0);
  return out;
}

// Minimises the same quadratic iteratively, for weights that share or bound unknowns.
void start_natural_weights(const SampleStream& stream, std::vector<double>& p) {
  const Model& model = stream.model();
  const std::size_t first = model.shape_slots();
  const LobeQuadratic q = stream.linearised_lobes(p);
  model.set_weights(p, free_weights(model, q));
  const std::vector<double> low = model.low(), high = model.high();
  for (std::size_t k = first; k < p.size(); ++k) {
    const double margin = kMarginInside * std::min(high[k] - low[k], 1.0);
    p[k] = std::clamp(p[k], low[k] + margin, high[k] - margin);
  }
  const std::vector<double> start(p.begin() + std::ptrdiff_t(first), p.end());
  const Objective objective = [&](std::span<const double> unknowns) {
    std::copy(unknowns.begin(), unknowns.end(), p.begin() + std::ptrdiff_t(first));
    return by_unknowns(model, q, p);
  };
  SolveOptions options;
  options.tolerance = 1e-6;
  const Solution s =
      solve(objective, start, std::span(low).subspan(first), std::span(high).subspan(first), options);
  std::copy(s.p.begin(), s.p.end(), p.begin() + std::ptrdiff_t(first));
}

}  // namespace

void start_weights(const SampleStream& stream, std::vector<double>& p) {
  const Model& model = stream.model();
  if (!model.linear()) {
    start_natural_weights(stream, p);
    return;
  }
  const std::size_t first = model.shape_slots();
  const NormalEquations n = stream.linearised_weights(p);
  const std::vector<double> low = model.low(), high = model.high();
  for (std::size_t begin = first; begin < model.size();) {  // channels are independent
    std::size_t end = begin;
    while (end < model.size() && model.slots()[end].group == model.slots()[begin].group) ++end;
    Matrix h(end - begin, end - begin);
    std::vector<double> g(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      g[i - begin] = n.gradient[i];
      for (std::size_t j = begin; j < end; ++j) h(i - begin, j - begin) = n.hessian(i, j);
    }
    const std::vector<double> x = box_quadratic(h, g, std::span(low).subspan(begin, end - begin),
                                                std::span(high).subspan(begin, end - begin));
    std::copy(x.begin(), x.end(), p.begin() + std::ptrdiff_t(begin));
    begin = end;
  }
}

}  // namespace brdf::fit
