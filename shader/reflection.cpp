#include "shader/reflection.h"

#include <algorithm>

#include "shader/program/operations.h"

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

// Whether f(-x) = -f(x), for every rounding to nearest.
bool is_odd_function(Op op) {
  return op == Op::neg || op == Op::sin || op == Op::tan || op == Op::asin || op == Op::atan ||
         op == Op::sinh || op == Op::tanh || op == Op::sign || op == Op::trunc || op == Op::round_even ||
         op == Op::round;
}

class Reflection {
 public:
  Reflection(const Program& program, const std::vector<Binding>& bindings, int coordinate)
      : p_(program), begins_(p_.stretches.size()) {
    State start(p_.numbers + p_.integers, Parity::unreached);
    for (const Program::Constant& c : p_.constants)
      start[c.slot] = c.value == 0 ? Parity::zero : Parity::even;
    for (const Program::IntegerConstant& c : p_.integer_constants) start[p_.numbers + c.slot] = Parity::even;
    for (const Program::Undefined& u : p_.undefined)
      start[u.integer ? p_.numbers + u.slot : u.slot] = Parity::even;
    for (const Binding& b : bindings)
      start[b.integer ? p_.numbers + b.slot : b.slot] = parity_of(b, coordinate);
    begins_[0] = std::move(start);
  }

  bool holds() {
    constexpr std::size_t kMost = std::size_t(1) << 24;
    if (begins_[0].size() * p_.stretches.size() > kMost) return false;
    do {
      changed_ = false;
      for (std::size_t k = 0; k < p_.stretches.size() && !failed_; ++k)
        if (!begins_[k].empty()) pass(k);
    } while (changed_ && !failed_);
    return !failed_;
  }

 private:
  using State = std::vector<Parity>;

  static Parity parity_of(const Binding& b, int coordinate) {
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

  Parity& at(State& s, bool integer, std::uint32_t slot) const {
    return s[integer ? p_.numbers + slot : slot];
  }

  void pass(std::size_t which) {
    State s = begins_[which];
    const Stretch& stretch = p_.stretches[which];
    for (const Step& step : stretch.steps) follow(s, step);
    if (stretch.end == End::branch && !is_even(at(s, true, stretch.condition))) failed_ = true;
    if (stretch.end == End::stop) {
      for (const std::uint32_t slot : p_.results) failed_ = failed_ || !is_even(at(s, false, slot));
      return;
    }
    for (int k = 0; k < (stretch.end == End::branch ? 2 : 1); ++k) merge(s, stretch.next[k]);
  }
  void merge(const State& from, std::size_t target) {
    State& to = begins_[target];
    if (to.empty()) {
      to = from;
      changed_ = true;
      return;
    }
    for (std::size_t k = 0; k < to.size(); ++k)
      if (const Parity both = sum_of(to[k], from[k]); both != to[k]) to[k] = both, changed_ = true;
  }

  void follow(State& s, const Step& x) {
    const Operation& o = operation(x.op);
    const std::uint32_t slots[] = {x.a, x.b, x.c};
    const auto operand = [&](int k) { return at(s, o.reads_integer(k), slots[k]); };
    if (o.loads() || o.stores()) return indexed(s, x, o);
    bool all_even = true;
    for (int k = 0; k < o.count(); ++k) all_even = all_even && is_even(operand(k));
    Parity out = all_even ? Parity::even : Parity::unknown;
    if (x.op == Op::copy || x.op == Op::icopy || is_odd_function(x.op)) out = operand(0);
    if (x.op == Op::abs && operand(0) == Parity::odd) out = Parity::even;
    if (x.op == Op::add || x.op == Op::sub) out = sum_of(operand(0), operand(1));
    if (x.op == Op::mul || x.op == Op::div) out = product_of(operand(0), operand(1));
    if (x.op == Op::div && operand(1) == Parity::zero) out = Parity::unknown;
    if (x.op == Op::fma) out = sum_of(product_of(operand(0), operand(1)), operand(2));
    if (x.op == Op::mix) out = is_even(operand(2)) ? sum_of(operand(0), operand(1)) : Parity::unknown;
    if (x.op == Op::select) out = is_even(operand(0)) ? sum_of(operand(1), operand(2)) : Parity::unknown;
    at(s, o.writes_integer(), x.r) = out;
  }
  // The elements of an array are treated as one value.
  void indexed(State& s, const Step& x, const Operation& o) const {
    Parity all = is_even(at(s, true, x.b)) ? Parity::unreached : Parity::unknown;
    const std::uint32_t from = o.loads() ? x.a : x.r;
    for (std::uint32_t k = 0; k < x.c; ++k)
      all = sum_of(all, at(s, o.loads() ? o.reads_integer(0) : o.writes_integer(), from + k));
    if (o.loads()) {
      at(s, o.writes_integer(), x.r) = all;
      return;
    }
    all = sum_of(all, at(s, o.reads_integer(0), x.a));
    for (std::uint32_t k = 0; k < x.c; ++k) at(s, o.writes_integer(), x.r + k) = all;
  }

  const Program& p_;
  std::vector<State> begins_;
  bool changed_ = false, failed_ = false;
};

}  // namespace

bool reflects(const Program& program, const std::vector<Binding>& bindings) {
  return Reflection(program, bindings, 0).holds() && Reflection(program, bindings, 1).holds();
}

}  // namespace brdf::shader
