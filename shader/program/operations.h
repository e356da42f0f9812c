// The table of all operations: their operands and result, their form in GLSL, and the comparison that they
// make. The interpreter (shader/run) and the enclosures (prove/shader) have a case for each operation and
// no default, so that a new operation does not compile there until it is handled.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

#include "shader/program/program.h"

namespace brdf::shader {

struct Operation {
  // load: slots a to a + c - 1 are read. store: slots r to r + c - 1 are written.
  enum class Access { one, load, store };
  enum class Compares { no, equal, not_equal, less, less_equal };

  Op op;
  std::string_view operands;  // kinds of a, b and c: x is a number, i an integer
  char result;                // kind of the result, x or i
  // The right side in GLSL. A, B, C represent the operands as stored in the bank; a, b, c represent
  // integers read as signed. Empty if the operation is not a single expression.
  const char* glsl;
  Access access = Access::one;
  Compares compares = Compares::no;  // of two numbers

  constexpr int count() const { return int(operands.size()); }
  constexpr bool reads_integer(int k) const { return operands[std::size_t(k)] == 'i'; }
  constexpr bool writes_integer() const { return result == 'i'; }
  constexpr bool loads() const { return access == Access::load; }
  constexpr bool stores() const { return access == Access::store; }
  // Returns whether the operation takes only numbers and gives a number.
  constexpr bool of_numbers() const { return result == 'x' && operands.find('i') == operands.npos; }
  constexpr std::uint32_t slots_written(const Step& step) const { return stores() ? step.c : 1; }
};

namespace detail {
using Access = Operation::Access;
using Compares = Operation::Compares;
// clang-format off
inline constexpr Operation kOperations[] = {
    {Op::copy, "x", 'x', "A"},
    {Op::add, "xx", 'x', "A + B"},
    {Op::sub, "xx", 'x', "A - B"},
    {Op::mul, "xx", 'x', "A * B"},
    {Op::div, "xx", 'x', "A / B"},
    {Op::neg, "x", 'x', "-A"},
    {Op::mod, "xx", 'x', "A - B * floor(A / B)"},
    {Op::rem, "xx", 'x', "A - B * trunc(A / B)"},
    {Op::abs, "x", 'x', "abs(A)"},
    {Op::sign, "x", 'x', "sign(A)"},
    {Op::floor, "x", 'x', "floor(A)"},
    {Op::ceil, "x", 'x', "ceil(A)"},
    {Op::trunc, "x", 'x', "trunc(A)"},
    {Op::round, "x", 'x', "roundEven(A)"},
    {Op::round_even, "x", 'x', "roundEven(A)"},
    {Op::fract, "x", 'x', "A - floor(A)"},
    {Op::sqrt, "x", 'x', "sqrt(A)"},
    {Op::inverse_sqrt, "x", 'x', "1.0 / sqrt(A)"},
    {Op::exp, "x", 'x', "exp(A)"},
    {Op::exp2, "x", 'x', "exp2(A)"},
    {Op::log, "x", 'x', "log(A)"},
    {Op::log2, "x", 'x', "log2(A)"},
    {Op::pow, "xx", 'x', "pow(A, B)"},
    {Op::sin, "x", 'x', "sin(A)"},
    {Op::cos, "x", 'x', "cos(A)"},
    {Op::tan, "x", 'x', "tan(A)"},
    {Op::asin, "x", 'x', "asin(A)"},
    {Op::acos, "x", 'x', "acos(A)"},
    {Op::atan, "x", 'x', "atan(A)"},
    {Op::atan2, "xx", 'x', "atan(A, B)"},
    {Op::sinh, "x", 'x', "sinh(A)"},
    {Op::cosh, "x", 'x', "cosh(A)"},
    {Op::tanh, "x", 'x', "tanh(A)"},
    {Op::min, "xx", 'x', "B < A ? B : A"},
    {Op::max, "xx", 'x', "A < B ? B : A"},
    {Op::clamp, "xxx", 'x', "C < (A < B ? B : A) ? C : (A < B ? B : A)"},
    {Op::mix, "xxx", 'x', "A * (1.0 - C) + B * C"},
    {Op::step, "xx", 'x', "B < A ? 0.0 : 1.0"},
    {Op::smoothstep, "xxx", 'x', "smoothstep(A, B, C)"},
    {Op::fma, "xxx", 'x', "A * B + C"},
    {Op::log1p, "xx", 'x', "log(1.0 + A) + B"},
    {Op::erfcx, "x", 'x', ""},
    {Op::angle, "xx", 'x', "atan(A, B)"},
    {Op::to_half, "x", 'x', "unpackHalf2x16(packHalf2x16(vec2(A, 0.0))).x"},
    {Op::select, "ixx", 'x', "A != 0u ? B : C"},
    {Op::equal, "xx", 'i', "A == B ? 1u : 0u", Access::one, Compares::equal},
    {Op::not_equal, "xx", 'i', "A < B || B < A ? 1u : 0u", Access::one, Compares::not_equal},
    {Op::less, "xx", 'i', "A < B ? 1u : 0u", Access::one, Compares::less},
    {Op::less_equal, "xx", 'i', "A <= B ? 1u : 0u", Access::one, Compares::less_equal},
    {Op::not_equal_or, "xx", 'i', "A != B ? 1u : 0u", Access::one, Compares::not_equal},
    {Op::less_or, "xx", 'i', "!(A >= B) ? 1u : 0u", Access::one, Compares::less},
    {Op::less_equal_or, "xx", 'i', "!(A > B) ? 1u : 0u", Access::one, Compares::less_equal},
    {Op::is_nan, "x", 'i', "isnan(A) ? 1u : 0u"},
    {Op::is_inf, "x", 'i', "isinf(A) ? 1u : 0u"},
    {Op::to_signed, "x", 'i', "uint(int(A))"},
    {Op::to_unsigned, "x", 'i', "uint(A)"},
    {Op::bits_of, "x", 'i', "floatBitsToUint(A)"},
    {Op::from_signed, "i", 'x', "float(a)"},
    {Op::from_unsigned, "i", 'x', "float(A)"},
    {Op::from_bits, "i", 'x', "uintBitsToFloat(A)"},
    {Op::texel, "i", 'x', ""},
    {Op::icopy, "i", 'i', "A"},
    {Op::iadd, "ii", 'i', "A + B"},
    {Op::isub, "ii", 'i', "A - B"},
    {Op::imul, "ii", 'i', "A * B"},
    {Op::sdiv, "ii", 'i', "B == 0u ? 0u : uint(a / b)"},
    {Op::udiv, "ii", 'i', "B == 0u ? 0u : A / B"},
    {Op::smod, "ii", 'i', "B == 0u ? 0u : uint(a - b * int(floor(float(a) / float(b))))"},
    {Op::srem, "ii", 'i', "B == 0u ? 0u : uint(a - b * (a / b))"},
    {Op::umod, "ii", 'i', "B == 0u ? 0u : A % B"},
    {Op::ineg, "i", 'i', "0u - A"},
    {Op::iand, "ii", 'i', "A & B"},
    {Op::ior, "ii", 'i', "A | B"},
    {Op::ixor, "ii", 'i', "A ^ B"},
    {Op::inot, "i", 'i', "~A"},
    {Op::shl, "ii", 'i', "A << (B & 31u)"},
    {Op::shr, "ii", 'i', "A >> (B & 31u)"},
    {Op::sar, "ii", 'i', "uint(a >> int(B & 31u))"},
    {Op::ieq, "ii", 'i', "A == B ? 1u : 0u"},
    {Op::ine, "ii", 'i', "A != B ? 1u : 0u"},
    {Op::slt, "ii", 'i', "a < b ? 1u : 0u"},
    {Op::sle, "ii", 'i', "a <= b ? 1u : 0u"},
    {Op::ult, "ii", 'i', "A < B ? 1u : 0u"},
    {Op::ule, "ii", 'i', "A <= B ? 1u : 0u"},
    {Op::imin, "ii", 'i', "uint(min(a, b))"},
    {Op::imax, "ii", 'i', "uint(max(a, b))"},
    {Op::umin, "ii", 'i', "min(A, B)"},
    {Op::umax, "ii", 'i', "max(A, B)"},
    {Op::index, "ii", 'i', "min(A, B)"},
    {Op::iabs, "i", 'i', "uint(abs(a))"},
    {Op::isign, "i", 'i', "uint(sign(a))"},
    {Op::iselect, "iii", 'i', "A != 0u ? B : C"},
    {Op::logical_not, "i", 'i', "A == 0u ? 1u : 0u"},
    {Op::load_number, "xi", 'x', "", Access::load},
    {Op::load_integer, "ii", 'i', "", Access::load},
    {Op::store_number, "xi", 'x', "", Access::store},
    {Op::store_integer, "ii", 'i', "", Access::store},
};
// clang-format on
static_assert(
    [] {
      for (std::size_t k = 0; k < std::size(kOperations); ++k)
        if (std::size_t(kOperations[k].op) != k) return false;
      return std::size(kOperations) == std::size_t(Op::count);
    }(),
    "a row for each Op, in the order of the enum");
}  // namespace detail

constexpr const Operation& operation(Op op) {
  return detail::kOperations[std::size_t(op)];
}

// Calls look(integer, slot) for each slot that the step may read.
template <class Look>
void for_each_read(const Step& step, Look&& look) {
  const Operation& o = operation(step.op);
  const std::uint32_t slots[] = {step.a, step.b, step.c};
  for (int k = 0; k < o.count(); ++k) {
    const std::uint32_t width = k == 0 && o.loads() ? step.c : 1;
    for (std::uint32_t at = 0; at < width; ++at) look(o.reads_integer(k), slots[k] + at);
  }
}

}  // namespace brdf::shader
