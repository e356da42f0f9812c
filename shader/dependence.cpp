#include "shader/dependence.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "shader/program/flow.h"

namespace brdf::shader {
namespace {

constexpr std::size_t kBits = 64;

// Calls look(binding, index of the parameter, component of the colour) for each bound parameter.
template <class Look>
void for_each_parameter(const Function& f, const std::vector<Binding>& bindings, Look&& look) {
  for (const Binding& b : bindings) {
    if (b.from != Binding::From::value) continue;
    for (std::size_t k = 0; k < f.parameters.size(); ++k) {
      const Parameter& p = f.parameters[k];
      if (b.value >= p.first && b.value < p.first + (p.colour ? 3 : 1)) look(b, k, b.value - p.first);
    }
  }
}

// The components of colours on which a value depends, as bits.
struct Channels {
  using Value = std::uint8_t;
  static Value join(Value a, Value b) { return a | b; }
  static Value element(Value all, Value index) { return all | index; }
  static bool branch(Value) { return true; }
  static Value controlled(Value written, Value condition) { return written | condition; }
  static Value step(const Step&, const Operation& o, const Value* operands) {
    return std::accumulate(operands, operands + o.count(), Value(0), join);
  }
};

Mixing mixing_of(const Function& f, const Program& program, const std::vector<Binding>& bindings) {
  Channels domain;
  Flow flow(program, domain);
  for_each_parameter(f, bindings, [&](const Binding& b, std::size_t k, std::size_t component) {
    if (f.parameters[k].colour) flow.start(b.integer, b.slot) = Channels::Value(1u << component);
  });
  if (!flow.run()) return Mixing::all;
  Mixing out = Mixing::none;
  for (std::size_t k = 0; k < flow.results().size(); ++k) {
    const unsigned others = flow.results()[k] & ~(1u << k);
    out = std::max(out, others == 0 ? Mixing::none : others == 1 ? Mixing::first : Mixing::all);
  }
  return out;
}

// How a value depends on the parameters.
struct Degree {
  std::uint64_t depends = 0, nonlinear = 0;  // nonlinear: not as a straight line
  int copy_of = -1;                          // the parameter that the value is
  double constant = std::numeric_limits<double>::quiet_NaN();
  bool reached = false;

  friend bool operator==(const Degree& a, const Degree& b) {
    return a.depends == b.depends && a.nonlinear == b.nonlinear && a.copy_of == b.copy_of &&
           a.reached == b.reached && same_constant(a, b);
  }
  static bool same_constant(const Degree& a, const Degree& b) {
    return a.constant == b.constant || (std::isnan(a.constant) && std::isnan(b.constant));
  }
};

class DegreeDomain {
 public:
  using Value = Degree;
  explicit DegreeDomain(const Function& f) : joint(std::min(f.parameters.size(), kBits)), f_(f) {}

  std::vector<std::uint64_t> joint;  // for each parameter those that a product with it depends on

