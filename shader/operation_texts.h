// The table of the right sides of all operations in all languages of exported texts. It has no default: an
// operation without a text in some language does not compile.
#pragma once

#include <cstddef>
#include <iterator>

#include "io/material/shader_language.h"
#include "shader/program/program.h"

namespace brdf::shader {

// A, B, C represent the operands as stored in the bank; a, b, c represent integers read as signed. An empty
// text: the operation is not a single expression. In C++, operations that its standard leaves undefined have
// the interpreter's values.
class OperationTexts {
 public:
  constexpr OperationTexts(Op of, const char* everywhere)
      : OperationTexts(of, everywhere, everywhere, everywhere) {}
  // The dialects of GLSL agree.
  constexpr OperationTexts(Op of, const char* glsl, const char* hlsl, const char* cpp)
      : op(of), glsl_(glsl), hlsl_(hlsl), cpp_(cpp) {}

  Op op;
  constexpr const char* in(io::ShaderLanguage language) const {
    switch (language) {
      case io::ShaderLanguage::glsl:
      case io::ShaderLanguage::glsl_es:
      case io::ShaderLanguage::explorer:
        return glsl_;
      case io::ShaderLanguage::hlsl:
        return hlsl_;
      case io::ShaderLanguage::cpp:
        return cpp_;
    }
    return nullptr;
  }

