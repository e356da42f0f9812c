#include "fit/solve/minima.h"

#include <algorithm>
#include <cmath>

#include "brdf/random.h"
#include "fit/solve/varpro.h"
#include "io/numbers.h"

namespace brdf::fit {
namespace {

constexpr std::size_t kCoarseRows = 4096;  // what the starts are solved on
constexpr std::size_t kMiddleShare = 16;   // then every 16th row, then all
constexpr double kWidthFloor = 0.004;      // narrowest width in the grid, as a share of the widest
constexpr std::size_t kReseats = 12;       // widths at which a lobe of a sum is tried again
constexpr std::size_t kPolished = 6;       // minima that are solved on all rows
constexpr double kSamePoint = 1e-3;
constexpr double kBarrier = 1e-4;    // rise of the cost between two minima that makes them two
constexpr double kRounding = 1e-20;  // of a cost, as a share of that of a black surface

double grid_value(const Slot& slot, std::size_t k, std::size_t n) {
  const double high = slot.to_solver(slot.grid_max);
  double low = slot.low;
  const bool exponent = slot.role == Role::exponent || slot.role == Role::exponent_across;
  if (slot.scale == Scale::log && !exponent) low = std::max(low, slot.to_solver(slot.grid_max * kWidthFloor));
  low = std::min(low, high);
  return n == 1 ? 0.5 * (low + high) : low + (high - low) * (double(k) + 0.5) / double(n);
}

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

// Grid over the distinct shape parameters; sets of shapes per channel share a point.
std::vector<std::vector<double>> grid_starts(const Model& model) {
  std::vector<std::vector<std::size_t>> dimensions;  // slots that share a value
  for (std::size_t s = 0; s < model.shape_slots(); ++s) {
    const Slot& slot = model.slots()[s];
    const auto same = [&](const std::vector<std::size_t>& d) {
      return model.slots()[d[0]].same_parameter(slot);
    };
    const auto found = std::find_if(dimensions.begin(), dimensions.end(), same);
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
    if (slot.kind == Slot::Kind::tangent) {
      p[s] = kPi * u;
      continue;
    }
    const double low = grid_value(slot, 0, 1000000), high = slot.to_solver(slot.grid_max);
    p[s] = low + (high - low) * u;
  }
  return p;
}

// The best weights for the shapes of p under the residual linearised at the measurement.
void start_weights(const SampleStream& stream, std::vector<double>& p) {
  const Model& model = stream.model();
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

void swap_slots(Minimum& m, std::size_t a, std::size_t b) {
  std::swap(m.p[a], m.p[b]);
  std::swap(m.at_bound[a], m.at_bound[b]);
}

// Pairs of slots that change places where the frame turns by a right angle: the widths along and across of every
// term. None where some are held, tied or bounded apart.
std::vector<std::pair<std::size_t, std::size_t>> crossed_slots(const Model& model) {
  const auto shape_slot = [&](std::size_t term, int member, std::size_t group) {
    for (std::size_t s = 0; s < model.shape_slots(); ++s) {
      const Slot& slot = model.slots()[s];
      if (slot.kind == Slot::Kind::shape && slot.term == term && slot.group == group &&
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
      if (along == kNoSlot || across == kNoSlot || !model.slots()[along].same_range(model.slots()[across]))
        return {};
      pairs.push_back({along, across});
    }
  }
  return pairs;
}

// The tangent in (-45, 45] degrees, or in (-90, 90] where the widths cannot change places.
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

// Whether both terms of a sum are the same form under the same constraints (one diffuse part apart).
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

// The unknowns of two maps that have the same effect on the lobes, as pairs of slots.
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

// The narrower of two equal lobes first.
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
  const auto found = std::find_if(first.begin(), first.end(), has_width);
  const std::size_t k = found == first.end() ? 0 : std::size_t(found - first.begin());
  const bool exponent = model.slots()[first[k]].role == Role::exponent;
  if ((m.p[first[k]] > m.p[second[k]]) == exponent) return;
  for (std::size_t s = 0; s < first.size(); ++s) swap_slots(m, first[s], second[s]);
  for (std::size_t c = 0; c < model.channels().size(); ++c)
    for (const auto& [a, b] : matching_unknowns(model.terms()[0].weights[c], model.terms()[1].weights[c]))
      swap_slots(m, a, b);
}

// Equivalent parameters, written one way.
void canonicalise(const Model& model, Minimum& m) {
  turn_tangent(model, m);
  order_lobes(model, m);
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

// The least cost that weights can give these shapes.
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

// Starts that end at the same cost in different places are one minimum where nothing stands between them, as on a
// parameter that the samples do not see; else they are two answers.
bool same_minimum(const SampleStream& stream, const Minimum& a, const Minimum& b) {
  if (same_point(stream.model(), a, b)) return true;
  const double higher = std::max(a.cost, b.cost);
  if (std::abs(a.cost - b.cost) > kSameCost * higher) return false;
  std::vector<double> middle = a.p, dark = a.p;
  for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = 0.5 * (a.p[k] + b.p[k]);
  std::fill(dark.begin() + std::ptrdiff_t(stream.model().shape_slots()), dark.end(), 0.0);
  const double rounding = kRounding * stream.normal_equations(dark).cost;
  return !(cost_of_shapes(stream, std::move(middle)) > (1 + kBarrier) * higher + rounding);
}

void add_minimum(const SampleStream& stream, Minimum m, std::vector<Minimum>& minima) {
  for (Minimum& other : minima) {
    if (!same_minimum(stream, m, other)) continue;
    const int basin = other.basin + m.basin;
    if (m.cost < other.cost) other = std::move(m);
    other.basin = basin;
    return;
  }
  minima.push_back(std::move(m));
}

void sort_minima(std::vector<Minimum>& minima) {
  std::sort(minima.begin(), minima.end(), [](const Minimum& a, const Minimum& b) { return a.cost < b.cost; });
}

// Tuning constants of 95 % efficiency at the normal distribution.
double robust_scale(const SampleStream& stream, const LossFunction& loss, std::span<const double> p) {
  std::vector<double> size;
  for (const auto& channel : stream.residual_values(p))
    for (double r : channel) size.push_back(std::abs(r));
  const double deviation = 1.4826 * io::median(std::move(size));
  return deviation * (loss.kind == LossFunction::Kind::huber ? 1.345 : 2.385);
}

Minimum to_minimum(const Model& model, Solution s) {
  Minimum m{std::move(s.p), s.cost, 1, std::move(s.at_bound), s.termination, std::move(s.message)};
  canonicalise(model, m);
  return m;
}

class Search {
 public:
  Search(const FitData& data, const Model& model, const Residual& residual, const FitOptions& options)
      : data_(data), model_(model), residual_(residual), options_(options) {}

  SearchResult run() {
    std::vector<std::vector<double>> starts = all_starts();
    result_.starts = int(starts.size());
    const bool coarse = data_.rows() > 2 * kCoarseRows;
    const FitData few = coarse ? thinned(data_, kCoarseRows) : FitData();
    const FitData& first = coarse ? few : data_;
    estimate_loss_scale(first, starts);
    std::vector<Minimum> minima = solve_all(first, starts, coarse ? 1e-8 : 1e-12);
    if (estimated_scale_ && !minima.empty()) {
      // The scale came from crude weights: take it again from the best fit, and solve again from there.
      const SampleStream stream(first, model_, residual_, options_.aperture);
      residual_.loss.scale =
          std::max(robust_scale(stream, residual_.loss, minima[0].p), 1e-3 * residual_.loss.scale);
      minima = polish(first, minima, 1e-12);
    }
    if (coarse) {
      if (data_.rows() > kMiddleShare * kCoarseRows) {
        const FitData middle = thinned(data_, data_.rows() / kMiddleShare);
        minima = polish(middle, minima, 1e-8);
      }
      minima = polish(data_, minima, 1e-10);
    }
    result_.minima = std::move(minima);
    result_.loss_scale = residual_.loss.scale;
    return std::move(result_);
  }

 private:
  std::vector<std::vector<double>> all_starts() {
    std::vector<std::vector<double>> starts;
    if (!options_.start.empty()) {
      std::vector<double> p = model_.initial();
      model_.apply_start(p);
      starts.push_back(std::move(p));
    }
    if (model_.shape_slots() == 0) {
      if (starts.empty()) starts.push_back(model_.initial());
      return starts;
    }
    if (options_.grid_starts)
      for (auto& p : grid_starts(model_)) starts.push_back(std::move(p));
    std::mt19937_64 random(options_.seed);
    for (int k = 0; k < options_.random_starts; ++k) starts.push_back(random_start(model_, random));
    return starts;
  }

  void estimate_loss_scale(const FitData& data, const std::vector<std::vector<double>>& starts) {
    const auto kind = residual_.loss.kind;
    if (kind == LossFunction::Kind::none || residual_.loss.scale > 0) return;
    double smallest = std::numeric_limits<double>::infinity();
    const SampleStream stream(data, model_, residual_, options_.aperture);
    for (std::vector<double> p : starts) {
      if (options_.stop()) break;
      start_weights(stream, p);
      smallest = std::min(smallest, robust_scale(stream, residual_.loss, p));
    }
    residual_.loss.scale = std::isfinite(smallest) && smallest > 1e-12 ? smallest : 1e-12;
    estimated_scale_ = true;
  }

  SolveOptions solver(double tolerance) const {
    SolveOptions o;
    o.tolerance = tolerance;
    o.interrupted = options_.interrupted;
    return o;
  }

  // In a sum, one lobe can be caught by a few outliers where it keeps the other from its place. Each lobe in
  // turn is taken out and tried at every width of the grid, the others held; the best is solved again.
  Minimum reseat_lobes(const SampleStream& stream, Minimum m, double tolerance) {
    if (model_.terms().size() < 2) return m;
    for (std::size_t s = 0; s < model_.shape_slots(); ++s) {
      const Slot& slot = model_.slots()[s];
      if (slot.kind != Slot::Kind::shape || slot.group != 0 || options_.stop()) continue;
      std::vector<double> best;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < kReseats; ++k) {
        std::vector<double> p = m.p;
        for (std::size_t other = 0; other < model_.shape_slots(); ++other) {
          const Slot& same = model_.slots()[other];  // the same parameter of other channels, too
          if (same.same_parameter(slot)) p[other] = grid_value(same, k, kReseats);
        }
        start_weights(stream, p);
        ++result_.passes;
        const double cost = stream.normal_equations(p).cost;
        if (cost < least) {
          least = cost;
          best = std::move(p);
        }
      }
      if (best.empty()) continue;
      Minimum other = solve_one(stream, best, tolerance);
      if (other.cost < m.cost) m = std::move(other);
    }
    return m;
  }

  Minimum solve_one(const SampleStream& stream, std::span<const double> start, double tolerance) {
    Solution s = refine(stream, start, solver(tolerance));
    result_.passes += s.passes;
    result_.iterations += s.iterations;
    if (s.termination == Termination::interrupted) result_.interrupted = true;
    return to_minimum(model_, std::move(s));
  }

  std::vector<Minimum> solve_all(const FitData& data, const std::vector<std::vector<double>>& starts,
                                 double tolerance) {
    const SampleStream stream(data, model_, residual_, options_.aperture);
    std::vector<Minimum> minima;
    for (std::size_t k = 0; k < starts.size(); ++k) {
      std::vector<double> p = starts[k];
      if (options_.stop() && !minima.empty()) {
        result_.interrupted = true;
        break;
      }
      start_weights(stream, p);
      if (k == 0 && !options_.start.empty()) model_.apply_start_weights(p);
      Minimum m = reseat_lobes(stream, solve_one(stream, p, tolerance), tolerance);
      if (std::isfinite(m.cost)) add_minimum(stream, std::move(m), minima);
    }
    sort_minima(minima);
    return minima;
  }

  // The best few, solved again on other rows; the rest keep their place in the list with the cost they had.
  std::vector<Minimum> polish(const FitData& data, const std::vector<Minimum>& minima, double tolerance) {
    const SampleStream stream(data, model_, residual_, options_.aperture);
    std::vector<Minimum> out;
    for (std::size_t k = 0; k < std::min(minima.size(), kPolished); ++k) {
      if (options_.stop() && !out.empty()) {
        result_.interrupted = true;
        break;
      }
      // A minimum far above the best is listed, not polished: it cannot become the answer.
      if (k > 0 && minima[k].cost > 1.5 * minima[0].cost + 1e-300) break;
      Minimum m = solve_one(stream, minima[k].p, tolerance);
      m.basin = minima[k].basin;
      add_minimum(stream, std::move(m), out);
    }
    sort_minima(out);
    return out;
  }

  const FitData& data_;
  const Model& model_;
  Residual residual_;
  const FitOptions& options_;
  SearchResult result_;
  bool estimated_scale_ = false;
};

}  // namespace

Solution refine(const SampleStream& stream, std::span<const double> start, const SolveOptions& options) {
  const Model& model = stream.model();
  const std::vector<double> low = model.low(), high = model.high();
  const Objective objective = [&](std::span<const double> p) { return stream.normal_equations(p); };
  if (!projects(stream)) return solve(objective, start, low, high, options);
  bool exact = false;
  Solution projected = solve_projected(stream, start, options, exact);
  if (exact) return projected;
  // Finish on the residuals themselves, which lose no digits.
  Solution s = solve(objective, projected.p, low, high, options);
  s.passes += projected.passes;
  s.iterations += projected.iterations;
  return s;
}

SearchResult find_minima(const FitData& data, const Model& model, const Residual& residual,
                         const FitOptions& options) {
  return Search(data, model, residual, options).run();
}

}  // namespace brdf::fit
