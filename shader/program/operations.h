// The table of all operations: their operands and result, and the comparison that they make. Their texts in
// other languages are in shader/operation_texts.h. The interpreter (shader/run) and the enclosures
// (prove/shader) have a case for each operation and no default, so that a new operation does not compile
// there until it is handled.
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
    {Op::copy, "x", 'x'},
    {Op::add, "xx", 'x'},
    {Op::sub, "xx", 'x'},
    {Op::mul, "xx", 'x'},
    {Op::div, "xx", 'x'},
    {Op::neg, "x", 'x'},
    {Op::mod, "xx", 'x'},
    {Op::rem, "xx", 'x'},
    {Op::abs, "x", 'x'},
    {Op::sign, "x", 'x'},
    {Op::floor, "x", 'x'},
    {Op::ceil, "x", 'x'},
    {Op::trunc, "x", 'x'},
    {Op::round, "x", 'x'},
    {Op::round_even, "x", 'x'},
    {Op::fract, "x", 'x'},
    {Op::sqrt, "x", 'x'},
    {Op::inverse_sqrt, "x", 'x'},
    {Op::exp, "x", 'x'},
    {Op::exp2, "x", 'x'},
    {Op::log, "x", 'x'},
    {Op::log2, "x", 'x'},
    {Op::pow, "xx", 'x'},
    {Op::sin, "x", 'x'},
    {Op::cos, "x", 'x'},
    {Op::tan, "x", 'x'},
    {Op::asin, "x", 'x'},
    {Op::acos, "x", 'x'},
    {Op::atan, "x", 'x'},
    {Op::atan2, "xx", 'x'},
    {Op::sinh, "x", 'x'},
    {Op::cosh, "x", 'x'},
    {Op::tanh, "x", 'x'},
    {Op::min, "xx", 'x'},
    {Op::max, "xx", 'x'},
    {Op::clamp, "xxx", 'x'},
    {Op::mix, "xxx", 'x'},
    {Op::step, "xx", 'x'},
    {Op::smoothstep, "xxx", 'x'},
    {Op::fma, "xxx", 'x'},
    {Op::log1p, "xx", 'x'},
    {Op::erfcx, "x", 'x'},
    {Op::angle, "xx", 'x'},
    {Op::to_half, "x", 'x'},
    {Op::select, "ixx", 'x'},
    {Op::equal, "xx", 'i', Access::one, Compares::equal},
    {Op::not_equal, "xx", 'i', Access::one, Compares::not_equal},
    {Op::less, "xx", 'i', Access::one, Compares::less},
    {Op::less_equal, "xx", 'i', Access::one, Compares::less_equal},
    {Op::not_equal_or, "xx", 'i', Access::one, Compares::not_equal},
    {Op::less_or, "xx", 'i', Access::one, Compares::less},
    {Op::less_equal_or, "xx", 'i', Access::one, Compares::less_equal},
    {Op::is_nan, "x", 'i'},
    {Op::is_inf, "x", 'i'},
    {Op::to_signed, "x", 'i'},
    {Op::to_unsigned, "x", 'i'},
    {Op::bits_of, "x", 'i'},
    {Op::from_signed, "i", 'x'},
    {Op::from_unsigned, "i", 'x'},
    {Op::from_bits, "i", 'x'},
    {Op::texel, "i", 'x'},
    {Op::icopy, "i", 'i'},
    {Op::iadd, "ii", 'i'},
    {Op::isub, "ii", 'i'},
    {Op::imul, "ii", 'i'},
    {Op::sdiv, "ii", 'i'},
    {Op::udiv, "ii", 'i'},
    {Op::smod, "ii", 'i'},
    {Op::srem, "ii", 'i'},
    {Op::umod, "ii", 'i'},
    {Op::ineg, "i", 'i'},
    {Op::iand, "ii", 'i'},
    {Op::ior, "ii", 'i'},
    {Op::ixor, "ii", 'i'},
    {Op::inot, "i", 'i'},
    {Op::shl, "ii", 'i'},
    {Op::shr, "ii", 'i'},
    {Op::sar, "ii", 'i'},
    {Op::ieq, "ii", 'i'},
    {Op::ine, "ii", 'i'},
    {Op::slt, "ii", 'i'},
    {Op::sle, "ii", 'i'},
    {Op::ult, "ii", 'i'},
    {Op::ule, "ii", 'i'},
    {Op::imin, "ii", 'i'},
    {Op::imax, "ii", 'i'},
    {Op::umin, "ii", 'i'},
    {Op::umax, "ii", 'i'},
    {Op::index, "ii", 'i'},
    {Op::iabs, "i", 'i'},
    {Op::isign, "i", 'i'},
    {Op::iselect, "iii", 'i'},
    {Op::logical_not, "i", 'i'},
    {Op::load_number, "xi", 'x', Access::load},
    {Op::load_integer, "ii", 'i', Access::load},
    {Op::store_number, "xi", 'x', Access::store},
    {Op::store_integer, "ii", 'i', Access::store},
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
