#include "shader/reflection.h"

#include <algorithm>

#include "shader/program/flow.h"

namespace brdf::shader {
namespace {

// How a value changes when a coordinate changes its sign. A value of 0 is both even and odd.
enum class Parity : std::uint8_t { unreached, zero, even, odd, unknown };

Parity sum_of(Parity a, Parity b) {
  if (a == Parity::zero || b == Parity::unreached) return b == Parity::unreached ? a : b;
  if (b == Parity::zero || a == Parity::unreached) return a == Parity::unreached ? b : a;
  return a == b ? a : Parity::unknown;
}
Parity product_of(Parity a, Parity b) {
  if (a == Parity::unknown || b == Parity::unknown) return Parity::unknown;
  if (a == Parity::zero || b == Parity::zero) return Parity::zero;
  return a == b ? Parity::even : Parity::odd;
}
bool is_even(Parity p) {
  return p == Parity::even || p == Parity::zero || p == Parity::unreached;
}

// Returns whether f(-x) = -f(x), for every rounding to nearest.
bool is_odd_function(Op op) {
  return op == Op::neg || op == Op::sin || op == Op::tan || op == Op::asin || op == Op::atan ||
         op == Op::sinh || op == Op::tanh || op == Op::sign || op == Op::trunc || op == Op::round_even ||
         op == Op::round || op == Op::to_half;
}

struct Reflection {
  using Value = Parity;

  static Value join(Value a, Value b) { return sum_of(a, b); }
  static Value element(Value all, Value index) { return is_even(index) ? all : Parity::unknown; }
  static bool branch(Value condition) { return is_even(condition); }
  static Value controlled(Value written, Value) { return written; }
  static Value step(const Step& x, const Operation& o, const Value* operands) {
    if (x.op == Op::copy || x.op == Op::icopy || is_odd_function(x.op)) return operands[0];
    if (x.op == Op::abs && operands[0] == Parity::odd) return Parity::even;
    if (x.op == Op::add || x.op == Op::sub) return sum_of(operands[0], operands[1]);
    if (x.op == Op::div && operands[1] == Parity::zero) return Parity::unknown;
    if (x.op == Op::mul || x.op == Op::div) return product_of(operands[0], operands[1]);
    if (x.op == Op::fma) return sum_of(product_of(operands[0], operands[1]), operands[2]);
    if (x.op == Op::mix) return is_even(operands[2]) ? sum_of(operands[0], operands[1]) : Parity::unknown;
    if (x.op == Op::select) return is_even(operands[0]) ? sum_of(operands[1], operands[2]) : Parity::unknown;
    return std::all_of(operands, operands + o.count(), is_even) ? Parity::even : Parity::unknown;
  }
};

Parity parity_of(const Binding& b, int coordinate) {
  const auto along = [&](int component) { return component == coordinate ? Parity::odd : Parity::even; };
  if (b.from == Binding::From::zero) return b.integer ? Parity::even : Parity::zero;
  if (b.from == Binding::From::coordinate) {
    if (frame_coordinate(b.a) < 0) return along(b.component);
    return frame_coordinate(b.a) == b.component ? Parity::even : Parity::zero;
  }
  if (b.from == Binding::From::product && (frame_coordinate(b.a) >= 0) != (frame_coordinate(b.b) >= 0))
    return along(std::max(frame_coordinate(b.a), frame_coordinate(b.b)));
  return Parity::even;
}

bool reflects_along(const Program& p, const std::vector<Binding>& bindings, int coordinate) {
  Reflection domain;
  Flow flow(p, domain);
  for (const Program::Constant& c : p.constants)
    flow.start(false, c.slot) = c.value == 0 ? Parity::zero : Parity::even;
  for (const Program::IntegerConstant& c : p.integer_constants) flow.start(true, c.slot) = Parity::even;
  for (const Program::Undefined& u : p.undefined) flow.start(u.integer, u.slot) = Parity::even;
  for (const Binding& b : bindings) flow.start(b.integer, b.slot) = parity_of(b, coordinate);
  return flow.run() && std::all_of(flow.results().begin(), flow.results().end(), is_even);
}

}  // namespace

bool reflects(const Program& program, const std::vector<Binding>& bindings) {
  return reflects_along(program, bindings, 0) && reflects_along(program, bindings, 1);
}

}  // namespace brdf::shader
