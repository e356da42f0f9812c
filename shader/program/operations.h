// The one table of operations: what each reads and writes, how GLSL writes it, and what it compares. The
// interpreter (shader/run) and the enclosures (prove/shader) have a case for each, without a default, so that
// a new one fails to compile there.
#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

#include "shader/program/program.h"

namespace brdf::shader {

struct Operation {
  // load: slots a to a + c - 1 are read; store: r to r + c - 1 are written.
  enum class Access { one, load, store };
  enum class Compares { no, equal, not_equal, less, less_equal };

  Op op;
  std::string_view operands;  // a, b and c: n, a number, or i, an integer
  char result;                // the same
  // The right side in GLSL: A, B, C stand for the operands as they are in the bank, a, b, c for integers read
  // as signed. Empty: it has none of one expression.
  const char* glsl;
  Access access = Access::one;
  Compares compares = Compares::no;  // two numbers

  constexpr int count() const { return int(operands.size()); }
  constexpr bool reads_integer(int k) const { return operands[std::size_t(k)] == 'i'; }
  constexpr bool writes_integer() const { return result == 'i'; }
  constexpr bool loads() const { return access == Access::load; }
  constexpr bool stores() const { return access == Access::store; }
  // Numbers to a number.
  constexpr bool of_numbers() const { return result == 'n' && operands.find('i') == operands.npos; }
  constexpr std::uint32_t slots_written(const Step& step) const { return stores() ? step.c : 1; }
};

namespace detail {
using Access = Operation::Access;
using Compares = Operation::Compares;
// clang-format off
inline constexpr Operation kOperations[] = {
    {Op::copy, "n", 'n', "A"},
    {Op::add, "nn", 'n', "A + B"},
    {Op::sub, "nn", 'n', "A - B"},
    {Op::mul, "nn", 'n', "A * B"},
    {Op::div, "nn", 'n', "A / B"},
    {Op::neg, "n", 'n', "-A"},
    {Op::mod, "nn", 'n', "A - B * floor(A / B)"},
    {Op::rem, "nn", 'n', "A - B * trunc(A / B)"},
    {Op::abs, "n", 'n', "abs(A)"},
    {Op::sign, "n", 'n', "sign(A)"},
    {Op::floor, "n", 'n', "floor(A)"},
    {Op::ceil, "n", 'n', "ceil(A)"},
    {Op::trunc, "n", 'n', "trunc(A)"},
    {Op::round, "n", 'n', "roundEven(A)"},
    {Op::round_even, "n", 'n', "roundEven(A)"},
    {Op::fract, "n", 'n', "A - floor(A)"},
    {Op::sqrt, "n", 'n', "sqrt(A)"},
    {Op::inverse_sqrt, "n", 'n', "1.0 / sqrt(A)"},
    {Op::exp, "n", 'n', "exp(A)"},
    {Op::exp2, "n", 'n', "exp2(A)"},
    {Op::log, "n", 'n', "log(A)"},
    {Op::log2, "n", 'n', "log2(A)"},
    {Op::pow, "nn", 'n', "pow(A, B)"},
    {Op::sin, "n", 'n', "sin(A)"},
    {Op::cos, "n", 'n', "cos(A)"},
    {Op::tan, "n", 'n', "tan(A)"},
    {Op::asin, "n", 'n', "asin(A)"},
    {Op::acos, "n", 'n', "acos(A)"},
    {Op::atan, "n", 'n', "atan(A)"},
    {Op::atan2, "nn", 'n', "atan(A, B)"},
    {Op::sinh, "n", 'n', "sinh(A)"},
    {Op::cosh, "n", 'n', "cosh(A)"},
    {Op::tanh, "n", 'n', "tanh(A)"},
    {Op::min, "nn", 'n', "B < A ? B : A"},
    {Op::max, "nn", 'n', "A < B ? B : A"},
    {Op::clamp, "nnn", 'n', "C < (A < B ? B : A) ? C : (A < B ? B : A)"},
    {Op::mix, "nnn", 'n', "A * (1.0 - C) + B * C"},
    {Op::step, "nn", 'n', "B < A ? 0.0 : 1.0"},
    {Op::smoothstep, "nnn", 'n', "smoothstep(A, B, C)"},
    {Op::fma, "nnn", 'n', "A * B + C"},
    {Op::log1p, "nn", 'n', "log(1.0 + A) + B"},
    {Op::erfcx, "n", 'n', ""},
    {Op::angle, "nn", 'n', "atan(A, B)"},
    {Op::select, "inn", 'n', "A != 0u ? B : C"},
    {Op::equal, "nn", 'i', "A == B ? 1u : 0u", Access::one, Compares::equal},
    {Op::not_equal, "nn", 'i', "A < B || B < A ? 1u : 0u", Access::one, Compares::not_equal},
    {Op::less, "nn", 'i', "A < B ? 1u : 0u", Access::one, Compares::less},
    {Op::less_equal, "nn", 'i', "A <= B ? 1u : 0u", Access::one, Compares::less_equal},
    {Op::not_equal_or, "nn", 'i', "A != B ? 1u : 0u", Access::one, Compares::not_equal},
    {Op::less_or, "nn", 'i', "!(A >= B) ? 1u : 0u", Access::one, Compares::less},
    {Op::less_equal_or, "nn", 'i', "!(A > B) ? 1u : 0u", Access::one, Compares::less_equal},
    {Op::is_nan, "n", 'i', "isnan(A) ? 1u : 0u"},
    {Op::is_inf, "n", 'i', "isinf(A) ? 1u : 0u"},
    {Op::to_signed, "n", 'i', "uint(int(A))"},
    {Op::to_unsigned, "n", 'i', "uint(A)"},
    {Op::bits_of, "n", 'i', "floatBitsToUint(A)"},
    {Op::from_signed, "i", 'n', "float(a)"},
    {Op::from_unsigned, "i", 'n', "float(A)"},
    {Op::from_bits, "i", 'n', "uintBitsToFloat(A)"},
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
    {Op::load_number, "ni", 'n', "", Access::load},
    {Op::load_integer, "ii", 'i', "", Access::load},
    {Op::store_number, "ni", 'n', "", Access::store},
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

}  // namespace brdf::shader
