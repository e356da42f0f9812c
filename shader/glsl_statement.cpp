#include "shader/glsl_statement.h"

#include <bit>
#include <cctype>
#include <cmath>

#include "io/material/glsl.h"
#include "shader/program/operations.h"

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

// Access to an array with a variable index: one case per element.
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
  const Operation& o = operation(s.op);
  const std::uint32_t slots[] = {s.a, s.b, s.c};
  std::string operands[3];
  for (int k = 0; k < o.count(); ++k)
    operands[k] = o.reads_integer(k) ? integer_slot(slots[k]) : number_slot(slots[k]);
  return (o.writes_integer() ? integer_slot(s.r) : number_slot(s.r)) + " = " + filled(o.glsl, operands) + ";";
}

}  // namespace brdf::shader
