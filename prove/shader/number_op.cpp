#include "prove/shader/number_op.h"

#include <algorithm>
#include <cmath>

#include "shader/program/operations.h"

namespace brdf::prove {
namespace {

using shader::Op;

// Returns whether x is exactly a number of Base. Rounding is monotone, so that no rounded result passes
// such a bound.
template <class B>
bool representable(double x) {
  return double(B(x)) == x;
}
template <class B>
Interval<B> added(const Interval<B>& a, const Interval<B>& b) {
  Interval<B> r = a + b;
  if (r.poisoned()) return r;
  const auto exact = [](double x, double y) {
    return (x + y) - x == y && (x + y) - y == x && representable<B>(x + y);
  };
  if (exact(a.lo, b.lo)) r.lo = std::max(r.lo, a.lo + b.lo);
  if (exact(a.hi, b.hi)) r.hi = std::min(r.hi, a.hi + b.hi);
  return r;
}
template <class B>
Interval<B> multiplied(const Interval<B>& a, const Interval<B>& b, bool same) {
  Interval<B> r = same ? square(a) : a * b;
  if (r.poisoned() || a.lo < 0 || b.lo < 0) return r;
  const auto exact = [](double x, double y) {
    return std::fma(x, y, -(x * y)) == 0 && representable<B>(x * y);
  };
  if (exact(a.lo, b.lo)) r.lo = std::max(r.lo, a.lo * b.lo);
  if (exact(a.hi, b.hi)) r.hi = std::min(r.hi, a.hi * b.hi);
  return r;
}

// Bounds x^y for x >= 0 at a point.
Bounds power_at(double x, double y) {
  if (y == 0) return {1, 1};
  if (x == 0) return {0, 0};
  const Bounds l = log_at(x);
  const double p = l.lo * y, q = l.hi * y, low = std::min(p, q), high = std::max(p, q);
  const double least = low - std::fabs(low) * 0x1p-52, most = high + std::fabs(high) * 0x1p-52;
  return {least < -745 ? 0 : exp_at(std::min(least, 709.0)).lo,
          most > 709 ? std::numeric_limits<double>::infinity() : exp_at(std::max(most, -745.0)).hi};
}
// The power is monotone in each operand on either side of 1 and 0: the extremes are at the ends.
template <class B>
Interval<B> power(const Interval<B>& x, const Interval<B>& y) {
  using I = Interval<B>;
  if (x.poisoned() || y.poisoned() || x.lo < 0 || (x.lo == 0 && y.lo <= 0)) return I::poison();
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const double base : {x.lo, x.hi})
    for (const double exponent : {y.lo, y.hi}) {
      if (base > 0 && base < 0x1p-1022) return I::poison();
      const Bounds p = power_at(base, exponent);
      low = std::min(low, p.lo);
      high = std::max(high, p.hi);
    }
  if (x.lo < 1 && x.hi > 1) low = std::min(low, 1.0), high = std::max(high, 1.0);
  return I::widened(low, high, I::kKernelUnits);
}

// Bounds the angle of a cosine in [-1, 1]; it decreases.
Bounds arc_cosine(double x) {
  const double sine = std::sqrt((1 - x) * (1 + x));
  const Bounds a = angle_at(sine, std::fabs(x));
  const double slack = 4e-16;
  return x >= 0 ? Bounds{a.lo - slack, a.hi + slack}
                : Bounds{kPiBounds.lo - a.hi - slack, kPiBounds.hi - a.lo + slack};
}
template <class B>
Interval<B> arc_cosine(const Interval<B>& x) {
  using I = Interval<B>;
  if (x.poisoned() || x.lo < -1 || x.hi > 1) return I::poison();
  return I::widened(std::max(arc_cosine(x.hi).lo, 0.0), arc_cosine(x.lo).hi, I::kKernelUnits);
}
template <class B>
Interval<B> arc_tangent(const Interval<B>& x) {
  using I = Interval<B>;
  if (x.poisoned()) return x;
  const auto at = [](double t) {
    const Bounds a = angle_at(std::fabs(t), 1);
    return t < 0 ? Bounds{-a.hi, -a.lo} : a;
  };
  return I::widened(at(x.lo).lo, at(x.hi).hi, I::kKernelUnits);
}

template <class B>
Interval<B> within(const Interval<B>& x, double low, double high) {
  return x.poisoned() ? x : Interval<B>::of(low, high);
}
template <class B>
Interval<B> sine_of(const Interval<B>& x) {
  if (x.poisoned() || x.lo < 0 || x.hi > 1.57) return within(x, -1, 1);
  return Interval<B>::widened(sin_at(x.lo).lo, std::min(sin_at(x.hi).hi, 1.0), Interval<B>::kKernelUnits);
}
template <class B>
Interval<B> cosine_of(const Interval<B>& x) {
  if (x.poisoned() || x.lo < 0 || x.hi > 1.6) return within(x, -1, 1);
  return Interval<B>::widened(cos_at(x.hi).lo, std::min(cos_at(x.lo).hi, 1.0), Interval<B>::kKernelUnits);
}

// A mean with shares from 0 to 1 lies between its operands; the difference, both products and the sum round.
template <class B>
Interval<B> mixed(const Interval<B>& a, const Interval<B>& b, const Interval<B>& c) {
  using I = Interval<B>;
  const I sum = added(multiplied(a, added(I(1), -c), false), multiplied(b, c, false));
  if (sum.poisoned() || !(c.lo >= 0 && c.hi <= 1)) return sum;
  const double error = 8 * I::kUnit * std::max(a.magnitude(), b.magnitude()) + 8 * I::kTiny;
  return I::of(std::max(sum.lo, std::min(a.lo, b.lo) - error),
               std::min(sum.hi, std::max(a.hi, b.hi) + error));
}

template <class B>
Interval<B> absolute(const Interval<B>& x) {
  if (x.poisoned()) return x;
  const double least = x.lo > 0 ? x.lo : x.hi < 0 ? -x.hi : 0;
  return Interval<B>::of(least, x.magnitude());
}
template <class B, class F>
Interval<B> monotone(const Interval<B>& x, F f) {
  return x.poisoned() ? x : Interval<B>::of(f(x.lo), f(x.hi));
}

}  // namespace

