#include "brdf/trace.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <optional>

namespace brdf {

std::string detail::float_literal(float x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", double(x));
  std::string s = text;
  return s.find_first_of(".e") == std::string::npos ? s + ".0" : s;
}

namespace {

thread_local Trace* active = nullptr;

int add_float(float x) {
  return Trace::current().add(
      {Trace::Type::float_type, detail::float_literal(x), {}, true, std::bit_cast<std::uint32_t>(x)});
}
int add_uint(std::uint32_t x) {
  return Trace::current().add({Trace::Type::uint_type, std::to_string(x) + "u", {}, true, x});
}
int add(Trace::Type type, std::string code, std::vector<int> operands) {
  return Trace::current().add({type, std::move(code), std::move(operands)});
}
std::optional<float> float_constant(Traced x) {
  const Trace::Node& node = Trace::current()[x.node()];
  return node.constant ? std::optional(std::bit_cast<float>(node.bits)) : std::nullopt;
}

bool is_sum(std::string_view op) {
  return op == "+" || op == "-";
}
bool is_product(std::string_view op) {
  return op == "*" || op == "/";
}
bool has_constant(const Trace::Node& node) {
  return std::ranges::any_of(node.operands, [](int operand) { return Trace::current()[operand].constant; });
}
bool share_factor(const Trace::Node& a, const Trace::Node& b) {
  return a.code == "*" && b.code == "*" &&
         std::find_first_of(a.operands.begin(), a.operands.end(), b.operands.begin(), b.operands.end()) !=
             a.operands.end();
}

TracedBits bits_op(const char* op, TracedBits a, int b) {
  return TracedBits(add(Trace::Type::uint_type, op, {a.node(), b}));
}

// Returns the same number in a form that no compiler can fold: a uniform with value 0 is combined with its
// bits.
Traced opaque(Traced x) {
  const int zero = add(Trace::Type::uint_type, "brdf_zero", {});
  return from_bits(bits_op("^", to_bits(x), zero));
}

// Protects expressions that the shader compilers of browsers rearrange, which changes the rounding. They
// merge two consecutive constants, (x + 1) - 1 or 3 (2 x), into one. They replace (a + b) - a by b. They
// factor a out of a b + a c.
void keep_as_written(std::string_view op, Traced& a, Traced& b) {
  const Trace::Node &x = Trace::current()[a.node()], &y = Trace::current()[b.node()];
  const auto joins = [op](const Trace::Node& operand) {
    return (is_sum(op) && is_sum(operand.code)) || (is_product(op) && is_product(operand.code));
  };
  const auto holds = [](const Trace::Node& node, Traced operand) {
    return std::ranges::find(node.operands, operand.node()) != node.operands.end();
  };
  const bool first =
      (joins(x) && ((y.constant && has_constant(x)) || holds(x, b))) || (is_sum(op) && share_factor(x, y));
  const bool second = joins(y) && ((x.constant && has_constant(y)) || holds(y, a));
  if (first) a = opaque(a);
  if (second) b = opaque(b);
}

template <class Fold>
Traced arithmetic(const char* op, Traced a, Traced b, Fold fold) {
  const auto x = float_constant(a), y = float_constant(b);
  if (x && y) {
    const float folded = fold(*x, *y);
    if (std::isfinite(folded)) return Traced::from_node(add_float(folded));
  }
  if (Trace::current().dialect() == GlslDialect::es) keep_as_written(op, a, b);
  return Traced::from_node(add(Trace::Type::float_type, op, {a.node(), b.node()}));
}

// A kernel call with a constant argument is folded by the float kernel itself.
Traced call(const char* function, Traced x, float (*kernel)(const float&)) {
  if (const auto c = float_constant(x)) return Traced::from_node(add_float(kernel(*c)));
  return Traced::from_node(add(Trace::Type::float_type, function, {x.node()}));
}

const char* type_name(Trace::Type type) {
  return type == Trace::Type::float_type ? "float" : type == Trace::Type::uint_type ? "uint" : "bool";
}

std::string expression(const Trace::Node& node, const std::vector<std::string>& names) {
  const auto name = [&](std::size_t k) { return names[std::size_t(node.operands[k])]; };
  if (node.code == "?") return name(0) + " ? " + name(1) + " : " + name(2);
  if (node.code == "neg") return "-" + name(0);
  if (std::isalpha(static_cast<unsigned char>(node.code[0]))) {  // a function
    std::string text = node.code + "(";
    for (std::size_t k = 0; k < node.operands.size(); ++k) text += (k ? ", " : "") + name(k);
    return text + ")";
  }
  return name(0) + " " + node.code + " " + name(1);
}

}  // namespace

int Trace::add(Node node) {
  const auto [it, inserted] = known_.try_emplace(node, int(nodes_.size()));
  if (inserted) nodes_.push_back(std::move(node));
  return it->second;
}

std::string Trace::statements(const std::vector<int>& roots, std::string_view result, bool precise) const {
  std::vector<std::string> names(nodes_.size());
  std::string text;
  int count = 0;
  const auto emit = [&](const auto& self, int id) -> void {
    std::string& name = names[std::size_t(id)];
    if (!name.empty()) return;
    const Node& node = nodes_[std::size_t(id)];
    if (node.operands.empty()) {  // an input or a literal; a negative literal needs parentheses
      name = node.code[0] == '-' ? "(" + node.code + ")" : node.code;
      return;
    }
    for (int operand : node.operands) self(self, operand);
    name = "t" + std::to_string(count++);
    const bool keep = precise && node.type == Type::float_type;
    text += std::string("  ") + (keep ? "precise " : "") + type_name(node.type) + " " + name + " = " +
            expression(node, names) + ";\n";
  };
  for (int root : roots) emit(emit, root);
  std::string line = "  ";
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (result[k] == '%')
      line += names[std::size_t(roots[std::size_t(result[++k] - '0')])];
    else
      line += result[k];
  }
  return text + line + "\n";
}