 private:
  const char *glsl_, *hlsl_, *cpp_;
};

namespace detail {

// Rounds as the interpreter does, where packHalf2x16 would leave the rounding to the device: multiples of
// 2^-24 below the least normal number of half precision, 10 bits of the significand above.
#define BRDF_HALF(ABS, ROUND)                                                                \
  "uintBitsToFloat((floatBitsToUint(A) & 2147483648u) | floatBitsToUint(" ABS                \
  "(A) < 6.103515625e-5 ? " ROUND "(" ABS "(A) * 16777216.0) * 5.9604644775390625e-8 : " ABS \
  "(A) < 65520.0 ? "                                                                         \
  "uintBitsToFloat(((floatBitsToUint(" ABS                                                   \
  "(A)) + ((floatBitsToUint(A) >> 13u) & 1u) + 4095u) >> 13u) "                              \
  "<< 13u) : A != A ? " ABS "(A) : uintBitsToFloat(2139095040u)))"

// clang-format off
inline constexpr OperationTexts kOperationTexts[] = {
    {Op::copy, "A"},
    {Op::add, "A + B"},
    {Op::sub, "A - B"},
    {Op::mul, "A * B"},
    {Op::div, "A / B"},
    {Op::neg, "-A"},
    {Op::mod, "A - B * floor(A / B)", "A - B * floor(A / B)", "A - B * std::floor(A / B)"},
    {Op::rem, "A - B * trunc(A / B)", "A - B * trunc(A / B)", "A - B * std::trunc(A / B)"},
    {Op::abs, "abs(A)", "abs(A)", "std::fabs(A)"},
    {Op::sign, "sign(A)", "float(sign(A))", "A > 0.0 ? 1.0 : (A < 0.0 ? -1.0 : 0.0)"},
    {Op::floor, "floor(A)", "floor(A)", "std::floor(A)"},
    {Op::ceil, "ceil(A)", "ceil(A)", "std::ceil(A)"},
    {Op::trunc, "trunc(A)", "trunc(A)", "std::trunc(A)"},
    {Op::round, "roundEven(A)", "round(A)", "std::nearbyint(A)"},
    {Op::round_even, "roundEven(A)", "round(A)", "std::nearbyint(A)"},
    {Op::fract, "A - floor(A)", "A - floor(A)", "A - std::floor(A)"},
    {Op::sqrt, "sqrt(A)", "sqrt(A)", "std::sqrt(A)"},
    {Op::inverse_sqrt, "1.0 / sqrt(A)", "1.0 / sqrt(A)", "1.0 / std::sqrt(A)"},
    {Op::exp, "exp(A)", "exp(A)", "std::exp(A)"},
    {Op::exp2, "exp2(A)", "exp2(A)", "std::exp2(A)"},
    {Op::log, "log(A)", "log(A)", "std::log(A)"},
    {Op::log2, "log2(A)", "log2(A)", "std::log2(A)"},
    {Op::pow, "pow(A, B)", "pow(A, B)", "A < 0.0 ? uintBitsToFloat(2143289344u) : std::pow(A, B)"},
    {Op::sin, "sin(A)", "sin(A)", "std::sin(A)"},
    {Op::cos, "cos(A)", "cos(A)", "std::cos(A)"},
    {Op::tan, "tan(A)", "tan(A)", "std::tan(A)"},
    {Op::asin, "asin(A)", "asin(A)", "std::asin(A)"},
    {Op::acos, "acos(A)", "acos(A)", "std::acos(A)"},
    {Op::atan, "atan(A)", "atan(A)", "std::atan(A)"},
    {Op::atan2, "atan(A, B)", "atan2(A, B)", "std::atan2(A, B)"},
    {Op::sinh, "sinh(A)", "sinh(A)", "std::sinh(A)"},
    {Op::cosh, "cosh(A)", "cosh(A)", "std::cosh(A)"},
    {Op::tanh, "tanh(A)", "tanh(A)", "std::tanh(A)"},
    {Op::min, "B < A ? B : A"},
    {Op::max, "A < B ? B : A"},
    {Op::clamp, "C < (A < B ? B : A) ? C : (A < B ? B : A)"},
    {Op::mix, "A * (1.0 - C) + B * C"},
    {Op::step, "B < A ? 0.0 : 1.0"},
    {Op::smoothstep, "smoothstep(A, B, C)", "smoothstep(A, B, C)",
     "[](float t) { t = t < 0.0 ? 0.0 : t; t = 1.0 < t ? 1.0 : t; return t * t * (3.0 - 2.0 * t); }"
     "((C - A) / (B - A))"},
    {Op::fma, "A * B + C"},
    {Op::log1p, "brdf_log1p(A, B)"},
    {Op::erfcx, "brdf_erfcx(A)"},
    {Op::angle, "brdf_angle(A, B)"},
    {Op::to_half, BRDF_HALF("abs", "roundEven"), BRDF_HALF("abs", "round"),
     BRDF_HALF("std::fabs", "std::nearbyint")},
    {Op::select, "A != 0u ? B : C"},
    {Op::equal, "A == B ? 1u : 0u"},
    {Op::not_equal, "A < B || B < A ? 1u : 0u"},
    {Op::less, "A < B ? 1u : 0u"},
    {Op::less_equal, "A <= B ? 1u : 0u"},
    {Op::not_equal_or, "A != B ? 1u : 0u"},
    {Op::less_or, "!(A >= B) ? 1u : 0u"},
    {Op::less_equal_or, "!(A > B) ? 1u : 0u"},
    {Op::is_nan, "isnan(A) ? 1u : 0u", "isnan(A) ? 1u : 0u", "std::isnan(A) ? 1u : 0u"},
    {Op::is_inf, "isinf(A) ? 1u : 0u", "isinf(A) ? 1u : 0u", "std::isinf(A) ? 1u : 0u"},
    {Op::to_signed, "uint(int(A))", "uint(int(A))",
     "A != A ? 0u : A <= -2147483648.0 ? 2147483648u : A >= 2147483648.0 ? 2147483647u : uint(int(A))"},
    {Op::to_unsigned, "uint(A)", "uint(A)",
     "A > 0.0 ? (A >= 4294967296.0 ? 4294967295u : uint(A)) : 0u"},
    {Op::bits_of, "floatBitsToUint(A)", "asuint(A)", "floatBitsToUint(A)"},
    {Op::from_signed, "float(a)"},
    {Op::from_unsigned, "float(A)"},
    {Op::from_bits, "uintBitsToFloat(A)", "asfloat(A)", "uintBitsToFloat(A)"},
    {Op::texel, ""},
    {Op::icopy, "A"},
    {Op::iadd, "A + B"},
    {Op::isub, "A - B"},
    {Op::imul, "A * B"},
    {Op::sdiv, "B == 0u ? 0u : B == 4294967295u ? 0u - A : uint(a / b)"},
    {Op::udiv, "B == 0u ? 0u : A / B"},
    {Op::smod, "B == 0u || B == 4294967295u ? 0u : "
               "uint(a - b * (a / b) + (a != b * (a / b) && (a < 0) != (b < 0) ? b : 0))"},
    {Op::srem, "B == 0u || B == 4294967295u ? 0u : uint(a - b * (a / b))"},
    {Op::umod, "B == 0u ? 0u : A % B"},
    {Op::ineg, "0u - A"},
    {Op::iand, "A & B"},
    {Op::ior, "A | B"},
    {Op::ixor, "A ^ B"},
    {Op::inot, "~A"},
    {Op::shl, "A << (B & 31u)"},
    {Op::shr, "A >> (B & 31u)"},
    {Op::sar, "uint(a >> int(B & 31u))"},
    {Op::ieq, "A == B ? 1u : 0u"},
    {Op::ine, "A != B ? 1u : 0u"},
    {Op::slt, "a < b ? 1u : 0u"},
    {Op::sle, "a <= b ? 1u : 0u"},
    {Op::ult, "A < B ? 1u : 0u"},
    {Op::ule, "A <= B ? 1u : 0u"},
    {Op::imin, "b < a ? B : A"},
    {Op::imax, "a < b ? B : A"},
    {Op::umin, "B < A ? B : A"},
    {Op::umax, "A < B ? B : A"},
    {Op::index, "B < A ? B : A"},
    {Op::iabs, "a < 0 ? 0u - A : A"},
    {Op::isign, "A == 0u ? 0u : a < 0 ? 4294967295u : 1u"},
    {Op::iselect, "A != 0u ? B : C"},
    {Op::logical_not, "A == 0u ? 1u : 0u"},
    {Op::load_number, ""},
    {Op::load_integer, ""},
    {Op::store_number, ""},
    {Op::store_integer, ""},
};
// clang-format on
#undef BRDF_HALF
static_assert(
    [] {
      for (std::size_t k = 0; k < std::size(kOperationTexts); ++k)
        if (std::size_t(kOperationTexts[k].op) != k) return false;
      return std::size(kOperationTexts) == std::size_t(Op::count);
    }(),
    "a row for each Op, in the order of the enum");
}  // namespace detail

constexpr const char* text_of(Op op, io::ShaderLanguage language) {
  return detail::kOperationTexts[std::size_t(op)].in(language);
}

}  // namespace brdf::shader
