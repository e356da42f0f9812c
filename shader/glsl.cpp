#include "shader/glsl.h"

#include <bit>
#include <cctype>
#include <cmath>
#include <set>

#include "brdf/geometry.h"
#include "io/material/glsl.h"
#include "shader/operation_texts.h"
#include "shader/program/operations.h"

namespace brdf::shader {
namespace {

using io::ShaderLanguage;

constexpr std::size_t kMostOperations = 20'000;
constexpr std::uint32_t kLongestArray = 256;  // with a variable index

// Returns the name of the variable for a slot of the bank of numbers, or of the bank of integers.
std::string number_slot(std::uint32_t slot) {
  return "n" + std::to_string(slot);
}
std::string integer_slot(std::uint32_t slot) {
  return "i" + std::to_string(slot);
}

// Returns a literal. A number that is not finite as a float is written by its bits.
std::string number_text(double value) {
  if (const float x = float(value); !std::isfinite(x))
    return "uintBitsToFloat(" + std::to_string(std::bit_cast<std::uint32_t>(x)) + "u)";
  return io::glsl_number(value);
}

std::string integer_text(std::uint32_t value) {
  return std::to_string(value) + "u";
}

// Returns the right side of an operation. Operands that are no names need a text in which the operation puts
// them in parentheses.
std::string right_side(Op op, ShaderLanguage language, const std::string (&operands)[3]) {
  const char* const pattern = text_of(op, language);
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

// Returns a statement such as "n7 = n3 * n4;". Access to an array with a variable index becomes a chain of
// cases.
std::string statement(const Step& s, ShaderLanguage language) {
  if (s.op == Op::load_number || s.op == Op::load_integer) return indexed(s, true);
  if (s.op == Op::store_number || s.op == Op::store_integer) return indexed(s, false);
  const Operation& o = operation(s.op);
  const std::uint32_t slots[] = {s.a, s.b, s.c};
  std::string operands[3];
  for (int k = 0; k < o.count(); ++k)
    operands[k] = o.reads_integer(k) ? integer_slot(slots[k]) : number_slot(slots[k]);
  return (o.writes_integer() ? integer_slot(s.r) : number_slot(s.r)) + " = " +
         right_side(s.op, language, operands) + ";";
}

std::string jump(const Program& p, const Stretch& s) {
  if (s.end == End::stop) return "at = " + integer_text(std::uint32_t(p.stretches.size())) + ";";
  if (s.end == End::jump) return "at = " + integer_text(s.next[0]) + ";";
  return "at = " + integer_slot(s.condition) + " != 0u ? " + integer_text(s.next[0]) + " : " +
         integer_text(s.next[1]) + ";";
}

std::string steps_of(const Stretch& s, ShaderLanguage language, const std::string& indent) {
  std::string out;
  for (const Step& step : s.steps) out += indent + statement(step, language) + "\n";
  return out;
}

// Stretches are written in their execution order. A stretch that leads back is reached through a loop over
// all stretches.
std::string body(const Program& p, ShaderLanguage language) {
  if (p.stretches.size() == 1) return steps_of(p.stretches[0], language, "  ");
  const std::string end = integer_text(std::uint32_t(p.stretches.size()));
  std::string out = "  uint at = 0u;\n";
  if (p.loops) out += "  for (int turn = 0; turn < 4096 && at != " + end + "; ++turn) {\n";
  for (std::size_t k = 0; k < p.stretches.size(); ++k)
    out += "  if (at == " + integer_text(std::uint32_t(k)) + ") {\n" +
           steps_of(p.stretches[k], language, "    ") + "    " + jump(p, p.stretches[k]) + "\n  }\n";
  if (p.loops) out += "  }\n";
  return out;
}

// C++ compilers warn of variables that nothing reads.
std::string unread_too(ShaderLanguage language) {
  return language == ShaderLanguage::cpp ? "[[maybe_unused]] " : "";
}

std::string number_type(const Wording& w) {
  switch (w.language) {
    case ShaderLanguage::glsl:
    case ShaderLanguage::explorer:
    case ShaderLanguage::hlsl:
      return w.precise ? "precise float " : "float ";
    case ShaderLanguage::glsl_es:
    case ShaderLanguage::cpp:
      return unread_too(w.language) + "float ";
  }
  return "";
}

// Declares all slots, with their contents before the first step.
std::string declarations(const Program& p, const Wording& w) {
  std::set<std::uint32_t> numbers(p.results.begin(), p.results.end()), integers;
  for (const Stretch& s : p.stretches) {
    if (s.end == End::branch) integers.insert(s.condition);
    for (const Step& step : s.steps) {
      const Operation& o = operation(step.op);
      const std::uint32_t slots[] = {step.a, step.b, step.c};
      for (std::uint32_t k = 0; k < o.slots_written(step); ++k)
        (o.writes_integer() ? integers : numbers).insert(step.r + k);
      for (int j = 0; j < o.count(); ++j)
        for (std::uint32_t k = 0; k < (j == 0 && o.loads() ? step.c : 1); ++k)
          (o.reads_integer(j) ? integers : numbers).insert(slots[j] + k);
    }
  }
  for (const Input& input : p.inputs)
    for (const std::uint32_t slot : input.slots) (input.integer ? integers : numbers).insert(slot);
  std::string out;
  for (const std::uint32_t slot : numbers) out += "  " + number_type(w) + number_slot(slot) + " = 0.0;\n";
  for (const std::uint32_t slot : integers)
    out += "  " + unread_too(w.language) + "uint " + integer_slot(slot) + " = 0u;\n";
  for (const Program::Constant& c : p.constants)
    if (numbers.contains(c.slot)) out += "  " + number_slot(c.slot) + " = " + number_text(c.value) + ";\n";
  for (const Program::IntegerConstant& c : p.integer_constants)
    if (integers.contains(c.slot)) out += "  " + integer_slot(c.slot) + " = " + integer_text(c.value) + ";\n";
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

// Assigns the inputs. The parameters' value number k is called v<k>.
std::string inputs(const Function& f, ShaderLanguage language) {
  const auto whole = [&](const std::string& value) {
    const std::string rounded = right_side(Op::floor, language, {value + " + 0.5"});
    return right_side(Op::to_signed, language, {rounded});
  };
  std::string out;
  for (const Binding& b : f.bindings) {
    std::string value = b.from == Binding::From::one ? "1.0" : "0.0";
    if (b.from == Binding::From::coordinate) value = axis(b.a) + "." + "xyz"[b.component];
    if (b.from == Binding::From::product)
      value = "clamp(dot(" + axis(b.a) + ", " + axis(b.b) + "), -1.0, 1.0)";
    if (b.from == Binding::From::value) value = "v" + std::to_string(b.value);
    if (!b.integer)
      out += "  " + number_slot(b.slot) + " = " + value + ";\n";
    else if (b.from != Binding::From::value)
      out += "  " + integer_slot(b.slot) + (b.from == Binding::From::one ? " = 1u;\n" : " = 0u;\n");
    else
      out += "  " + integer_slot(b.slot) + " = " + (b.boolean ? value + " >= 0.5 ? 1u : 0u" : whole(value)) +
             ";\n";
  }
  return out;
}

// Writes vec3 brdf_run_<name>(wi, wo, v0, v1, ...), which gives the value that the function returns.
std::string run_function(const Function& f, const std::string& name, const Wording& w) {
  std::string text = "vec3 brdf_run_" + name + "(vec3 wi, vec3 wo";
  for (std::size_t k = 0; k < f.values; ++k)
    text += ", " + unread_too(w.language) + "float v" + std::to_string(k);
  text += ") {\n  vec3 h = wi + wo;\n  h = h / " +
          right_side(Op::sqrt, w.language, {"h.x * h.x + h.y * h.y + h.z * h.z"}) + ";\n" +
          declarations(f.as_written, w) + inputs(f, w.language) + body(f.as_written, w.language);
  const std::vector<std::uint32_t>& r = f.as_written.results;
  const auto result = [&](std::size_t c) { return number_slot(r[std::min(c, r.size() - 1)]); };
  return text + "  return vec3(" + result(0) + ", " + result(1) + ", " + result(2) + ");\n}\n";
}

}  // namespace

std::string glsl_obstacle(const Function& f) {
  if (f.as_written.size() > kMostOperations)
    return "has more than " + std::to_string(kMostOperations) + " operations";
  for (const Stretch& s : f.as_written.stretches)
    for (const Step& step : s.steps) {
      const Operation& o = operation(step.op);
      if (step.op == Op::texel) return "reads a texture";
      if ((o.loads() || o.stores()) && step.c > kLongestArray)
        return "has an array of more than " + std::to_string(kLongestArray) + " numbers";
    }
  return "";
}

std::string glsl_of(const Function& f, const std::string& name, const std::vector<std::size_t>& weights,
                    const std::vector<std::size_t>& shape, const Wording& wording) {
  std::string text = run_function(f, name, wording);
  const std::vector<std::string>& names = wording.arguments;
  std::string arguments = "vec3 wi, vec3 wo";
  for (std::size_t k = 0; k < names.size(); ++k)
    arguments += (k < shape.size() ? ", float " : ", vec3 ") + names[k];
  bool all_colours = true;
  for (const std::size_t k : weights) all_colours = all_colours && f.parameters[k].colour;
  // A number that is a weight may differ from channel to channel. In this case each channel has a run of
  // its own.
  const auto call = [&](const std::string& component) {
    std::vector<std::string> values(f.values, "0.0");
    for (std::size_t k = 0; k < shape.size(); ++k) values[f.parameters[shape[k]].first] = names[k];
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const Parameter& p = f.parameters[weights[k]];
      for (std::size_t c = 0; c < (p.colour ? 3u : 1u); ++c)
        values[p.first + c] =
            names[shape.size() + k] + (component.empty() ? std::string(".") + "rgb"[c] : component);
    }
    std::string words = "brdf_run_" + name + "(wi, wo";
    for (const std::string& v : values) words += ", " + v;
    return words + ")" + component;
  };
  const std::string value = weights.empty() || all_colours
                                ? call("")
                                : "vec3(" + call(".r") + ", " + call(".g") + ", " + call(".b") + ")";
  const std::string least = number_text(kMinCosine<float>),
                    cos_i = "(" + right_side(Op::max, wording.language, {"wi.z", least}) + ")",
                    cos_o = "(" + right_side(Op::max, wording.language, {"wo.z", least}) + ")";
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
