#include "shader/glsl.h"

#include <bit>
#include <cmath>
#include <set>

#include "brdf/geometry.h"
#include "io/glsl.h"
#include "shader/program/operands.h"

namespace brdf::shader {
namespace {

constexpr std::size_t kMostOperations = 20'000;
constexpr std::uint32_t kLongestArray = 256;  // at a changing place

std::string n(std::uint32_t slot) {
  return "n" + std::to_string(slot);
}
std::string i(std::uint32_t slot) {
  return "i" + std::to_string(slot);
}

std::string number(double value) {
  if (const float x = float(value); !std::isfinite(x))
    return "uintBitsToFloat(" + std::to_string(std::bit_cast<std::uint32_t>(x)) + "u)";
  return io::glsl_number(value);
}

std::string integer(std::uint32_t value) {
  return std::to_string(value) + "u";
}

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
  const auto name = [&](std::uint32_t slot) { return whole ? i(slot) : n(slot); };
  std::string out;
  for (std::uint32_t k = 0; k < s.c; ++k) {
    const std::string is = k + 1 < s.c ? "if (" + i(s.b) + " == " + integer(k) + ") " : "";
    out += (k > 0 ? "else " : "") + is +
           (load ? name(s.r) + " = " + name(s.a + k) : name(s.r + k) + " = " + name(s.a)) + "; ";
  }
  return out;
}

std::string statement(const Step& s) {
  if (s.op == Op::load_number || s.op == Op::load_integer) return indexed(s, true);
  if (s.op == Op::store_number || s.op == Op::store_integer) return indexed(s, false);
  const Operands o = operands_of(s.op);
  const std::uint32_t slots[] = {s.a, s.b, s.c};
  std::string operands[3];
  for (int k = 0; k < o.count; ++k) operands[k] = o.integer[k] ? i(slots[k]) : n(slots[k]);
  return (o.result_integer ? i(s.r) : n(s.r)) + " = " + filled(pattern(s.op), operands) + ";";
}

std::string jump(const Program& p, const Stretch& s) {
  if (s.end == End::stop) return "at = " + integer(std::uint32_t(p.stretches.size())) + ";";
  if (s.end == End::jump) return "at = " + integer(s.next[0]) + ";";
  return "at = " + i(s.condition) + " != 0u ? " + integer(s.next[0]) + " : " + integer(s.next[1]) + ";";
}

std::string steps_of(const Stretch& s, const std::string& indent) {
  std::string out;
  for (const Step& step : s.steps) out += indent + statement(step) + "\n";
  return out;
}

// Stretches stand in the order in which they follow one another; those that lead back do so within a loop over all.
std::string body(const Program& p) {
  if (p.stretches.size() == 1) return steps_of(p.stretches[0], "  ");
  const std::string end = integer(std::uint32_t(p.stretches.size()));
  std::string out = "  uint at = 0u;\n";
  if (p.loops) out += "  for (int turn = 0; turn < 4096 && at != " + end + "; ++turn) {\n";
  for (std::size_t k = 0; k < p.stretches.size(); ++k)
    out += "  if (at == " + integer(std::uint32_t(k)) + ") {\n" + steps_of(p.stretches[k], "    ") + "    " +
           jump(p, p.stretches[k]) + "\n  }\n";
  if (p.loops) out += "  }\n";
  return out;
}

// All slots, with what they hold before the first step.
std::string declarations(const Program& p, bool precise) {
  std::set<std::uint32_t> numbers(p.results.begin(), p.results.end()), integers;
  for (const Stretch& s : p.stretches) {
    if (s.end == End::branch) integers.insert(s.condition);
    for (const Step& step : s.steps) {
      const Operands o = operands_of(step.op);
      const std::uint32_t slots[] = {step.a, step.b, step.c};
      for (std::uint32_t k = 0; k < o.writes(step); ++k)
        (o.result_integer ? integers : numbers).insert(step.r + k);
      for (int j = 0; j < o.count; ++j)
        for (std::uint32_t k = 0; k < (j == 0 && o.indexed_load ? step.c : 1); ++k)
          (o.integer[j] ? integers : numbers).insert(slots[j] + k);
    }
  }
  for (const Input& input : p.inputs)
    for (const std::uint32_t slot : input.slots) (input.integer ? integers : numbers).insert(slot);
  std::string out;
  const std::string type = precise ? "  precise float " : "  float ";
  for (const std::uint32_t slot : numbers) out += type + n(slot) + " = 0.0;\n";
  for (const std::uint32_t slot : integers) out += "  uint " + i(slot) + " = 0u;\n";
  for (const Program::Constant& c : p.constants)
    if (numbers.contains(c.slot)) out += "  " + n(c.slot) + " = " + number(c.value) + ";\n";
  for (const Program::IntegerConstant& c : p.integer_constants)
    if (integers.contains(c.slot)) out += "  " + i(c.slot) + " = " + integer(c.value) + ";\n";
  return out;
}

std::string axis(Axis a) {
  switch (a) {
    case Axis::light:
      return "wi";
    case Axis::view:
      return "wo";
    case Axis::half:
      return "h";
    case Axis::normal:
      return "vec3(0.0, 0.0, 1.0)";
    case Axis::tangent:
      return "vec3(1.0, 0.0, 0.0)";
    case Axis::bitangent:
      return "vec3(0.0, 1.0, 0.0)";
  }
  return "";
}

// What fills the inputs; value number k of the parameters is called v<k>.
std::string inputs(const Function& f) {
  std::string out;
  for (const Binding& b : f.bindings) {
    std::string value = b.from == Binding::From::one ? "1.0" : "0.0";
    if (b.from == Binding::From::coordinate) value = axis(b.a) + "." + "xyz"[b.component];
    if (b.from == Binding::From::product)
      value = "clamp(dot(" + axis(b.a) + ", " + axis(b.b) + "), -1.0, 1.0)";
    if (b.from == Binding::From::value) value = "v" + std::to_string(b.value);
    if (!b.integer)
      out += "  " + n(b.slot) + " = " + value + ";\n";
    else if (b.from != Binding::From::value)
      out += "  " + i(b.slot) + (b.from == Binding::From::one ? " = 1u;\n" : " = 0u;\n");
    else
      out += "  " + i(b.slot) + " = " +
             (b.boolean ? value + " >= 0.5 ? 1u : 0u" : "uint(int(floor(" + value + " + 0.5)))") + ";\n";
  }
  return out;
}

// vec3 brdf_run_<name>(wi, wo, v0, v1, ...): what the function returned.
std::string run_function(const Function& f, const std::string& name, bool precise) {
  std::string text = "vec3 brdf_run_" + name + "(vec3 wi, vec3 wo";
  for (std::size_t k = 0; k < f.values; ++k) text += ", float v" + std::to_string(k);
  text += ") {\n  vec3 h = wi + wo;\n  h = h / sqrt(h.x * h.x + h.y * h.y + h.z * h.z);\n" +
          declarations(f.as_written, precise) + inputs(f) + body(f.as_written);
  const std::vector<std::uint32_t>& r = f.as_written.results;
  const auto result = [&](std::size_t c) { return n(r[std::min(c, r.size() - 1)]); };
  return text + "  return vec3(" + result(0) + ", " + result(1) + ", " + result(2) + ");\n}\n";
}

}  // namespace

