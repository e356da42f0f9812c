// Detects, while a program runs, values that the shading languages leave undefined.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "shader/function.h"

namespace brdf::shader {

// The reason why a value is undefined according to the GLSL specification (4.60, sections 5.9, 8.1 to 8.3)
// or SPIR-V.
enum class Undefined : std::uint8_t {
  variable,    // a variable is read before it is written
  no_return,   // a path ends without a return
  index,       // outside the array
  division,    // of integers by 0, or of the least integer by -1
  remainder,   // of integers below 0: in GLSL of any, in HLSL of two with different signs
  shift,       // by 32 bits or more
  conversion,  // of a number outside the range of the integer type
  pow,         // of a base below 0, or of 0 to an exponent that is not above 0
  atan,        // of two zeros
  root,        // sqrt of a number below 0, inversesqrt of one that is not above 0
  logarithm,   // of a number that is not above 0
  arc,         // asin or acos of a number outside -1 to 1
  smoothstep,  // the lower edge is not below the upper one
  clamp,       // the lower limit is above the upper one
  min_max,     // one operand is NaN
};

struct UndefinedValue {
  Undefined why;
  std::uint32_t line = 0;            // of the source, starting at 1; 0: unknown
  std::array<double, 2> operands{};  // as the step read them
};

// Whether a comparison holds; of ranges of numbers, whether it may hold (prove/shader/box_steps.cpp).
inline bool may_be_below(double x, double y) {
  return x < y;
}
inline bool may_be_at_most(double x, double y) {
  return x <= y;
}
inline bool may_be_nan(double x) {
  return x != x;
}

// Returns the reason if this step on numbers gives an undefined value, or may give one for operands of
// these ranges. This is the only list of such functions, for runs and for proofs. `number(slot)` returns an
// operand.
template <class Number>
std::optional<Undefined> undefined_of_numbers(const Step& s, Number&& number) {
  const auto if_so = [](bool is, Undefined why) { return is ? std::optional(why) : std::nullopt; };
  const auto not_above_0 = [&](std::uint32_t slot) { return may_be_at_most(number(slot), 0.0); };
  const auto is_0 = [&](std::uint32_t slot) {
    return not_above_0(slot) && may_be_at_most(0.0, number(slot));
  };
  const auto is_nan = [&](std::uint32_t slot) { return may_be_nan(number(slot)); };
  switch (s.op) {
    case Op::pow:
      return if_so(may_be_below(number(s.a), 0.0) || (is_0(s.a) && (not_above_0(s.b) || is_nan(s.b))),
                   Undefined::pow);
    case Op::atan2:
      return if_so(is_0(s.a) && is_0(s.b), Undefined::atan);
    case Op::sqrt:
      return if_so(may_be_below(number(s.a), 0.0), Undefined::root);
    case Op::inverse_sqrt:
      return if_so(not_above_0(s.a), Undefined::root);
    case Op::log:
    case Op::log2:
      return if_so(not_above_0(s.a), Undefined::logarithm);
    case Op::asin:
    case Op::acos:
      return if_so(may_be_below(number(s.a), -1.0) || may_be_below(1.0, number(s.a)), Undefined::arc);
    case Op::smoothstep:
      return if_so(may_be_at_most(number(s.b), number(s.a)) || is_nan(s.a) || is_nan(s.b),
                   Undefined::smoothstep);
    case Op::min:
      if (s.c > 0 && may_be_below(number(s.b), number(s.c - 1))) return Undefined::clamp;
      [[fallthrough]];
    case Op::max:
      return if_so(is_nan(s.a) || is_nan(s.b), Undefined::min_max);
    case Op::to_signed:
      return if_so(may_be_at_most(number(s.a), -2147483649.0) || may_be_at_most(2147483648.0, number(s.a)) ||
                       is_nan(s.a),
                   Undefined::conversion);
    case Op::to_unsigned:
      return if_so(
          may_be_at_most(number(s.a), -1.0) || may_be_at_most(4294967296.0, number(s.a)) || is_nan(s.a),
          Undefined::conversion);
    default:
      return std::nullopt;
  }
}

// Returns the reason if this step gives an undefined value for its operands. `number(slot)` and
// `integer(slot)` return the operands.
template <class Number, class Integer>
std::optional<Undefined> undefined_step(const Step& s, Number&& number, Integer&& integer) {
  const auto if_so = [](bool is, Undefined why) { return is ? std::optional(why) : std::nullopt; };
  switch (s.op) {
    case Op::imin:
      return if_so(s.c > 0 && std::int32_t(integer(s.c - 1)) > std::int32_t(integer(s.b)), Undefined::clamp);
    case Op::umin:
      return if_so(s.c > 0 && integer(s.c - 1) > integer(s.b), Undefined::clamp);
    case Op::smod:  // of GLSL
      if (std::int32_t(integer(s.a)) < 0 || std::int32_t(integer(s.b)) < 0) return Undefined::remainder;
      return if_so(integer(s.b) == 0, Undefined::division);
    case Op::srem:  // of HLSL
      if ((integer(s.a) ^ integer(s.b)) >> 31 && integer(s.a) != 0) return Undefined::remainder;
      [[fallthrough]];
    case Op::sdiv:
      return if_so(integer(s.b) == 0 || (integer(s.a) == 0x80000000u && integer(s.b) == 0xffffffffu),
                   Undefined::division);
    case Op::udiv:
    case Op::umod:
      return if_so(integer(s.b) == 0, Undefined::division);
    case Op::shl:
    case Op::shr:
    case Op::sar:
      return if_so(integer(s.b) >= 32, Undefined::shift);
    case Op::index:
      return if_so(integer(s.a) > integer(s.b), Undefined::index);
    default:
      return undefined_of_numbers(s, number);
  }
}

// Returns the undefined value on which the result depends, in the program that the scalar T runs;
// std::nullopt if the result is defined. An undefined value on which no result depends does not count.
// `values` are the values of all parameters in order; the directions are unit vectors. Throws EndlessLoop.
template <class T>
std::optional<UndefinedValue> undefined_value(const Function& function, std::span<const double> values,
                                              const Vec3<double>& wi, const Vec3<double>& wo);
extern template std::optional<UndefinedValue> undefined_value<float>(const Function&, std::span<const double>,
                                                                     const Vec3<double>&,
                                                                     const Vec3<double>&);
extern template std::optional<UndefinedValue> undefined_value<double>(const Function&,
                                                                      std::span<const double>,
                                                                      const Vec3<double>&,
                                                                      const Vec3<double>&);

// Returns "line 7, `x = pow(a, 2.0);`: pow of a base below 0 ... (-0.3, 2)".
std::string to_text(const Function& function, const UndefinedValue& value);
// Returns the description of the reason, without the line and the operands.
std::string_view sentence_of(Undefined why);

}  // namespace brdf::shader
