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

}  // namespace brdf::fit