  static Degree join(const Degree& a, const Degree& b) {
    if (!a.reached || !b.reached) return a.reached ? a : b;
    Degree out = sum(a, b);
    if (a.copy_of == b.copy_of) out.copy_of = a.copy_of;
    if (Degree::same_constant(a, b)) out.constant = a.constant;
    return out;
  }
  static Degree element(const Degree& all, const Degree& index) { return controlled(all, index); }
  static bool branch(const Degree&) { return true; }
  static Degree controlled(Degree written, const Degree& condition) {
    if (condition.depends == 0) return written;
    written.depends |= condition.depends;
    written.nonlinear |= condition.depends;
    written.copy_of = -1;
    return written;
  }
  Degree step(const Step& x, const Operation& o, const Degree* v) {
    switch (x.op) {
      case Op::copy:
      case Op::icopy:
        return v[0];
      case Op::neg:
        return sum(v[0], Degree{});
      case Op::add:
      case Op::sub:
        return sum(v[0], v[1]);
      case Op::mul:
        return product(v[0], v[1]);
      case Op::div:
        return sum(v[0], nonlinear(v[1]));
      case Op::fma:
        return sum(product(v[0], v[1]), v[2]);
      case Op::mix:
        return product(sum(v[0], v[1]), v[2]);
      case Op::select:
        return sum(sum(v[1], v[2]), nonlinear(v[0]));
      case Op::abs:
        return least(v[0]) >= 0 ? v[0] : nonlinear(v[0]);
      case Op::max:
        if (least(v[0]) >= v[1].constant) return v[0];
        if (least(v[1]) >= v[0].constant) return v[1];
        return nonlinear(sum(v[0], v[1]));
      case Op::min:
        if (largest(v[0]) <= v[1].constant) return v[0];
        if (largest(v[1]) <= v[0].constant) return v[1];
        return nonlinear(sum(v[0], v[1]));
      case Op::clamp:
        if (least(v[0]) >= v[1].constant && largest(v[0]) <= v[2].constant) return v[0];
        return nonlinear(sum(sum(v[0], v[1]), v[2]));
      default:
        break;
    }
    if (o.compares != Operation::Compares::no && (is_settled(v[0], v[1]) || is_settled(v[1], v[0])))
      return {.reached = true};
    Degree all{.reached = true};
    for (int k = 0; k < o.count(); ++k) all = sum(all, v[k]);
    return nonlinear(all);
  }

 private:
  static Degree sum(const Degree& a, const Degree& b) {
    return {.depends = a.depends | b.depends, .nonlinear = a.nonlinear | b.nonlinear, .reached = true};
  }
  static Degree nonlinear(Degree a) {
    a.nonlinear = a.depends;
    a.copy_of = -1;
    return a;
  }
  Degree product(const Degree& a, const Degree& b) {
    for (std::size_t k = 0; k < joint.size(); ++k) {
      if (a.depends >> k & 1) joint[k] |= b.depends;
      if (b.depends >> k & 1) joint[k] |= a.depends;
    }
    Degree out = sum(a, b);
    out.nonlinear |= a.depends & b.depends;
    return out;
  }
  // The range of a value that is a parameter; no number otherwise.
  double least(const Degree& v) const {
    return v.copy_of < 0 ? kNone : f_.parameters[std::size_t(v.copy_of)].min;
  }
  double largest(const Degree& v) const {
    return v.copy_of < 0 ? kNone : f_.parameters[std::size_t(v.copy_of)].max;
  }
  // Returns whether a comparison of a parameter with a constant has one outcome between the ends of its
  // range.
  bool is_settled(const Degree& v, const Degree& limit) const {
    return limit.constant <= least(v) || limit.constant >= largest(v);
  }

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const Function& f_;
};

// What a value is when some parameters are 0.
enum class Vanishing : std::uint8_t { unreached, zero, positive, unknown };

struct VanishingDomain {
  using Value = Vanishing;
  static Value join(Value a, Value b) {
    if (a == Value::unreached || b == Value::unreached) return a == Value::unreached ? b : a;
    return a == b ? a : Value::unknown;
  }
  static Value element(Value all, Value) { return all; }
  static bool branch(Value) { return true; }
  static Value controlled(Value written, Value) { return written; }
  static Value step(const Step& x, const Operation&, const Value* v) {
    const auto zero = [&](int k) { return v[k] == Value::zero; };
    const auto when = [](bool is) { return is ? Value::zero : Value::unknown; };
    switch (x.op) {
      case Op::copy:
        return v[0];
      case Op::neg:
      case Op::abs:
      case Op::sign:
      case Op::floor:
      case Op::trunc:
      case Op::sqrt:
      case Op::sin:
        return when(zero(0));
      case Op::add:
      case Op::sub:
      case Op::max:
        return when(zero(0) && zero(1));
      case Op::mul:
        return when(zero(0) || zero(1));
      case Op::div:
        return when(zero(0));
      case Op::min:
        return when((zero(0) && (zero(1) || v[1] == Value::positive)) ||
                    (zero(1) && v[0] == Value::positive));
      case Op::clamp:
        return when(zero(0) && zero(1) && v[2] == Value::positive);
      case Op::fma:
        return when((zero(0) || zero(1)) && zero(2));
      case Op::mix:
        return when(zero(0) && zero(1));
      case Op::select:
        return join(v[1], v[2]);
      default:
        return Value::unknown;
    }
  }
};

// Which slots hold equal values on every path, if equal components of colours are given. A class of equal
// slots is named by its first slot.
class Equal {
 public:
  Equal(const Function& f, const Program& p, const std::vector<Binding>& bindings)
      : p_(p), begins_(p.stretches.size()) {
    State start(std::size_t(p.numbers) + p.integers);
    std::iota(start.begin(), start.end(), 0u);
    std::map<std::uint64_t, std::uint32_t> constants;
    for (const Program::Constant& c : p.constants)
      start[c.slot] = constants.try_emplace(std::bit_cast<std::uint64_t>(c.value), c.slot).first->second;
    std::map<std::size_t, std::uint32_t> parameters;
    for_each_parameter(f, bindings, [&](const Binding& b, std::size_t k, std::size_t) {
      const std::uint32_t slot = index(b.integer, b.slot);
      start[slot] = parameters.try_emplace(2 * k + b.integer, slot).first->second;
    });
    begins_[0] = canonical(start);
  }

