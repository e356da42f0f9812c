#include "fit/solve/equivalence.h"

#include <algorithm>
#include <cmath>

#include "fit/solve/starts.h"

namespace brdf::fit {
namespace {

constexpr double kSamePoint = 1e-3;
constexpr double kBarrier = 1e-4;        // rise of the cost between two minima that makes them distinct
constexpr double kCostRounding = 1e-20;  // of a cost, relative to that of a black surface

void swap_slots(Minimum& m, std::size_t a, std::size_t b) {
  std::swap(m.p[a], m.p[b]);
  std::swap(m.at_bound[a], m.at_bound[b]);
}

// Returns the pairs of slots that exchange places if the frame turns by a right angle: the widths along and
// across of every term. Empty if some of them are held, tied or bounded differently.
std::vector<std::pair<std::size_t, std::size_t>> crossed_slots(const Model& model) {
  const auto shape_slot = [&](std::size_t term, int member, std::size_t group) {
    for (std::size_t s = 0; s < model.shape_slots(); ++s) {
      const Slot& slot = model.slots()[s];
      if (slot.kind == Slot::Kind::shape && slot.term == term && slot.in_group(group) &&
          int(slot.members[0]) == member)
        return s;
    }
    return kNoSlot;
  };
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t t = 0; t < model.terms().size(); ++t) {
    const ReflectanceInfo& info = *model.terms()[t].info;
    if (!info.anisotropic()) continue;
    for (std::size_t g = 0; g < model.groups(); ++g) {
      const std::size_t along = shape_slot(t, info.axes().along, g),
                        across = shape_slot(t, info.axes().across, g);
      if (along == kNoSlot || across == kNoSlot || !model.slots()[along].same_range(model.slots()[across]) ||
          model.slots()[along].group != model.slots()[across].group)
        return {};
      if (g > 0 && model.slots()[along].group != g) continue;
      for (std::size_t node = 0; node < model.slots()[along].nodes; ++node)
        pairs.push_back({along + node, across + node});
    }
  }
  return pairs;
}

// Turns the tangent to (-45, 45] degrees, or to (-90, 90] if the widths cannot exchange places.
void turn_tangent(const Model& model, Minimum& m) {
  const std::size_t t = model.tangent_slot();
  if (t == kNoSlot) return;
  const auto crossed = crossed_slots(model);
  const double turns =
      crossed.empty() ? 2 * std::ceil((m.p[t] - kPi / 2) / kPi) : std::ceil((m.p[t] - kPi / 4) / (kPi / 2));
  m.p[t] -= turns * (kPi / 2);
  if (std::fmod(std::abs(turns), 2.0) == 1.0)
    for (const auto& [along, across] : crossed) swap_slots(m, along, across);
}

// Returns whether both terms of a sum are the same form under the same constraints, except for a held
// diffuse weight.
bool interchangeable(const Model& model) {
  if (model.terms().size() != 2 || model.terms()[0].form != model.terms()[1].form) return false;
  const TermConstraints &a = model.constraints().terms[0], &b = model.constraints().terms[1];
  for (std::size_t k = 0; k < a.shape.size(); ++k)
    if (!a.shape[k].same_limits(b.shape[k])) return false;
  for (std::size_t k = 0; k < a.weights.size(); ++k) {
    const bool stays = model.terms()[0].info->weights[k].role == Role::diffuse &&
                       (a.weights[k].is_fixed() || b.weights[k].is_fixed());
    if (!stays && !a.weights[k].same_limits(b.weights[k])) return false;
  }
  return true;
}

// Returns the unknowns of two maps that have the same effect on the lobes, as pairs of slots.
std::vector<std::pair<std::size_t, std::size_t>> matching_unknowns(const WeightMap& a, const WeightMap& b) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t u = 0; u < a.unknowns; ++u)
    for (std::size_t v = 0; v < b.unknowns; ++v) {
      bool same = true;
      for (std::size_t l = 0; l < a.lobes; ++l)
        same = same && a.a[l * a.unknowns + u] == b.a[l * b.unknowns + v];
      if (same) pairs.push_back({a.first_slot + u, b.first_slot + v});
    }
  return pairs;
}