std::string glsl_obstacle(const Function& f) {
  if (f.as_written.size() > kMostOperations)
    return "has more than " + std::to_string(kMostOperations) + " operations";
  for (const Stretch& s : f.as_written.stretches)
    for (const Step& step : s.steps) {
      const Operands o = operands_of(step.op);
      if ((o.indexed_load || o.indexed_store) && step.c > kLongestArray)
        return "has an array of more than " + std::to_string(kLongestArray) + " numbers";
    }
  return "";
}

std::string glsl_of(const Function& f, const std::string& name, const std::vector<std::size_t>& weights,
                    const std::vector<std::size_t>& shape, const GlslOptions& options) {
  std::string text = run_function(f, name, options.marks_precise());
  std::string arguments = "vec3 wi, vec3 wo";
  for (std::size_t k = 0; k < shape.size(); ++k) arguments += ", float s" + std::to_string(k);
  for (std::size_t k = 0; k < weights.size(); ++k) arguments += ", vec3 w" + std::to_string(k);
  bool all_colours = true;
  for (const std::size_t k : weights) all_colours = all_colours && f.parameters[k].colour;
  // A number that is a weight may differ from channel to channel: then each has a run of its own.
  const auto call = [&](const std::string& component) {
    std::vector<std::string> values(f.values, "0.0");
    for (std::size_t k = 0; k < shape.size(); ++k)
      values[f.parameters[shape[k]].first] = "s" + std::to_string(k);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const Parameter& p = f.parameters[weights[k]];
      for (std::size_t c = 0; c < (p.colour ? 3u : 1u); ++c)
        values[p.first + c] =
            "w" + std::to_string(k) + (component.empty() ? std::string(".") + "rgb"[c] : component);
    }
    std::string words = "brdf_run_" + name + "(wi, wo";
    for (const std::string& v : values) words += ", " + v;
    return words + ")" + component;
  };
  const std::string value = weights.empty() || all_colours
                                ? call("")
                                : "vec3(" + call(".r") + ", " + call(".g") + ", " + call(".b") + ")";
  const std::string least = number(kMinCosine<float>), cos_i = "max(wi.z, " + least + ")",
                    cos_o = "max(wo.z, " + least + ")";
  for (const bool cosine : {false, true}) {
    std::string factor;
    if (f.returns == Returns::f && cosine) factor = " * " + cos_i;
    if (f.returns == Returns::f_cos_i && !cosine) factor = " / " + cos_i;
    if (f.returns == Returns::f_cos_o) factor = " / " + cos_o + (cosine ? " * " + cos_i : "");
    text += std::string("vec3 brdf_eval_") + (cosine ? "cos_" : "") + name + "(" + arguments +
            ") {\n  if (wi.z < 0.0 || wo.z < 0.0) return vec3(0.0);\n  return " + value + factor + ";\n}\n";
  }
  return text;
}

}  // namespace brdf::shader