  // Returns whether all results are equal at every end of the program.
  bool holds() {
    return until_unchanged(begins_, changed_, [&](std::size_t k) { return pass(k); });
  }

 private:
  using State = std::vector<std::uint32_t>;
  using Key = std::vector<std::uint32_t>;

  std::uint32_t index(bool integer, std::uint32_t slot) const { return integer ? p_.numbers + slot : slot; }
  // Names each class by its first slot.
  static State canonical(const State& classes) {
    State out(classes.size());
    std::map<std::uint32_t, std::uint32_t> first;
    for (std::size_t k = 0; k < classes.size(); ++k)
      out[k] = first.try_emplace(classes[k], std::uint32_t(k)).first->second;
    return out;
  }

  bool pass(std::size_t which) {
    State s = begins_[which];
    const Stretch& stretch = p_.stretches[which];
    std::map<Key, std::uint32_t> values;
    std::uint32_t next = std::uint32_t(s.size());  // classes of values that the stretch computes
    const auto value = [&](const Key& key) {
      const auto [at, is_new] = values.try_emplace(key, next);
      next += is_new;
      return at->second;
    };
    for (const Step& step : stretch.steps) follow(s, step, value);
    if (stretch.end == End::stop)
      return std::ranges::all_of(p_.results, [&](std::uint32_t slot) { return s[slot] == s[p_.results[0]]; });
    for (int k = 0; k < (stretch.end == End::branch ? 2 : 1); ++k) meet(s, stretch.next[k]);
    return true;
  }
  template <class Value>
  void follow(State& s, const Step& x, Value&& value) const {
    const Operation& o = operation(x.op);
    const std::uint32_t slots[] = {x.a, x.b, x.c};
    Key key{std::uint32_t(x.op), x.op == Op::texel ? x.c : 0};
    for (int k = 0; k < o.count(); ++k) {
      const std::uint32_t width = k == 0 && o.loads() ? x.c : 1;
      for (std::uint32_t j = 0; j < width; ++j) key.push_back(s[index(o.reads_integer(k), slots[k] + j)]);
    }
    const std::uint32_t r = index(o.writes_integer(), x.r);
    if (x.op == Op::copy || x.op == Op::icopy) {
      s[r] = key[2];
      return;
    }
    if (!o.stores()) {
      s[r] = value(key);
      return;
    }
    for (std::uint32_t k = 0; k < x.c; ++k) {
      Key element = key;
      element.insert(element.end(), {k, s[r + k]});
      s[r + k] = value(element);
    }
  }
  // Slots are equal at the begin of a stretch if they are equal on all ways to it.
  void meet(const State& from, std::uint32_t target) {
    State& to = begins_[target];
    if (to.empty()) {
      to = canonical(from);
      changed_ = true;
      return;
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
    State both(to.size());
    for (std::size_t k = 0; k < to.size(); ++k)
      both[k] = first.try_emplace({to[k], from[k]}, std::uint32_t(k)).first->second;
    if (both == to) return;
    to = std::move(both);
    changed_ = true;
  }

  const Program& p_;
  std::vector<State> begins_;
  bool changed_ = false;
};

}  // namespace

Mixing mixing_of(const Function& f) {
  return std::max(mixing_of(f, f.as_written, f.bindings), mixing_of(f, f.as_meant, f.bindings_as_meant));
}

bool same_in_all_channels(const Function& f) {
  return f.as_meant.results.size() == 1 ||
         (Equal(f, f.as_written, f.bindings).holds() && Equal(f, f.as_meant, f.bindings_as_meant).holds());
}

bool Degrees::is_affine(std::size_t parameter) const {
  return parameter < kBits && !(nonlinear >> parameter & 1);
}

bool Degrees::is_separate(std::size_t a, std::size_t b) const {
  return is_affine(a) && is_affine(b) && !(joint[a] >> b & 1);
}

Degrees degrees_of(const Function& f) {
  DegreeDomain domain(f);
  Flow flow(f.as_meant, domain);
  const auto reached = [](Degree d) {
    d.reached = true;
    return d;
  };
  for (std::uint32_t k = 0; k < f.as_meant.numbers; ++k) flow.start(false, k) = reached({});
  for (std::uint32_t k = 0; k < f.as_meant.integers; ++k) flow.start(true, k) = reached({});
  for (const Program::Constant& c : f.as_meant.constants)
    flow.start(false, c.slot) = reached({.constant = c.value});
  for_each_parameter(f, f.bindings_as_meant, [&](const Binding& b, std::size_t k, std::size_t) {
    if (k < kBits)
      flow.start(b.integer, b.slot) = reached({.depends = std::uint64_t(1) << k, .copy_of = int(k)});
  });
  Degrees out;
  if (!flow.run()) return out;
  out.nonlinear = 0;
  for (const Degree& result : flow.results()) out.nonlinear |= result.nonlinear;
  out.joint = std::move(domain.joint);
  return out;
}

bool vanishes_with(const Function& f, const std::vector<std::size_t>& parameters) {
  const Program& p = f.as_meant;
  VanishingDomain domain;
  Flow flow(p, domain);
  for (std::uint32_t k = 0; k < p.numbers; ++k) flow.start(false, k) = Vanishing::unknown;
  for (std::uint32_t k = 0; k < p.integers; ++k) flow.start(true, k) = Vanishing::unknown;
  for (const Program::Constant& c : p.constants)
    flow.start(false, c.slot) = c.value == 0  ? Vanishing::zero
                                : c.value > 0 ? Vanishing::positive
                                              : Vanishing::unknown;
  for (const Binding& b : f.bindings_as_meant)
    if (b.from == Binding::From::zero && !b.integer) flow.start(false, b.slot) = Vanishing::zero;
  for_each_parameter(f, f.bindings_as_meant, [&](const Binding& b, std::size_t k, std::size_t) {
    if (!b.integer && std::ranges::find(parameters, k) != parameters.end())
      flow.start(false, b.slot) = Vanishing::zero;
  });
  return flow.run() && std::all_of(flow.results().begin(), flow.results().end(),
                                   [](Vanishing v) { return v == Vanishing::zero; });
}

}  // namespace brdf::shader