// Exchanges the weights of two equal terms, if both are free.
void exchange_natural_weights(const Model& model, WeightTable& weights, Minimum& m) {
  for (std::size_t c = 0; c < model.channels().size(); ++c)
    for (std::size_t k = 0; k < weights[0][c].size(); ++k)
      if (!model.constraints().terms[0].weights[k].is_fixed() &&
          !model.constraints().terms[1].weights[k].is_fixed())
        std::swap(weights[0][c][k], weights[1][c][k]);
  model.set_weights(m.p, weights);
  for (std::size_t s = model.shape_slots(); s < model.size(); ++s) {
    const Slot& slot = model.slots()[s];
    m.at_bound[s] = m.p[s] <= slot.low ? -1 : m.p[s] >= slot.high ? 1 : 0;
  }
}

// Puts the narrower of two equal lobes first.
void order_lobes(const Model& model, Minimum& m) {
  if (!interchangeable(model)) return;
  std::vector<std::size_t> first, second;
  for (std::size_t s = 0; s < model.shape_slots(); ++s)
    if (model.slots()[s].kind == Slot::Kind::shape)
      (model.slots()[s].term == 0 ? first : second).push_back(s);
  if (first.empty()) return;
  const auto has_width = [&](std::size_t s) {
    const Role role = model.slots()[s].role;
    return role == Role::width || role == Role::slope || role == Role::exponent;
  };
  const auto found = std::ranges::find_if(first, has_width);
  const std::size_t k = found == first.end() ? 0 : std::size_t(found - first.begin());
  const bool exponent = model.slots()[first[k]].role == Role::exponent;
  if ((m.p[first[k]] > m.p[second[k]]) == exponent) return;
  WeightTable weights = model.weight_table(m.p);
  for (std::size_t s = 0; s < first.size(); ++s) swap_slots(m, first[s], second[s]);
  if (!model.linear()) {
    exchange_natural_weights(model, weights, m);
    return;
  }
  for (std::size_t c = 0; c < model.channels().size(); ++c)
    for (const auto& [a, b] : matching_unknowns(model.terms()[0].weights[c], model.terms()[1].weights[c]))
      swap_slots(m, a, b);
}

bool same_point(const Model& model, const Minimum& a, const Minimum& b) {
  double largest = 0;
  for (std::size_t k = model.shape_slots(); k < model.size(); ++k)
    largest = std::max({largest, std::abs(a.p[k]), std::abs(b.p[k])});
  for (std::size_t k = 0; k < model.size(); ++k) {
    const double scale = k < model.shape_slots() ? 1.0 : std::max(largest, 1e-12);
    if (std::abs(a.p[k] - b.p[k]) > kSamePoint * scale) return false;
  }
  return true;
}

// Returns the least cost over all weights for these shapes.
double cost_of_shapes(const SampleStream& stream, std::vector<double> p) {
  const Model& model = stream.model();
  const std::size_t first = model.shape_slots(), count = model.size() - first;
  start_weights(stream, p);
  const std::vector<double> start(p.begin() + std::ptrdiff_t(first), p.end());
  const std::vector<double> low = model.low(), high = model.high();
  const Objective objective = [&](std::span<const double> weights) {
    std::copy(weights.begin(), weights.end(), p.begin() + std::ptrdiff_t(first));
    const NormalEquations all = stream.normal_equations(p);
    NormalEquations n{
        Matrix(count, count), {all.gradient.begin() + std::ptrdiff_t(first), all.gradient.end()}, all.cost};
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) n.hessian(i, j) = all.hessian(first + i, first + j);
    return n;
  };
  return solve(objective, start, std::span(low).subspan(first), std::span(high).subspan(first), {}).cost;
}

}  // namespace

void canonicalise(const Model& model, Minimum& m) {
  turn_tangent(model, m);
  order_lobes(model, m);
}

bool same_minimum(const SampleStream& stream, const Minimum& a, const Minimum& b) {
  if (same_point(stream.model(), a, b)) return true;
  const double higher = std::max(a.cost, b.cost);
  if (std::abs(a.cost - b.cost) > kSameCost * higher) return false;
  std::vector<double> middle = a.p, dark = a.p;
  for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = 0.5 * (a.p[k] + b.p[k]);
  std::fill(dark.begin() + std::ptrdiff_t(stream.model().shape_slots()), dark.end(), 0.0);
  const double rounding = kCostRounding * stream.normal_equations(dark).cost;
  return !(cost_of_shapes(stream, std::move(middle)) > (1 + kBarrier) * higher + rounding);
}

}  // namespace brdf::fit
