#include "prove/shader/on_box.h"

#include <algorithm>

#include "prove/scalar/on_box.h"
#include "prove/shader/number_op.h"
#include "prove/shader/way.h"
#include "shader/program/operands.h"

namespace brdf::prove {
namespace {

using shader::Axis;
using shader::Binding;
using shader::End;
using shader::Op;
using shader::Program;
using shader::Step;

constexpr int kMostWays = 64;
constexpr std::size_t kMostSteps = 100'000;

// A coordinate over its vector's length; the sum, the root and the division round.
template <class B>
Interval<B> of_unit(const Interval<B>& x) {
  constexpr double kMost = 1 + 16 * Interval<B>::kUnit;
  return x.poisoned() ? x : cut(x, -kMost, kMost);
}

template <class B>
class ShaderOnBox {
 public:
  using I = Interval<B>;
  ShaderOnBox(const shader::Function& f, const ShaderInputs& inputs)
      : program_(f.program<B>()), start_(program_) {
    const Vec3<I> wi = direction<I>(inputs.cos_i, inputs.turn_i),
                  wo = direction<I>(inputs.cos_o, inputs.turn_o);
    fill(f, inputs, wi, wo);
  }

  // The hull of all ways; poison where one of them is.
  I run() {
    std::vector<std::pair<Way<B>, std::uint32_t>> left;
    left.emplace_back(std::move(start_), 0);
    I result;
    for (int ways = 0; !left.empty(); ++ways) {
      auto [way, at] = std::move(left.back());
      left.pop_back();
      if (ways >= kMostWays || !follow(way, at, left)) return I::poison();
      for (std::size_t k = 0; k < program_.results.size(); ++k) {
        const I value = way.numbers[program_.results[k]];
        if (value.poisoned()) return I::poison();
        result = ways == 0 && k == 0 ? value : hull(result, value);
      }
    }
    return result;
  }

 private:
  void fill(const shader::Function& f, const ShaderInputs& inputs, const Vec3<I>& wi, const Vec3<I>& wo) {
    const Vec3<I> h = half(wi, wo);
    for (const Binding& b : f.bound<B>()) {
      if (b.integer) {
        const Bounds v = b.from == Binding::From::value ? inputs.values[b.value] : Bounds{1, 1};
        const bool zero = b.from == Binding::From::zero;
        const std::uint32_t least = shader::integer_of(b, double(B(v.lo))),
                            most = shader::integer_of(b, double(B(v.hi)));
        start_.write_integer(b.slot, zero ? 0 : least, !zero && least != most);
      } else {
        start_.write(b.slot, input(b, inputs, wi, wo, h));
      }
    }
  }
  // As Runner::set_directions gives it (shader/function.h).
  static I input(const Binding& b, const ShaderInputs& inputs, const Vec3<I>& wi, const Vec3<I>& wo,
                 const Vec3<I>& h) {
    const auto axis = [&](Axis a) -> std::array<I, 3> {
      const Vec3<I>& v = a == Axis::light ? wi : a == Axis::view ? wo : h;
      if (a == Axis::tangent) return {I(1), I(), I()};
      if (a == Axis::bitangent) return {I(), I(1), I()};
      if (a == Axis::normal) return {I(), I(), I(1)};
      return {v.x, v.y, v.z};
    };
    switch (b.from) {
      case Binding::From::value:
        return I::of(double(B(inputs.values[b.value].lo)), double(B(inputs.values[b.value].hi)));
      case Binding::From::coordinate:
        return axis(b.a)[std::size_t(b.component)];
      case Binding::From::product: {
        if (b.a == b.b) return I(1);
        const auto x = axis(b.a), y = axis(b.b);
        const bool facing =
            (b.a == Axis::half) != (b.b == Axis::half);  // beside the light or the viewer: |h|/2
        const bool upward = b.a == Axis::normal || b.b == Axis::normal;
        return cut(x[0] * y[0] + x[1] * y[1] + x[2] * y[2], facing || upward ? 0.0 : -1.0, 1.0);
      }
      case Binding::From::one:
        return I(1);
      case Binding::From::zero:
        break;
    }
    return I();
  }
  static Vec3<I> half(const Vec3<I>& wi, const Vec3<I>& wo) {
    const Vec3<I> h = wi + wo;
    const I length = sqrt(square(h.x) + square(h.y) + square(h.z));
    const auto over = [&](const I& x, double low) {
      const I q = x / length;
      return q.poisoned() ? I::of(low, 1) : cut(q, std::max(low, -1.0), 1.0);
    };
    return {over(h.x, -1), over(h.y, -1), over(h.z, 0)};
  }