template <class B>
std::optional<Interval<B>> number_op(Op op, const Interval<B>& a, const Interval<B>& b,
                                     const Interval<B>& c) {
  using I = Interval<B>;
  const auto floor = [](const I& x) { return monotone(x, [](double v) { return std::floor(v); }); };
  const auto share = [](const I& x) { return I::of(std::max(x.lo, 0.0), std::min(x.hi, 1.0)); };
  const auto trunc = [](const I& x) { return monotone(x, [](double v) { return std::trunc(v); }); };
  switch (op) {
    case Op::copy:
      return a;
    case Op::add:
      return added(a, b);
    case Op::sub:
      return added(a, -b);
    case Op::mul:
      return multiplied(a, b, &a == &b);
    case Op::div:
      return a / b;
    case Op::neg:
      return -a;
    case Op::mod:
      return a - b * floor(a / b);
    case Op::rem:
      return a - b * trunc(a / b);
    case Op::abs:
      return absolute(a);
    case Op::sign:
      return monotone(a, [](double v) { return double((v > 0) - (v < 0)); });
    case Op::floor:
      return floor(a);
    case Op::ceil:
      return monotone(a, [](double v) { return std::ceil(v); });
    case Op::trunc:
      return trunc(a);
    case Op::round:  // GLSL leaves open which way a half is rounded
      return a.poisoned() ? a : I::of(std::ceil(a.lo - 0.5), std::floor(a.hi + 0.5));
    case Op::round_even:
      return monotone(a, [](double v) { return std::nearbyint(v); });
    case Op::fract:
      return a.poisoned()                           ? a
             : std::floor(a.lo) == std::floor(a.hi) ? share(added(a, -floor(a)))
                                                    : I::of(0, 1);
    case Op::sqrt:
      return sqrt(a);
    case Op::inverse_sqrt:
      return I(1) / sqrt(a);
    case Op::exp:
      return exp(a);
    case Op::exp2:
      return exp(a * I::widened(0.69314718055994530, 0.69314718055994531));
    case Op::log:
      return log(a);
    case Op::log2:
      return log(a) / I::widened(0.69314718055994530, 0.69314718055994531);
    case Op::pow:
      return power(a, b);
    case Op::sin:
      return sine_of(a);
    case Op::cos:
      return cosine_of(a);
    case Op::tan:
      return sine_of(a) / cosine_of(a);
    case Op::asin:
      return I::widened(kPiBounds.lo / 2, kPiBounds.hi / 2) - arc_cosine(a);
    case Op::acos:
      return arc_cosine(a);
    case Op::atan:
      return arc_tangent(a);
    case Op::atan2:
      if (a.lo >= 0 && b.lo >= 0 && !a.poisoned() && !b.poisoned()) return atan2(a, b);
      return a.poisoned() || b.poisoned() ? I::poison()
                                          : I::widened(-kPiBounds.hi, kPiBounds.hi, I::kKernelUnits);
    case Op::angle:
      return atan2(a, b);
    case Op::tanh:
      return within(a, -1, 1);
    case Op::log1p:
      return log1p(a + b);
    case Op::erfcx:
      return erfcx(a);
    case Op::min:
      return smaller(a, b);
    case Op::max:
      return larger(a, b);
    case Op::clamp:
      return smaller(larger(a, b), c);
    case Op::mix:
      return mixed(a, b, c);
    case Op::step:
      return a.poisoned() || b.poisoned() ? I::poison() : I::of(b.lo >= a.hi ? 1 : 0, b.hi < a.lo ? 0 : 1);
    case Op::smoothstep: {
      const I t = smaller(larger((c - a) / (b - a), I()), I(1));
      const auto value = [](double x) { return x * x * (3 - 2 * x); };  // increasing
      return t.poisoned() ? t : I::widened(value(t.lo), value(t.hi), 8);
    }
    case Op::fma:
      return added(multiplied(a, b, &a == &b), c);
    // Nothing is known of these operations yet.
    case Op::sinh:
    case Op::cosh:
    case Op::to_half:
      return std::nullopt;
    // Operations on integers, and on both kinds: box_steps.cpp, whole.cpp.
    case Op::select:
    case Op::equal:
    case Op::not_equal:
    case Op::less:
    case Op::less_equal:
    case Op::not_equal_or:
    case Op::less_or:
    case Op::less_equal_or:
    case Op::is_nan:
    case Op::is_inf:
    case Op::to_signed:
    case Op::to_unsigned:
    case Op::bits_of:
    case Op::from_signed:
    case Op::from_unsigned:
    case Op::from_bits:
    case Op::texel:
    case Op::icopy:
    case Op::iadd:
    case Op::isub:
    case Op::imul:
    case Op::sdiv:
    case Op::udiv:
    case Op::smod:
    case Op::srem:
    case Op::umod:
    case Op::ineg:
    case Op::iand:
    case Op::ior:
    case Op::ixor:
    case Op::inot:
    case Op::shl:
    case Op::shr:
    case Op::sar:
    case Op::ieq:
    case Op::ine:
    case Op::slt:
    case Op::sle:
    case Op::ult:
    case Op::ule:
    case Op::imin:
    case Op::imax:
    case Op::umin:
    case Op::umax:
    case Op::index:
    case Op::iabs:
    case Op::isign:
    case Op::iselect:
    case Op::logical_not:
    case Op::load_number:
    case Op::load_integer:
    case Op::store_number:
    case Op::store_integer:
    case Op::count:
      break;
  }
  return std::nullopt;
}

