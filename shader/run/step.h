// Executes one operation of a program in some lanes; defines the effect of each operation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "shader/program/half.h"
#include "shader/program/program.h"
#include "shader/run/bank.h"
#include "shader/run/functions.h"

namespace brdf::shader {

// All lanes, or a subset.
template <int W>
struct AllLanes {
  template <class Body>
  [[gnu::always_inline]] void operator()(const Body& body) const {
#if !defined(__clang__)
#pragma GCC ivdep
#endif
    for (int l = 0; l < W; ++l) body(l);
  }
};
struct SomeLanes {
  const std::uint8_t* lanes;
  int count;
  template <class Body>
  void operator()(const Body& body) const {
    for (int k = 0; k < count; ++k) body(lanes[k]);
  }
};

namespace detail {

// Rounds towards zero. Values outside the integer range give the nearest integer; NaN gives 0.
inline std::uint32_t to_integer(double v, Op to) {
  const double least = to == Op::to_signed ? -2147483648.0 : 0,
               most = to == Op::to_signed ? 2147483647.0 : 4294967295.0;
  return v != v ? 0 : std::uint32_t(std::int64_t(std::clamp(v, least, most)));
}

template <class T>
bool is_nan(const T& x) {
  return Functions<T>::value(x) != Functions<T>::value(x);
}

template <class T>
T pick(bool condition, const T& yes, const T& no) {
  return select(condition, yes, no);
}

template <class T>
T round_half_even(const T& x) {
  using F = Functions<T>;
  const T down = F::floor(x), rest = x - down;
  const double v = F::value(rest), half = F::value(down) * 0.5;
  const bool up = v > 0.5 || (v == 0.5 && half != std::floor(half));
  return up ? down + T(1.0) : down;
}

// Powers by repeated products in double. They round to the same float as the exponential of the logarithm,
// except for about one argument in 1e8, and take a fifth of the time. The result is NaN for a base below 0,
// as in Functions.
inline float rounded_power(float x, double power) {
  return x > 0 ? float(power) : x == 0 ? 0.0f : std::numeric_limits<float>::quiet_NaN();
}
template <int W>
void whole_power(float* r, const float* x, std::uint32_t exponent, AllLanes<W>) {
  std::array<double, std::size_t(W)> base, power;
  for (std::size_t l = 0; l < W; ++l) base[l] = double(x[l]), power[l] = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1)
      for (std::size_t l = 0; l < W; ++l) power[l] *= base[l];
    for (std::size_t l = 0; l < W; ++l) base[l] *= base[l];
  }
  for (std::size_t l = 0; l < W; ++l) r[l] = rounded_power(x[l], power[l]);
}
template <int W>
void whole_power(float* r, const float* x, std::uint32_t exponent, const SomeLanes& lanes) {
  lanes([&](int l) { whole_power<1>(r + l, x + l, exponent, AllLanes<1>{}); });
}