  // To the end; ways that part on the way are put to the others. False: too long.
  bool follow(Way<B>& way, std::uint32_t at, std::vector<std::pair<Way<B>, std::uint32_t>>& left) {
    for (;;) {
      const shader::Stretch& stretch = program_.stretches[at];
      for (const Step& s : stretch.steps) apply(way, s);
      way.steps += stretch.steps.size() + 1;
      if (way.steps > kMostSteps || left.size() > std::size_t(kMostWays)) return false;
      if (stretch.end == End::stop) return true;
      bool holds = true;
      if (stretch.end == End::branch) {
        holds = way.integers[stretch.condition] != 0;
        if (way.open[stretch.condition]) {
          left.emplace_back(way, stretch.next[1]);
          left.back().first.suppose(stretch.condition, false);
          holds = true;
          way.suppose(stretch.condition, true);
        }
      }
      at = stretch.next[holds ? 0 : 1];
    }
  }

  void apply(Way<B>& w, const Step& s) {
    if (s.op == Op::select) {
      const I yes = w.numbers[s.b], no = w.numbers[s.c];
      const bool first = w.integers[s.a] != 0;
      w.write(s.r, w.open[s.a] ? hull(yes, no) : first ? yes : no);
    } else if (s.op < Op::select) {
      apply_numbers(w, s);
    } else if (s.op <= Op::less_equal_or) {
      const Tri t = compared<B>(s.op, w.numbers[s.a], w.numbers[s.b]);
      const bool poison = w.numbers[s.a].poisoned() || w.numbers[s.b].poisoned();
      w.write_integer(s.r, t == Tri::yes, poison || t == Tri::maybe);
      if (poison) return;
      w.said[s.r] = {s.op, s.a, s.b, false};
      w.tell_of(s.a);
      w.tell_of(s.b);
    } else if (s.op == Op::is_nan || s.op == Op::is_inf) {
      w.write_integer(s.r, 0, w.numbers[s.a].poisoned());
    } else if (s.op == Op::to_signed || s.op == Op::to_unsigned) {
      const I x = w.numbers[s.a];
      const std::uint32_t least = shader::detail::to_integer(x.lo, s.op),
                          most = shader::detail::to_integer(x.hi, s.op);
      w.write_integer(s.r, least, x.poisoned() || least != most);
    } else if (s.op == Op::from_signed || s.op == Op::from_unsigned) {
      const std::uint32_t x = w.integers[s.a];
      const double value = s.op == Op::from_signed ? double(std::int32_t(x)) : double(x);
      w.write(s.r, w.open[s.a] ? I::poison() : I(double(B(value))));
    } else if (s.op == Op::load_number) {
      load(w, s);
    } else if (s.op == Op::store_number) {
      store(w, s);
    } else {
      apply_integers(w, s);
    }
  }

  void apply_numbers(Way<B>& w, const Step& s) {
    const int count = shader::operands_of(s.op).count;
    const auto number = [&](int k, std::uint32_t slot) -> const I& {
      return k < count ? w.numbers[slot] : none_;
    };
    const I &a = number(0, s.a), &b = number(1, s.b), &c = number(2, s.c);
    const std::uint32_t root_a = count > 0 ? w.root[s.a] : 0, root_b = count > 1 ? w.root[s.b] : ~0u;
    // The same number twice is one number.
    I value = *number_op<B>(s.op, a, root_a == root_b ? a : b, c);
    const Squares none;
    const Squares &sa = count > 0 ? w.squares[s.a] : none, &sb = count > 1 ? w.squares[s.b] : none;
    using Kind = Squares::Kind;
    if (s.op == Op::div && sb.kind == Kind::length && sb.of.contains(root_a)) value = of_unit(value);
    if (s.op == Op::mul && sb.kind == Kind::inverse && sb.of.contains(root_a)) value = of_unit(value);
    if (s.op == Op::mul && sa.kind == Kind::inverse && sa.of.contains(root_b)) value = of_unit(value);
    const Squares squares = squares_of(s, sa, sb, root_a, root_b);
    w.write(s.r, value);
    if (!squares.of.contains(s.r)) w.squares[s.r] = squares;
    for (const std::uint32_t slot : w.squares[s.r].of) w.tell_of(slot);
    if (s.op != Op::copy || root_a == s.r) return;
    w.root[s.r] = root_a;
    w.tell_of(root_a);
  }

