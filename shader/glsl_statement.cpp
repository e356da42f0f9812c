#include "shader/glsl_statement.h"

#include <bit>
#include <cctype>
#include <cmath>

#include "io/material/glsl.h"
#include "shader/program/operands.h"

namespace brdf::shader {

std::string number_slot(std::uint32_t slot) {
  return "n" + std::to_string(slot);
}
std::string integer_slot(std::uint32_t slot) {
  return "i" + std::to_string(slot);
}

std::string number_text(double value) {
  if (const float x = float(value); !std::isfinite(x))
    return "uintBitsToFloat(" + std::to_string(std::bit_cast<std::uint32_t>(x)) + "u)";
  return io::glsl_number(value);
}

std::string integer_text(std::uint32_t value) {
  return std::to_string(value) + "u";
}

namespace {

// The right side of an operation: A, B, C stand for its operands as they are in the bank, a, b, c for integers read as signed.
const char* pattern(Op op) {
  switch (op) {
    case Op::copy:
    case Op::icopy:
      return "A";
    case Op::add:
    case Op::iadd:
      return "A + B";
    case Op::sub:
    case Op::isub:
      return "A - B";
    case Op::mul:
    case Op::imul:
      return "A * B";
    case Op::div:
      return "A / B";
    case Op::neg:
      return "-A";
    case Op::mod:
      return "A - B * floor(A / B)";
    case Op::rem:
      return "A - B * trunc(A / B)";
    case Op::abs:
      return "abs(A)";
    case Op::sign:
      return "sign(A)";
    case Op::floor:
      return "floor(A)";
    case Op::ceil:
      return "ceil(A)";
    case Op::trunc:
      return "trunc(A)";
    case Op::round:
    case Op::round_even:
      return "roundEven(A)";
    case Op::fract:
      return "A - floor(A)";
    case Op::sqrt:
      return "sqrt(A)";
    case Op::inverse_sqrt:
      return "1.0 / sqrt(A)";
    case Op::exp:
      return "exp(A)";
    case Op::exp2:
      return "exp2(A)";
    case Op::log:
      return "log(A)";
    case Op::log2:
      return "log2(A)";
    case Op::pow:
      return "pow(A, B)";
    case Op::sin:
      return "sin(A)";
    case Op::cos:
      return "cos(A)";
    case Op::tan:
      return "tan(A)";
    case Op::asin:
      return "asin(A)";
    case Op::acos:
      return "acos(A)";
    case Op::atan:
      return "atan(A)";
    case Op::atan2:
    case Op::angle:
      return "atan(A, B)";
    case Op::sinh:
      return "sinh(A)";
    case Op::cosh:
      return "cosh(A)";
    case Op::tanh:
      return "tanh(A)";
    case Op::min:
      return "B < A ? B : A";
    case Op::max:
      return "A < B ? B : A";
    case Op::clamp:
      return "C < (A < B ? B : A) ? C : (A < B ? B : A)";
    case Op::mix:
      return "A * (1.0 - C) + B * C";
    case Op::step:
      return "B < A ? 0.0 : 1.0";
    case Op::smoothstep:
      return "smoothstep(A, B, C)";
    case Op::fma:
      return "A * B + C";
    case Op::log1p:
      return "log(1.0 + A) + B";
    case Op::select:
    case Op::iselect:
      return "A != 0u ? B : C";
    case Op::equal:
    case Op::ieq:
      return "A == B ? 1u : 0u";
    case Op::not_equal:
      return "A < B || B < A ? 1u : 0u";
    case Op::less:
    case Op::ult:
      return "A < B ? 1u : 0u";
    case Op::less_equal:
    case Op::ule:
      return "A <= B ? 1u : 0u";
    case Op::not_equal_or:
    case Op::ine:
      return "A != B ? 1u : 0u";
    case Op::less_or:
      return "!(A >= B) ? 1u : 0u";
    case Op::less_equal_or:
      return "!(A > B) ? 1u : 0u";
    case Op::is_nan:
      return "isnan(A) ? 1u : 0u";
    case Op::is_inf:
      return "isinf(A) ? 1u : 0u";
    case Op::to_signed:
      return "uint(int(A))";
    case Op::to_unsigned:
      return "uint(A)";
    case Op::bits_of:
      return "floatBitsToUint(A)";
    case Op::from_signed:
      return "float(a)";
    case Op::from_unsigned:
      return "float(A)";
    case Op::from_bits:
      return "uintBitsToFloat(A)";
    case Op::sdiv:
      return "B == 0u ? 0u : uint(a / b)";
    case Op::udiv:
      return "B == 0u ? 0u : A / B";
    case Op::smod:
      return "B == 0u ? 0u : uint(a - b * int(floor(float(a) / float(b))))";
    case Op::srem:
      return "B == 0u ? 0u : uint(a - b * (a / b))";
    case Op::umod:
      return "B == 0u ? 0u : A % B";
    case Op::ineg:
      return "0u - A";
    case Op::iand:
      return "A & B";
    case Op::ior:
      return "A | B";
    case Op::ixor:
      return "A ^ B";
    case Op::inot:
      return "~A";
    case Op::shl:
      return "A << (B & 31u)";
    case Op::shr:
      return "A >> (B & 31u)";
    case Op::sar:
      return "uint(a >> int(B & 31u))";
    case Op::slt:
      return "a < b ? 1u : 0u";
    case Op::sle:
      return "a <= b ? 1u : 0u";
    case Op::imin:
      return "uint(min(a, b))";
    case Op::imax:
      return "uint(max(a, b))";
    case Op::umin:
    case Op::index:
      return "min(A, B)";
    case Op::umax:
      return "max(A, B)";
    case Op::iabs:
      return "uint(abs(a))";
    case Op::isign:
      return "uint(sign(a))";
    case Op::logical_not:
      return "A == 0u ? 1u : 0u";
    case Op::erfcx:
    case Op::load_number:
    case Op::load_integer:
    case Op::store_number:
    case Op::store_integer:
      break;
  }
  return "";
}

std::string filled(const char* pattern, const std::string (&operands)[3]) {
  std::string out;
  for (const char* c = pattern; *c; ++c) {
    const bool alone = (c == pattern || !std::isalnum(static_cast<unsigned char>(c[-1]))) &&
                       !std::isalnum(static_cast<unsigned char>(c[1]));
    if (alone && *c >= 'A' && *c <= 'C')
      out += operands[*c - 'A'];
    else if (alone && *c >= 'a' && *c <= 'c')
      out += "int(" + operands[*c - 'a'] + ")";
    else
      out += *c;
  }
  return out;
}

// An element of an array at a place that changes: one case after another.
std::string indexed(const Step& s, bool load) {
  const bool whole = s.op == Op::load_integer || s.op == Op::store_integer;
  const auto name = [&](std::uint32_t slot) { return whole ? integer_slot(slot) : number_slot(slot); };
  std::string out;
  for (std::uint32_t k = 0; k < s.c; ++k) {
    const std::string is = k + 1 < s.c ? "if (" + integer_slot(s.b) + " == " + integer_text(k) + ") " : "";
    out += (k > 0 ? "else " : "") + is +
           (load ? name(s.r) + " = " + name(s.a + k) : name(s.r + k) + " = " + name(s.a)) + "; ";
  }
  return out;
}

}  // namespace

std::string statement(const Step& s) {
  if (s.op == Op::load_number || s.op == Op::load_integer) return indexed(s, true);
  if (s.op == Op::store_number || s.op == Op::store_integer) return indexed(s, false);
  const Operands o = operands_of(s.op);
  const std::uint32_t slots[] = {s.a, s.b, s.c};
  std::string operands[3];
  for (int k = 0; k < o.count; ++k)
    operands[k] = o.integer[k] ? integer_slot(slots[k]) : number_slot(slots[k]);
  return (o.result_integer ? integer_slot(s.r) : number_slot(s.r)) + " = " + filled(pattern(s.op), operands) +
         ";";
}

}  // namespace brdf::shader