template <class B>
Tri compared(Op op, const Interval<B>& a, const Interval<B>& b) {
  const auto opposite = [](Tri t) { return t == Tri::maybe ? t : t == Tri::yes ? Tri::no : Tri::yes; };
  const auto equal = [&] {
    if (a.lo == a.hi && a.lo == b.lo && b.lo == b.hi) return Tri::yes;
    return a.hi < b.lo || b.hi < a.lo ? Tri::no : Tri::maybe;
  };
  switch (shader::operation(op).compares) {
    case shader::Operation::Compares::equal:
      return equal();
    case shader::Operation::Compares::not_equal:
      return opposite(equal());
    case shader::Operation::Compares::less:
      return a < b;
    case shader::Operation::Compares::less_equal:
      return opposite(b < a);
    case shader::Operation::Compares::no:
      break;
  }
  return Tri::maybe;
}

template std::optional<Interval<float>> number_op(Op, const Interval<float>&, const Interval<float>&,
                                                  const Interval<float>&);
template std::optional<Interval<double>> number_op(Op, const Interval<double>&, const Interval<double>&,
                                                   const Interval<double>&);
template Tri compared(Op, const Interval<float>&, const Interval<float>&);
template Tri compared(Op, const Interval<double>&, const Interval<double>&);

}  // namespace brdf::prove