// Executes one step in the given lanes. Numbers: r, a, b, c. Integers: ri, ai, bi, ci.
template <class T, int W, class Lanes>
[[gnu::always_inline]] inline void run_step(const Step& s, Bank<T, W>& bank, const Lanes& lanes) {
  using F = Functions<T>;
  const auto num = [&](std::uint32_t slot) { return bank.number(slot); };
  const auto whole = [&](std::uint32_t slot) { return bank.integer(slot); };
  const auto unary = [&](auto&& f) __attribute__((always_inline)) {
    const auto r = num(s.r), a = num(s.a);
    lanes([&](int l) { r[l] = f(a[l]); });
  };
  const auto binary = [&](auto&& f) __attribute__((always_inline)) {
    const auto r = num(s.r), a = num(s.a), b = num(s.b);
    lanes([&](int l) { r[l] = f(a[l], b[l]); });
  };
  const auto ternary = [&](auto&& f) __attribute__((always_inline)) {
    const auto r = num(s.r), a = num(s.a), b = num(s.b), c = num(s.c);
    lanes([&](int l) { r[l] = f(a[l], b[l], c[l]); });
  };
  const auto test = [&](auto&& f) __attribute__((always_inline)) {
    std::uint32_t* const r = whole(s.r);
    const auto a = num(s.a), b = num(s.b);
    lanes([&](int l) { r[l] = f(a[l], b[l]); });
  };
  const auto probe = [&](auto&& f) __attribute__((always_inline)) {
    std::uint32_t* const r = whole(s.r);
    const auto a = num(s.a);
    lanes([&](int l) { r[l] = f(a[l]); });
  };
  const auto made = [&](auto&& f) __attribute__((always_inline)) {
    const auto r = num(s.r);
    const std::uint32_t* const a = whole(s.a);
    lanes([&](int l) { r[l] = f(a[l]); });
  };
  const auto integer = [&](auto&& f) __attribute__((always_inline)) {
    std::uint32_t* const r = whole(s.r);
    const std::uint32_t *const a = whole(s.a), *const b = whole(s.b);
    lanes([&](int l) { r[l] = f(a[l], b[l]); });
  };
  const auto i32 = [](std::uint32_t x) { return std::int32_t(x); };
  const T one = F::number(1), zero = F::number(0);
  switch (s.op) {
    case Op::copy:
      return unary([](const T& a) { return a; });
    case Op::add:
      return binary([](const T& a, const T& b) { return a + b; });
    case Op::sub:
      return binary([](const T& a, const T& b) { return a - b; });
    case Op::mul:
      return binary([](const T& a, const T& b) { return a * b; });
    case Op::div:
      return binary([](const T& a, const T& b) { return a / b; });
    case Op::neg:
      return unary([](const T& a) { return -a; });
    case Op::mod:
      return binary([](const T& a, const T& b) { return a - b * F::floor(a / b); });
    case Op::rem:
      return binary([](const T& a, const T& b) { return a - b * F::trunc(a / b); });
    case Op::abs:
      return unary([&](const T& a) { return pick(a < zero, -a, a); });
    case Op::sign:
      return unary([&](const T& a) { return pick(zero < a, one, pick(a < zero, -one, zero)); });
    case Op::floor:
      return unary([](const T& a) { return F::floor(a); });
    case Op::ceil:
      return unary([](const T& a) { return -F::floor(-a); });
    case Op::trunc:
      return unary([](const T& a) { return F::trunc(a); });
    case Op::round:
    case Op::round_even:
      return unary([](const T& a) { return round_half_even(a); });
    case Op::fract:
      return unary([](const T& a) { return a - F::floor(a); });
    case Op::sqrt:
      return unary([](const T& a) { return F::sqrt(a); });
    case Op::inverse_sqrt:
      return unary([&](const T& a) { return one / F::sqrt(a); });
    case Op::exp:
      return unary([](const T& a) { return F::exp(a); });
    case Op::exp2:
      return unary([](const T& a) { return F::exp2(a); });
    case Op::log:
      return unary([](const T& a) { return F::log(a); });
    case Op::log2:
      return unary([](const T& a) { return F::log2(a); });
    case Op::pow:
      if constexpr (std::is_same_v<T, float>)
        if (s.c > 0) return whole_power<W>(num(s.r), num(s.a), s.c, lanes);
      return binary([](const T& a, const T& b) { return F::pow(a, b); });
    case Op::sin:
      return unary([](const T& a) { return F::sin(a); });
    case Op::cos:
      return unary([](const T& a) { return F::cos(a); });
    case Op::tan:
      return unary([](const T& a) { return F::tan(a); });
    case Op::asin:
      return unary([](const T& a) { return F::asin(a); });
    case Op::acos:
      return unary([](const T& a) { return F::acos(a); });
    case Op::atan:
      return unary([](const T& a) { return F::atan(a); });
    case Op::atan2:
      return binary([](const T& a, const T& b) { return F::atan2(a, b); });
    case Op::sinh:
      return unary([](const T& a) { return F::sinh(a); });
    case Op::cosh:
      return unary([](const T& a) { return F::cosh(a); });
    case Op::tanh:
      return unary([](const T& a) { return F::tanh(a); });
    case Op::log1p:
      return binary([](const T& a, const T& b) { return F::log1p(a, b); });
    case Op::erfcx:
      return unary([](const T& a) { return F::erfcx(a); });
    case Op::angle:
      return binary([](const T& a, const T& b) { return F::angle(a, b); });
    case Op::to_half:
      if constexpr (std::is_same_v<T, float>)
        return unary([](float a) { return rounded_to_half(a); });
      else
        return unary([](const T& a) { return a; });
    // As GLSL defines them: if an operand is NaN, the result is the first operand.
    case Op::min:
      return binary([](const T& a, const T& b) { return pick(b < a, b, a); });
    case Op::max:
      return binary([](const T& a, const T& b) { return pick(a < b, b, a); });
    case Op::clamp:
      return ternary([](const T& a, const T& b, const T& c) {
        const T least = pick(a < b, b, a);
        return pick(c < least, c, least);
      });
    case Op::mix:
      return ternary([&](const T& a, const T& b, const T& c) { return a * (one - c) + b * c; });
    case Op::step:
      return binary([&](const T& a, const T& b) { return pick(b < a, zero, one); });
    case Op::smoothstep:
      return ternary([&](const T& a, const T& b, const T& c) {
        const T t = (c - a) / (b - a), low = pick(t < zero, zero, t), held = pick(one < low, one, low);
        return held * held * (F::number(3) - F::number(2) * held);
      });
    case Op::fma:
      return ternary([](const T& a, const T& b, const T& c) { return a * b + c; });
    case Op::select: {
      const auto r = num(s.r), b = num(s.b), c = num(s.c);
      const std::uint32_t* const a = whole(s.a);
      return lanes([&](int l) { r[l] = pick<T>(a[l] != 0, b[l], c[l]); });
    }
    case Op::equal:
      return test([](const T& a, const T& b) { return std::uint32_t(a == b); });
    case Op::not_equal:
      return test([](const T& a, const T& b) { return std::uint32_t(a < b || b < a); });
    case Op::less:
      return test([](const T& a, const T& b) { return std::uint32_t(a < b); });
    case Op::less_equal:
      return test([](const T& a, const T& b) { return std::uint32_t(a < b || a == b); });
    case Op::not_equal_or:
      return test([](const T& a, const T& b) { return std::uint32_t(!(a == b)); });
    case Op::less_or:
      return test([](const T& a, const T& b) { return std::uint32_t(!(b < a || a == b)); });
    case Op::less_equal_or:
      return test([](const T& a, const T& b) { return std::uint32_t(!(b < a)); });
    case Op::is_nan:
      return probe([](const T& a) { return std::uint32_t(is_nan(a)); });
    case Op::is_inf:
      return probe([](const T& a) { return std::uint32_t(std::isinf(F::value(a))); });
    case Op::to_signed:
      return probe([](const T& a) { return to_integer(F::value(a), Op::to_signed); });
    case Op::to_unsigned:
      return probe([](const T& a) { return to_integer(F::value(a), Op::to_unsigned); });
    case Op::bits_of:
      return probe([](const T& a) { return F::bits(a); });
    case Op::from_signed:
      return made([&](std::uint32_t a) { return F::number(double(i32(a))); });
    case Op::from_unsigned:
      return made([](std::uint32_t a) { return F::number(double(a)); });
    case Op::from_bits:
      return made([](std::uint32_t a) { return F::from_bits(a); });
    case Op::texel: {
      const std::vector<float>& texels = bank.table(s.c);
      const auto last = std::uint32_t(texels.size() - 1);
      return made([&](std::uint32_t a) { return F::number(double(texels[std::min(a, last)])); });
    }
    case Op::icopy:
      return integer([](std::uint32_t a, std::uint32_t) { return a; });
    case Op::iadd:
      return integer([](std::uint32_t a, std::uint32_t b) { return a + b; });
    case Op::isub:
      return integer([](std::uint32_t a, std::uint32_t b) { return a - b; });
    case Op::imul:
      return integer([](std::uint32_t a, std::uint32_t b) { return a * b; });
    case Op::sdiv:
      return integer([&](std::uint32_t a, std::uint32_t b) {
        return b == 0 ? 0u : std::uint32_t(std::int64_t(i32(a)) / i32(b));
      });
    case Op::udiv:
      return integer([](std::uint32_t a, std::uint32_t b) { return b == 0 ? 0u : a / b; });
    case Op::smod:
      return integer([&](std::uint32_t a, std::uint32_t b) {
        if (b == 0) return 0u;
        const std::int64_t m = std::int64_t(i32(a)) % i32(b);
        return std::uint32_t(m != 0 && (m < 0) != (i32(b) < 0) ? m + i32(b) : m);
      });
    case Op::srem:
      return integer([&](std::uint32_t a, std::uint32_t b) {
        return b == 0 ? 0u : std::uint32_t(std::int64_t(i32(a)) % i32(b));
      });
    case Op::umod:
      return integer([](std::uint32_t a, std::uint32_t b) { return b == 0 ? 0u : a % b; });
    case Op::ineg:
      return integer([](std::uint32_t a, std::uint32_t) { return 0u - a; });
    case Op::iand:
      return integer([](std::uint32_t a, std::uint32_t b) { return a & b; });
    case Op::ior:
      return integer([](std::uint32_t a, std::uint32_t b) { return a | b; });
    case Op::ixor:
      return integer([](std::uint32_t a, std::uint32_t b) { return a ^ b; });
    case Op::inot:
      return integer([](std::uint32_t a, std::uint32_t) { return ~a; });
    case Op::shl:
      return integer([](std::uint32_t a, std::uint32_t b) { return a << (b & 31); });
    case Op::shr:
      return integer([](std::uint32_t a, std::uint32_t b) { return a >> (b & 31); });
    case Op::sar:
      return integer([&](std::uint32_t a, std::uint32_t b) { return std::uint32_t(i32(a) >> (b & 31)); });
    case Op::ieq:
      return integer([](std::uint32_t a, std::uint32_t b) { return std::uint32_t(a == b); });
    case Op::ine:
      return integer([](std::uint32_t a, std::uint32_t b) { return std::uint32_t(a != b); });
    case Op::slt:
      return integer([&](std::uint32_t a, std::uint32_t b) { return std::uint32_t(i32(a) < i32(b)); });
    case Op::sle:
      return integer([&](std::uint32_t a, std::uint32_t b) { return std::uint32_t(i32(a) <= i32(b)); });
    case Op::ult:
      return integer([](std::uint32_t a, std::uint32_t b) { return std::uint32_t(a < b); });
    case Op::ule:
      return integer([](std::uint32_t a, std::uint32_t b) { return std::uint32_t(a <= b); });
    case Op::imin:
      return integer([&](std::uint32_t a, std::uint32_t b) { return i32(b) < i32(a) ? b : a; });
    case Op::imax:
      return integer([&](std::uint32_t a, std::uint32_t b) { return i32(a) < i32(b) ? b : a; });
    case Op::umin:
    case Op::index:
      return integer([](std::uint32_t a, std::uint32_t b) { return std::min(a, b); });
    case Op::umax:
      return integer([](std::uint32_t a, std::uint32_t b) { return std::max(a, b); });
    case Op::iabs:
      return integer([&](std::uint32_t a, std::uint32_t) { return i32(a) < 0 ? 0u - a : a; });
    case Op::isign:
      return integer(
          [&](std::uint32_t a, std::uint32_t) { return std::uint32_t((i32(a) > 0) - (i32(a) < 0)); });
    case Op::logical_not:
      return integer([](std::uint32_t a, std::uint32_t) { return std::uint32_t(a == 0); });
    case Op::iselect: {
      std::uint32_t* const r = whole(s.r);
      const std::uint32_t *const a = whole(s.a), *const b = whole(s.b), *const c = whole(s.c);
      return lanes([&](int l) { r[l] = a[l] != 0 ? b[l] : c[l]; });
    }
    case Op::load_number: {
      const auto r = num(s.r);
      const std::uint32_t* const at = whole(s.b);
      return lanes([&](int l) { r[l] = num(s.a + std::min(at[l], s.c - 1))[l]; });
    }
    case Op::load_integer: {
      std::uint32_t* const r = whole(s.r);
      const std::uint32_t* const at = whole(s.b);
      return lanes([&](int l) { r[l] = whole(s.a + std::min(at[l], s.c - 1))[l]; });
    }
    case Op::store_number: {
      const auto a = num(s.a);
      const std::uint32_t* const at = whole(s.b);
      return lanes([&](int l) { num(s.r + std::min(at[l], s.c - 1))[l] = a[l]; });
    }
    case Op::store_integer: {
      const std::uint32_t *const a = whole(s.a), *const at = whole(s.b);
      return lanes([&](int l) { whole(s.r + std::min(at[l], s.c - 1))[l] = a[l]; });
    }
    case Op::count:
      return;
  }
}

}  // namespace detail

}  // namespace brdf::shader