  void load(Way<B>& w, const Step& s) {
    I value = w.numbers[s.a + std::min(w.integers[s.b], s.c - 1)];
    for (std::uint32_t k = 0; w.open[s.b] && k < s.c; ++k)
      value = k ? hull(value, w.numbers[s.a + k]) : w.numbers[s.a];
    w.write(s.r, value);
  }
  void store(Way<B>& w, const Step& s) {
    const I value = w.numbers[s.a];
    if (!w.open[s.b]) return w.write(s.r + std::min(w.integers[s.b], s.c - 1), value);
    for (std::uint32_t k = 0; k < s.c; ++k) w.write(s.r + k, hull(w.numbers[s.r + k], value));
  }

  // By the interpreter itself, where all operands are known.
  void apply_integers(Way<B>& w, const Step& s) {
    const auto value = [&](std::uint32_t slot) { return w.integers[slot]; };
    const shader::Operands o = shader::operands_of(s.op);
    const bool moves = s.op == Op::load_integer || s.op == Op::store_integer;
    const std::uint32_t slots[] = {s.a, s.b, s.c};
    bool open = false;
    for (int k = 0; k < o.count && !moves; ++k) open = open || w.open[slots[k]];
    if (moves) return move_integers(w, s);
    const Comparison before = w.said[s.a];
    if (s.op == Op::iand && open) {
      const bool none = (!w.open[s.a] && value(s.a) == 0) || (!w.open[s.b] && value(s.b) == 0);
      return w.write_integer(s.r, 0, !none);
    }
    if (open) {
      w.write_integer(s.r, 0, true);
    } else {
      scratch_.set_integer(0, value(s.a));
      scratch_.set_integer(1, o.count > 1 ? value(s.b) : 0);
      scratch_.set_integer(2, o.count > 2 ? value(s.c) : 0);
      shader::detail::run_step(Step{s.op, 3, 0, 1, 2, s.line}, scratch_, shader::AllLanes<1>{});
      w.write_integer(s.r, *scratch_.integer(3), false);
    }
    if (s.op == Op::icopy) w.said[s.r] = before;
    if (s.op == Op::logical_not && before.op != Op::copy)
      w.said[s.r] = {before.op, before.a, before.b, !before.negated};
  }
  void move_integers(Way<B>& w, const Step& s) {
    const bool stores = s.op == Op::store_integer;
    const std::uint32_t at = std::min(w.integers[s.b], s.c - 1);
    if (!w.open[s.b]) {
      const std::uint32_t from = stores ? s.a : s.a + at;
      return w.write_integer(stores ? s.r + at : s.r, w.integers[from], w.open[from]);
    }
    for (std::uint32_t k = 0; k < (stores ? s.c : 1); ++k) w.write_integer(s.r + k, 0, true);
  }

  static shader::Program four_integers() {
    Program p;
    p.integers = 4;
    return p;
  }

  const Program& program_;
  Way<B> start_;
  I none_;
  shader::Bank<double, 1> scratch_{four_integers()};
};

template <class B>
Interval<B> without_cosine(shader::Returns returns, const Interval<B>& value, const Interval<B>& cos_i,
                           const Interval<B>& cos_o) {
  using shader::Returns;
  const Interval<B> least(kMinCosine<B>);
  if (returns == Returns::f) return value;
  return value / larger(returns == Returns::f_cos_i ? cos_i : cos_o, least);
}

}  // namespace

std::string unknown_operation(const Program& program) {
  const Interval<double> x(0.5);
  for (const shader::Stretch& stretch : program.stretches)
    for (const Step& s : stretch.steps) {
      const std::string where = s.line > 0 ? " in line " + std::to_string(s.line) : "";
      if (s.op < Op::select && !number_op<double>(s.op, x, x, x))
        return "a function that intervals do not know" + where;
      if (s.op == Op::bits_of || s.op == Op::from_bits) return "an operation on the bits of a float" + where;
    }
  return "";
}

template <class B>
Bounds shader_on_box(const shader::Function& function, const ShaderInputs& inputs) {
  using I = Interval<B>;
  const I value = ShaderOnBox<B>(function, inputs).run();
  const auto cosine = [](Bounds c) { return I::widened(c.lo, c.hi, 2); };
  const I r = without_cosine<B>(function.returns, value, cosine(inputs.cos_i), cosine(inputs.cos_o));
  return {r.lo, r.hi};
}

template Bounds shader_on_box<float>(const shader::Function&, const ShaderInputs&);
template Bounds shader_on_box<double>(const shader::Function&, const ShaderInputs&);

}  // namespace brdf::prove
