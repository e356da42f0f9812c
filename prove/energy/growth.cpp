#include "prove/energy/growth.h"

#include <array>
#include <cmath>

#include "prove/scalar/recorded_form.h"
#include "prove/scalar/ward_energy.h"

namespace brdf::prove {
namespace {

using I = Interval<double>;

// The mean over slopes p = a X with the density e^(-X^2)/sqrt(pi), in cells of X.
constexpr int kCells = 1536;
// erfc(6) is 2e-17, and the averaged function is at most sqrt(2).
constexpr double kReach = 6, kStep = 2 * kReach / kCells, kBeyond = 1e-15;

struct Cell {
  I x, weight;
};
const std::array<Cell, kCells>& cells() {
  static const auto all = [] {
    const I over_root_pi = I::widened(0.56418958354775628, 0.56418958354775628, 2);
    std::array<Cell, kCells> made;
    for (int k = 0; k < kCells; ++k) {
      const double low = -kReach + k * kStep, high = -kReach + (k + 1) * kStep, middle = (low + high) / 2;
      // The midpoint rule: the second derivative of the density is at most 2.
      const Bounds at = exp_at(-middle * middle);
      const I density = I::widened(at.lo - kStep * kStep / 12, at.hi + kStep * kStep / 12, 16);
      made[std::size_t(k)] = {I::of(low, high), I(kStep) * at_least(density, I()) * over_root_pi};
    }
    return made;
  }();
  return all;
}

I sine_of(const I& cosine) {
  return I::widened(std::sqrt((1 - cosine.hi) * (1 + cosine.hi)),
                    std::sqrt((1 - cosine.lo) * (1 + cosine.lo)), 4);
}

// Returns cos^power times the reflection of a slope p; `across` is the squared slope across.
template <WardKind kind>
I reflected(const I& p, const I& across, const I& cosine, const I& sine) {
  const I a = at_least(cosine + sine * p, I());
  if (a.hi <= 0) return I();
  const I s = I(1) + square(p) + across, above = I(2) * a / s - cosine;
  if (above.hi <= 0) return I();
  if constexpr (kind == WardKind::root) return a * sqrt(at_least(above, I())) / square(s);
  const I lit = a / square(s);
  return above.lo > 0 ? lit : hull(I(), lit);
}

template <WardKind kind>
Bounds mean(std::span<const Bounds> box, const I& across, double beyond) {
  const I width = I::of(box[0].lo, box[0].hi), cosine = I::of(box[1].lo, box[1].hi), sine = sine_of(cosine);
  I sum;
  for (const Cell& c : cells()) sum = sum + c.weight * reflected<kind>(width * c.x, across, cosine, sine);
  return {std::max(sum.lo - beyond, 0.0), sum.hi + beyond};
}

// A slope across only reduces the reflection, since s grows with the slope.
template <WardKind kind>
Bounds most(std::span<const Bounds> box) {
  return {0, mean<kind>(box, I(), kBeyond).hi};
}
// At the least width of the tables, 1e-4, all slopes across except a share of e^-100 are below 1e-3.
template <WardKind kind>
Bounds reached(std::span<const Bounds> box) {
  return mean<kind>(box, I::of(0, 1e-6), kBeyond);
}

constexpr double kFrom = 89, kCosineThere = 0.017452406437283512;

template <WardKind kind>
GrowthMethod grows(const ParameterInfo& width) {
  return {kind == WardKind::root ? 0.5 : 1.0,
          kFrom,
          {{{"width", width.min, width.max, Variable::Cut::logarithmic},
            {"cosine", 0, kCosineThere, Variable::Cut::middle}}},
          most<kind>,
          reached<kind>};
}

template <Form F>
std::optional<GrowthMethod> method_of(F form) {
  if constexpr (WardForm<F>) {
    const ParameterInfo width = F::template Shape<double>::fields()[0].info;
    if (width.min != 1e-4) return std::nullopt;
    if (is_ward<WardKind::root>(form)) return grows<WardKind::root>(width);
    if (is_ward<WardKind::product>(form)) return grows<WardKind::product>(width);
  }
  return std::nullopt;
}

}  // namespace

Reached reached_at(const GrowthMethod& method, double width) {
  constexpr int kParts = 8;  // of the cosines
  const double far = method.domain.variables[1].high;
  Reached found{1e300, 0};
  for (int k = 0; k < kParts; ++k) {
    const std::array box{Bounds{width, width}, Bounds{far * k / kParts, far * (k + 1) / kParts}};
    const double low = method.reached(box).lo;
    found = {std::min(found.least, low), std::max(found.most, low)};
  }
  return found;
}

const GrowthMethod* growth_method(int place) {
  return recorded_method<GrowthMethod>(place, [](auto form) { return method_of(form); });
}

}  // namespace brdf::prove
