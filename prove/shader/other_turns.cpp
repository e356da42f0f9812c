#include "prove/shader/other_turns.h"

#include <algorithm>
#include <cmath>

#include "prove/shader/box_steps.h"
#include "prove/shader/number_op.h"
#include "shader/program/operations.h"

namespace brdf::prove {
namespace {

using shader::Op;
using shader::Step;
using shader::Turning;

// A sum of a few bounds rounds; so does a product of subnormal bounds, by kTiny at most.
template <class B>
constexpr double kAbove = 1 + 16 * Interval<B>::kUnit;

// Returns a lower bound of the absolute value at every turn.
template <class B>
double least_of(const Way<B>& w, std::uint32_t slot) {
  if (w.turns[slot]) return 0;
  const Interval<B>& x = w.numbers[slot];
  return x.lo > 0 ? x.lo : x.hi < 0 ? -x.hi : 0;
}

// Returns whether the number is 0, 1 or -1 at every turn: a product with it is exact.
template <class B>
bool is_exact_factor(const Way<B>& w, std::uint32_t slot) {
  const Interval<B>& x = w.numbers[slot];
  return !w.turns[slot] && (x.is(0) || x.is(1) || x.is(-1));
}

template <class B>
double underflow_of_product(const Way<B>& w, std::uint32_t x, std::uint32_t y) {
  using I = Interval<B>;
  const double of_operands = w.most(x) * w.underflow[y] + w.most(y) * w.underflow[x];
  const bool is_normal = least_of(w, x) * least_of(w, y) >= 2 * I::kSmallest;
  if (of_operands == 0 && (is_normal || is_exact_factor(w, x) || is_exact_factor(w, y))) return 0;
  return of_operands * kAbove<B> + 4 * I::kTiny;
}

template <class B>
double underflow_of_quotient(const Way<B>& w, std::uint32_t x, std::uint32_t y) {
  using I = Interval<B>;
  const double least = least_of(w, y), error = w.underflow[y];
  const bool is_normal = least_of(w, x) >= 2 * I::kSmallest * w.most(y);
  if (w.underflow[x] == 0 && error == 0 && (is_normal || is_exact_factor(w, y))) return 0;
  if (!(least > error)) return HUGE_VAL;
  return (w.underflow[x] + w.most(x) / least * error) / (least - error) * kAbove<B> + 4 * I::kTiny;
}

// Returns a bound of the absolute error by underflow, against the same step in real numbers.
template <class B>
double underflow_of(const Way<B>& w, const Step& s) {
  switch (s.op) {
    case Op::copy:
    case Op::neg:
      return w.underflow[s.a];
    case Op::add:
    case Op::sub:
      return (w.underflow[s.a] + w.underflow[s.b]) * kAbove<B>;
    case Op::mul:
      return underflow_of_product(w, s.a, s.b);
    case Op::fma:
      return underflow_of_product(w, s.a, s.b) + w.underflow[s.c];
    case Op::div:
      return underflow_of_quotient(w, s.a, s.b);
    case Op::mix: {
      const double share = 1 + w.most(s.c), of_share = (w.most(s.a) + w.most(s.b)) * w.underflow[s.c];
      return ((w.underflow[s.a] + w.underflow[s.b]) * share + of_share) * kAbove<B> + 8 * Interval<B>::kTiny;
    }
    case Op::select: {
      const Whole& truth = w.integers[s.a];
      if (truth.known()) return w.underflow[truth.bits() != 0 ? s.b : s.c];
      return std::max(w.underflow[s.b], w.underflow[s.c]);
    }
    default:
      // Numbers that do not change and have the same name come from this operation on the same operands:
      // they are the same number, which later steps take as exact.
      return 0;
  }
}

// Returns a bound of the absolute value of a step's result at every turn; for sums, the bound of their
// terms.
template <class B>
double most_of(const Way<B>& w, const Step& s) {
  constexpr double kUp = kAbove<B>;
  switch (s.op) {
    case Op::copy:
    case Op::neg:
      return w.most(s.a);
    case Op::add:
    case Op::sub:
      return (w.most(s.a) + w.most(s.b)) * kUp;
    case Op::mul:
      return w.most(s.a) * w.most(s.b) * kUp;
    case Op::fma:
      return (w.most(s.a) * w.most(s.b) + w.most(s.c)) * kUp;
    case Op::div: {
      const double least = least_of(w, s.b);
      const bool unit = BoxSteps<B>::of_length(w, s);
      return std::min(unit ? kUp : HUGE_VAL, least > 0 ? w.most(s.a) / least * kUp : HUGE_VAL);
    }
    case Op::mix:
      return (w.most(s.a) * (1 + w.most(s.c)) + w.most(s.b) * w.most(s.c)) * kUp;
    case Op::select: {
      const Whole& truth = w.integers[s.a];
      if (truth.known()) return w.most(truth.bits() != 0 ? s.b : s.c);
      return std::max(w.most(s.b), w.most(s.c));
    }
    default:
      return HUGE_VAL;
  }
}

template <class B>
Interval<B> widened_by(const Interval<B>& x, double by) {
  return x.poisoned() ? x : Interval<B>::of(x.lo - by, x.hi + by);
}

}  // namespace

template <class B>
void OtherTurns<B>::begin(Way<B>& w, std::uint32_t slot) {
  w.set_turning(slot, 1 + 8 * I::kUnit);
  w.underflow[slot] = 4 * I::kTiny;
}

template <class B>
auto OtherTurns<B>::result_of(const Way<B>& w, const Step& s, Turning turning) -> Result {
  if (s.op > Op::select) return {};
  Result out;
  out.underflow = underflow_of(w, s);
  if (turning == Turning::still) return out;
  out.most = most_of(w, s) + out.underflow;
  if (turning == Turning::pairs) out.larger = std::max(w.most(s.a), w.most(s.b));
  return out;
}

template <class B>
void OtherTurns<B>::widen(Way<B>& w, const Step& s, Turning turning, const Result& result) const {
  if (turning != Turning::still && s.op > Op::select && s.op <= Op::less_equal_or) return compare(w, s);
  if (s.op > Op::select) return;
  w.underflow[s.r] = result.underflow;
  if (turning == Turning::still) return;
  if (!(result.most <= I::kLargest)) w.numbers[s.r] = I::poison();
  if (turning == Turning::partial)
    w.set_turning(s.r, result.most);
  else
    close(w, s, turning, result);
}

// A closing sum rounds differently at another turn.
template <class B>
void OtherTurns<B>::close(Way<B>& w, const Step& s, Turning turning, const Result& result) const {
  I& value = w.numbers[s.r];
  if (value.poisoned()) return;
  const double roundings = 0.5 * (depth_ + 0.25) * I::kUnit, least = result.underflow + 8 * I::kTiny;
  if (turning == Turning::squares) {
    value = I::of(std::max(value.lo * (1 - roundings) - least, 0.0), value.hi * (1 + roundings) + least);
  } else if (turning == Turning::pairs) {
    const double error = roundings * result.larger + least;
    // A negative end comes from a product of two signs, which was already widened by one unit.
    const double known = value.lo < 0 ? -value.lo * I::kUnit * (1 - 4 * I::kUnit) : 0;
    value = I::of(value.lo - std::max(error - known, 0.0), value.hi + error);
  } else {
    value = widened_by(value, roundings * result.most + least);
  }
}

// At another turn rounding may exchange two numbers that are close.
template <class B>
void OtherTurns<B>::compare(Way<B>& w, const Step& s) const {
  const double error = 0.5 * (depth_ + 2) * I::kUnit * (w.most(s.a) + w.most(s.b)) + w.underflow[s.a] +
                       w.underflow[s.b] + 8 * I::kTiny;
  const I a = widened_by(w.numbers[s.a], error);
  const Tri t = compared<B>(s.op, a, w.numbers[s.b]);
  const bool open = a.poisoned() || w.numbers[s.b].poisoned() || t == Tri::maybe;
  if (open) w.write_integer(s.r, Whole::truth(), w.undefined_integers[s.r]);
}

template class OtherTurns<float>;
template class OtherTurns<double>;

}  // namespace brdf::prove