Trace& Trace::current() {
  static thread_local Trace fallback;
  return active ? *active : fallback;
}
Trace::Scope::Scope(Trace& trace) : previous_(active) {
  active = &trace;
}
Trace::Scope::~Scope() {
  active = previous_;
}

TracedBits operator+(TracedBits a, std::uint32_t b) {
  return bits_op("+", a, add_uint(b));
}
TracedBits operator-(TracedBits a, std::uint32_t b) {
  return bits_op("-", a, add_uint(b));
}
TracedBits operator-(TracedBits a, TracedBits b) {
  return bits_op("-", a, b.node());
}
TracedBits operator|(TracedBits a, std::uint32_t b) {
  return bits_op("|", a, add_uint(b));
}
TracedBits operator&(TracedBits a, std::uint32_t b) {
  return bits_op("&", a, add_uint(b));
}
TracedBits operator<<(TracedBits a, int b) {
  return bits_op("<<", a, add_uint(std::uint32_t(b)));
}
TracedBits operator>>(TracedBits a, int b) {
  return bits_op(">>", a, add_uint(std::uint32_t(b)));
}

Traced::Traced(double constant) : node_(add_float(float(constant))) {}
Traced Traced::input(std::string_view glsl) {
  return from_node(add(Trace::Type::float_type, std::string(glsl), {}));
}

Traced operator+(Traced a, Traced b) {
  return arithmetic("+", a, b, [](float x, float y) { return x + y; });
}
Traced operator-(Traced a, Traced b) {
  return arithmetic("-", a, b, [](float x, float y) { return x - y; });
}
Traced operator*(Traced a, Traced b) {
  return arithmetic("*", a, b, [](float x, float y) { return x * y; });
}
Traced operator/(Traced a, Traced b) {
  return arithmetic("/", a, b, [](float x, float y) { return x / y; });
}
Traced operator-(Traced a) {
  if (const auto c = float_constant(a)) return Traced::from_node(add_float(-*c));
  return Traced::from_node(add(Trace::Type::float_type, "neg", {a.node()}));
}
TracedBool operator<(Traced a, Traced b) {
  return TracedBool(add(Trace::Type::bool_type, "<", {a.node(), b.node()}));
}
Traced select(TracedBool c, Traced yes, Traced no) {
  return Traced::from_node(add(Trace::Type::float_type, "?", {c.node(), yes.node(), no.node()}));
}
Traced sqrt(Traced x) {
  return call("sqrt", x, [](const float& c) { return std::sqrt(c); });
}
TracedBits to_bits(Traced x) {
  return TracedBits(add(Trace::Type::uint_type, "floatBitsToUint", {x.node()}));
}
Traced from_bits(TracedBits bits) {
  return Traced::from_node(add(Trace::Type::float_type, "uintBitsToFloat", {bits.node()}));
}
kernels::WholePower<Traced> whole_power(Traced x) {
  if (Trace::current().dialect() == GlslDialect::vulkan) return kernels::whole_power<Traced>(x);
  const int n = add(Trace::Type::float_type, "roundEven", {x.node()});
  return {Traced::from_node(n), Traced::from_node(add(Trace::Type::float_type, "brdf_power_of_two", {n}))};
}
Traced exp(Traced x) {
  return call("brdf_exp", x, kernels::exp<float>);
}
Traced log(Traced x) {
  return call("brdf_log", x, kernels::log<float>);
}
Traced log1p(Traced x, Traced rest) {
  return Traced::from_node(add(Trace::Type::float_type, "brdf_log1p", {x.node(), rest.node()}));
}
Traced erfcx(Traced x) {
  return call("brdf_erfcx", x, kernels::erfcx<float>);
}
Traced atan2(Traced y, Traced x) {
  return Traced::from_node(add(Trace::Type::float_type, "brdf_angle", {y.node(), x.node()}));
}

Traced sin(Traced x) {
  return Traced::from_node(add(Trace::Type::float_type, "sin", {x.node()}));
}
Traced cos(Traced x) {
  return Traced::from_node(add(Trace::Type::float_type, "cos", {x.node()}));
}
Traced pow(Traced x, Traced y) {
  return exp(y * log(x));
}
Traced log1p(Traced x) {
  return math::log1p(x);
}
Traced expm1(Traced x) {
  return exp(x) - Traced(1);
}
Traced erfc(Traced x) {
  const TracedBool negative = x < Traced(0);
  const Traced size = select(negative, -x, x), tail = exp(-size * size) * erfcx(size);
  return select(negative, Traced(2) - tail, tail);
}

}  // namespace brdf
