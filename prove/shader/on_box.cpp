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
using shader::Undefined;

constexpr int kMostWays = 64;
constexpr std::size_t kMostSteps = 100'000;

// A coordinate over its vector's length; the sum, the root and the division round.
template <class B>
Interval<B> of_unit(const Interval<B>& x) {
  constexpr double kMost = 1 + 16 * Interval<B>::kUnit;
  return x.poisoned() ? x : cut(x, -kMost, kMost);
}

// What may be undefined of an operation on numbers of these ranges.
template <class B>
std::optional<Undefined> undefined_number(const Step& s, const Way<B>& w) {
  const auto holds_zero = [&](std::uint32_t slot) {
    return w.numbers[slot].lo <= 0 && w.numbers[slot].hi >= 0;
  };
  const auto poisoned = [&](std::uint32_t slot) { return w.numbers[slot].poisoned(); };
  switch (s.op) {
    case Op::pow:
      if (poisoned(s.a) || poisoned(s.b)) return std::nullopt;
      if (w.numbers[s.a].lo < 0 || (holds_zero(s.a) && w.numbers[s.b].lo <= 0)) return Undefined::pow;
      return std::nullopt;
    case Op::atan2:
      return holds_zero(s.a) && holds_zero(s.b) ? std::optional(Undefined::atan) : std::nullopt;
    case Op::smoothstep:
      return w.numbers[s.a].hi < w.numbers[s.b].lo ? std::nullopt : std::optional(Undefined::smoothstep);
    case Op::min:
      if (s.c > 0 && !(w.numbers[s.c - 1].hi <= w.numbers[s.b].lo)) return Undefined::clamp;
      [[fallthrough]];
    case Op::max:
      return poisoned(s.a) || poisoned(s.b) ? std::optional(Undefined::min_max) : std::nullopt;
    default:
      return std::nullopt;
  }
}

template <class B>
class ShaderOnBox {
 public:
  using I = Interval<B>;
  ShaderOnBox(const shader::Function& f, const ShaderInputs& inputs)
      : program_(f.program<B>()), symmetry_(f.turning<B>()), start_(program_) {
    const Vec3<I> wi = direction<I>(inputs.cos_i, inputs.turn_i),
                  wo = direction<I>(inputs.cos_o, inputs.turn_o);
    // A symmetry stands for the other turns where only one is asked for.
    turns_ = symmetry_.isotropic && inputs.turn_i.lo == inputs.turn_i.hi;
    fill(f, inputs, wi, wo);
  }

  // The hull of all ways; poison where one of them is, or where the result may be undefined.
  I run() {
    std::vector<std::pair<Way<B>, std::uint32_t>> left;
    left.emplace_back(std::move(start_), 0);
    I result;
    for (int ways = 0; !left.empty(); ++ways) {
      auto [way, at] = std::move(left.back());
      left.pop_back();
      if (ways >= kMostWays || !follow(way, at, left)) return I::poison();
      for (std::size_t k = 0; k < program_.results.size(); ++k) {
        const std::uint32_t slot = program_.results[k];
        const I value = way.numbers[slot];
        if (way.undefined[slot] > 0) found_ = reasons_[way.undefined[slot] - 1];
        if (found_ && found_->line == 0) found_->line = program_.line;
        if (value.poisoned()) return I::poison();
        result = ways == 0 && k == 0 ? value : hull(result, value);
      }
    }
    return result;
  }
  // What the result may depend on that is undefined.
  const std::optional<shader::UndefinedValue>& undefined() const { return found_; }

 private:
  void fill(const shader::Function& f, const ShaderInputs& inputs, const Vec3<I>& wi, const Vec3<I>& wo) {
    const Vec3<I> h = half(wi, wo);
    for (const Binding& b : f.bound<B>()) {
      if (b.integer) {
        const Bounds v = b.from == Binding::From::value ? inputs.values[b.value] : Bounds{1, 1};
        const bool zero = b.from == Binding::From::zero;
        const std::int64_t least = std::int32_t(shader::integer_of(b, double(B(v.lo)))),
                           most = std::int32_t(shader::integer_of(b, double(B(v.hi))));
        start_.write_integer(b.slot, zero ? Whole{} : Whole{least, most});
      } else {
        start_.write(b.slot, input(b, inputs, wi, wo, h));
        if (turns_ && across_normal(b)) start_.set_magnitude(b.slot, 1 + 8 * I::kUnit);
      }
    }
  }
  // A coordinate that changes when light and viewer turn together.
  static bool lies(Axis a) { return a == Axis::tangent || a == Axis::bitangent; }
  static bool across_normal(const Binding& b) {
    const auto moves = [](Axis a) { return a == Axis::light || a == Axis::view || a == Axis::half; };
    if (b.from == Binding::From::coordinate) return moves(b.a) && b.component < 2;
    return b.from == Binding::From::product && ((moves(b.a) && lies(b.b)) || (moves(b.b) && lies(b.a)));
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
        const I sum = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        // A coordinate, or a sum that rounds otherwise at other turns than the one that was asked for.
        return cut(lies(b.a) || lies(b.b) || upward ? sum : widened_by(sum, 8 * I::kUnit),
                   facing || upward ? 0.0 : -1.0, 1.0);
      }
      case Binding::From::one:
        return I(1);
      case Binding::From::zero:
        break;
    }
    return I();
  }
  static I widened_by(const I& x, double by) { return x.poisoned() ? x : I::of(x.lo - by, x.hi + by); }
  static Vec3<I> half(const Vec3<I>& wi, const Vec3<I>& wo) {
    const Vec3<I> h = wi + wo;
    const I length = sqrt(square(h.x) + square(h.y) + square(h.z));
    const auto over = [&](const I& x, double low) {
      const I q = x / length;
      return q.poisoned() ? I::of(low, 1) : cut(q, std::max(low, -1.0), 1.0);
    };
    return {over(h.x, -1), over(h.y, -1), over(h.z, 0)};
  }

  // To the end; ways that part on the way are put to the others. False: too long, or it depends on what is undefined.
  bool follow(Way<B>& way, std::uint32_t at, std::vector<std::pair<Way<B>, std::uint32_t>>& left) {
    for (;;) {
      const shader::Stretch& stretch = program_.stretches[at];
      for (std::size_t k = 0; k < stretch.steps.size(); ++k) {
        apply(way, stretch.steps[k]);
        if (turns_) turn(way, stretch.steps[k], symmetry_.steps[at][k]);
      }
      way.steps += stretch.steps.size() + 1;
      if (way.steps > kMostSteps || left.size() > std::size_t(kMostWays)) return false;
      if (stretch.end == End::stop) return true;
      bool holds = true;
      if (stretch.end == End::branch) {
        if (const std::uint32_t reason = way.undefined_integers[stretch.condition]; reason > 0) {
          found_ = reasons_[reason - 1];
          return false;
        }
        holds = !(way.integers[stretch.condition] == Whole{0, 0});
        if (!way.integers[stretch.condition].known()) {
          left.emplace_back(way, stretch.next[1]);
          left.back().first.suppose(stretch.condition, false);
          way.suppose(stretch.condition, true);
        }
      }
      at = stretch.next[holds ? 0 : 1];
    }
  }

  // The reason of an operand, placed at this step where it names no line yet; else the step's own.
  std::uint32_t placed(std::uint32_t reason, const Step& s) {
    if (reason == 0 || reasons_[reason - 1].line > 0 || s.op == Op::copy || s.op == Op::icopy) return reason;
    reasons_.push_back({reasons_[reason - 1].why, s.line, {}});
    return std::uint32_t(reasons_.size());
  }
  std::uint32_t reason_of(const Way<B>& w, const Step& s, std::optional<Undefined> own) {
    const shader::Operands o = shader::operands_of(s.op);
    const std::uint32_t slots[] = {s.a, s.b, s.c};
    for (int k = 0; k < o.count; ++k)
      if (const std::uint32_t r = (o.integer[k] ? w.undefined_integers : w.undefined)[slots[k]]; r > 0)
        return placed(r, s);
    if (!own) return 0;
    reasons_.push_back({*own, s.line, {}});
    return std::uint32_t(reasons_.size());
  }

  void apply(Way<B>& w, const Step& s) {
    if (s.op == Op::select) {
      const std::uint32_t condition = w.undefined_integers[s.a];
      if (condition > 0) return w.write(s.r, I::poison(), placed(condition, s));
      const I yes = w.numbers[s.b], no = w.numbers[s.c];
      const Whole truth = w.integers[s.a];
      const bool open = !truth.known(), first = truth.bits() != 0;
      const std::uint32_t reason = (open || first) && w.undefined[s.b] > 0    ? w.undefined[s.b]
                                   : (open || !first) && w.undefined[s.c] > 0 ? w.undefined[s.c]
                                                                              : 0;
      w.write(s.r, open ? hull(yes, no) : first ? yes : no, placed(reason, s));
    } else if (s.op < Op::select) {
      apply_numbers(w, s);
    } else if (s.op <= Op::less_equal_or) {
      const Tri t = compared<B>(s.op, w.numbers[s.a], w.numbers[s.b]);
      const bool poison = w.numbers[s.a].poisoned() || w.numbers[s.b].poisoned();
      const bool open = poison || t == Tri::maybe;
      w.write_integer(s.r, open ? Whole::truth() : Whole{t == Tri::yes, t == Tri::yes}, reason_of(w, s, {}));
      if (poison) return;
      w.said[s.r] = {s.op, s.a, s.b, false};
      w.tell_of(s.a);
      w.tell_of(s.b);
    } else if (s.op == Op::is_nan || s.op == Op::is_inf) {
      w.write_integer(s.r, w.numbers[s.a].poisoned() ? Whole::truth() : Whole{0, 0}, reason_of(w, s, {}));
    } else if (s.op == Op::to_signed || s.op == Op::to_unsigned) {
      to_integer(w, s);
    } else if (s.op == Op::from_signed || s.op == Op::from_unsigned) {
      const Whole x = w.integers[s.a];
      const bool wraps = s.op == Op::from_unsigned && x.lo < 0;
      const double low = wraps ? x.known() ? double(x.bits()) : 0 : double(x.lo),
                   high = wraps ? x.known() ? low : 4294967295.0 : double(x.hi);
      w.write(s.r, I::of(double(B(low)), double(B(high))), reason_of(w, s, {}));
    } else if (s.op == Op::load_number || s.op == Op::load_integer) {
      load(w, s);
    } else if (s.op == Op::store_number || s.op == Op::store_integer) {
      store(w, s);
    } else {
      apply_integers(w, s);
    }
  }

  void to_integer(Way<B>& w, const Step& s) {
    const I x = w.numbers[s.a];
    const double least = s.op == Op::to_signed ? -2147483649.0 : -1,
                 most = s.op == Op::to_signed ? 2147483648.0 : 4294967296.0;
    const bool within = !x.poisoned() && least < x.lo && x.hi < most;
    const std::uint32_t reason =
        reason_of(w, s, within ? std::nullopt : std::optional(Undefined::conversion));
    if (!within) return w.write_integer(s.r, Whole::any(), reason);
    const Whole low = Whole::of_bits(shader::detail::to_integer(x.lo, s.op)),
                high = Whole::of_bits(shader::detail::to_integer(x.hi, s.op));
    w.write_integer(s.r, low.lo <= high.lo ? Whole{low.lo, high.lo} : Whole::any(), reason);
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
    const bool unit = of_length(s, sa, sb, root_a, root_b);
    if (unit) value = of_unit(value);
    Squares squares = squares_of(s, sa, sb, root_a, root_b);
    // Squares that may be subnormal have few digits, and a GPU may take them for 0: their root is no length.
    if ((s.op == Op::sqrt || s.op == Op::inverse_sqrt) && !(a.lo >= I::kSmallest)) squares = {};
    w.write(s.r, value, reason_of(w, s, undefined_number<B>(s, w)));
    if (!squares.of.contains(s.r)) w.squares[s.r] = squares;
    for (const std::uint32_t slot : w.squares[s.r].of) w.tell_of(slot);
    if (s.op != Op::copy || root_a == s.r) return;
    w.root[s.r] = root_a;
    w.tell_of(root_a);
  }
  // A coordinate over its vector's length.
  static bool of_length(const Step& s, const Squares& a, const Squares& b, std::uint32_t root_a,
                        std::uint32_t root_b) {
    using Kind = Squares::Kind;
    if (s.op == Op::div) return b.kind == Kind::length && b.of.contains(root_a);
    if (s.op != Op::mul) return false;
    return (b.kind == Kind::inverse && b.of.contains(root_a)) ||
           (a.kind == Kind::inverse && a.of.contains(root_b));
  }

  // At other turns than the one that was asked for a closing sum rounds otherwise.
  void turn(Way<B>& w, const Step& s, shader::Turning turning) {
    if (turning == shader::Turning::still || s.op > Op::less_equal_or) return;
    if (s.op > Op::select) return compare(w, s);
    if (turning == shader::Turning::partial) return w.set_magnitude(s.r, largest(w, s));
    I& value = w.numbers[s.r];
    if (value.poisoned()) return;
    const double roundings = 0.5 * (symmetry_.depth + 0.25) * I::kUnit;
    if (turning == shader::Turning::squares) {
      value = I::of(std::max(value.lo * (1 - roundings) - 8 * I::kTiny, 0.0),
                    value.hi * (1 + roundings) + 8 * I::kTiny);
    } else if (turning == shader::Turning::pairs) {
      const double error = roundings * std::max(w.most(s.a), w.most(s.b)) + 8 * I::kTiny;
      // A negative end comes from a product of two signs, which was widened by one unit already.
      const double known = value.lo < 0 ? -value.lo * I::kUnit * (1 - 4 * I::kUnit) : 0;
      value = I::of(value.lo - std::max(error - known, 0.0), value.hi + error);
    } else {
      value = widened_by(value, roundings * largest(w, s) + 8 * I::kTiny);
    }
  }
  // At another turn rounding may exchange two numbers that are close.
  void compare(Way<B>& w, const Step& s) {
    const double error = 0.5 * (symmetry_.depth + 2) * I::kUnit * (w.most(s.a) + w.most(s.b)) + 8 * I::kTiny;
    const I a = widened_by(w.numbers[s.a], error);
    const Tri t = compared<B>(s.op, a, w.numbers[s.b]);
    const bool open = a.poisoned() || w.numbers[s.b].poisoned() || t == Tri::maybe;
    if (open) w.write_integer(s.r, Whole::truth(), w.undefined_integers[s.r]);
  }
  // A bound of the absolute value of the step's result at every turn, of sums that of their terms.
  double largest(const Way<B>& w, const Step& s) const {
    constexpr double kUp = 1 + 16 * I::kUnit;
    const double a = w.most(s.a), b = s.op == Op::copy || s.op == Op::neg ? 0 : w.most(s.b);
    switch (s.op) {
      case Op::copy:
      case Op::neg:
        return a;
      case Op::add:
      case Op::sub:
        return (a + b) * kUp;
      case Op::mul:
        return a * b * kUp;
      case Op::fma:
        return (a * b + w.most(s.c)) * kUp;
      case Op::div: {
        const I& d = w.numbers[s.b];
        const double least = d.lo > 0 ? d.lo : d.hi < 0 ? -d.hi : 0;
        const bool unit = of_length(s, w.squares[s.a], w.squares[s.b], w.root[s.a], w.root[s.b]);
        return std::min(unit ? kUp : HUGE_VAL, least > 0 ? a / least * kUp : HUGE_VAL);
      }
      case Op::mix:
        return (a * (1 + w.most(s.c)) + b * w.most(s.c)) * kUp;
      case Op::select:
        return std::max(w.most(s.b), w.most(s.c));
      default:
        return HUGE_VAL;
    }
  }

  static std::int64_t limited(std::int64_t place, std::int64_t last) {
    return std::clamp(place, std::int64_t(0), last);
  }
  void load(Way<B>& w, const Step& s) {
    const bool whole = s.op == Op::load_integer;
    const Whole place = w.integers[s.b];
    const std::int64_t last = s.c - 1, from = limited(place.lo, last),
                       to = place.lo < 0 ? last : limited(place.hi, last);
    std::uint32_t reason = w.undefined_integers[s.b];
    I number;
    Whole integer;
    for (std::int64_t k = from; k <= to; ++k) {
      const std::uint32_t slot = s.a + std::uint32_t(k);
      if (whole) {
        integer = k == from ? w.integers[slot] : hull(integer, w.integers[slot]);
      } else {
        number = k == from ? w.numbers[slot] : hull(number, w.numbers[slot]);
      }
      if (reason == 0) reason = (whole ? w.undefined_integers : w.undefined)[slot];
    }
    whole ? w.write_integer(s.r, integer, placed(reason, s)) : w.write(s.r, number, placed(reason, s));
  }
  void store(Way<B>& w, const Step& s) {
    const bool whole = s.op == Op::store_integer;
    const Whole place = w.integers[s.b], integer = whole ? w.integers[s.a] : Whole{};
    const I number = whole ? I() : w.numbers[s.a];
    const std::uint32_t at = placed(w.undefined_integers[s.b], s),
                        value = placed((whole ? w.undefined_integers : w.undefined)[s.a], s);
    const std::int64_t last = s.c - 1;
    for (std::int64_t k = 0; k <= last; ++k) {
      const bool may = place.lo < 0 || (std::min(place.lo, last) <= k && k <= std::min(place.hi, last));
      if (!may && at == 0) continue;
      const bool surely = place.known() && at == 0;
      const std::uint32_t slot = s.r + std::uint32_t(k);
      const std::uint32_t old = (whole ? w.undefined_integers : w.undefined)[slot];
      const std::uint32_t reason = at > 0 ? at : value > 0 ? value : surely ? 0 : old;
      if (whole)
        w.write_integer(slot, surely ? integer : hull(w.integers[slot], integer), reason);
      else
        w.write(slot, surely ? number : hull(w.numbers[slot], number), reason);
    }
  }

  void apply_integers(Way<B>& w, const Step& s) {
    const int count = shader::operands_of(s.op).count;
    const Whole a = w.integers[s.a], b = count > 1 ? w.integers[s.b] : Whole{},
                c = count > 2 ? w.integers[s.c] : Whole{};
    const Comparison before = w.said[s.a];
    std::optional<Undefined> own = undefined_integer(s, a, b);
    if ((s.op == Op::imin || s.op == Op::umin) && s.c > 0 && !(w.integers[s.c - 1].hi <= b.lo))
      own = Undefined::clamp;
    const std::uint32_t reason = s.op == Op::iselect ? reason_of_choice(w, s, a) : reason_of(w, s, own);
    w.write_integer(s.r, own ? Whole::any() : whole_op(s.op, a, b, c), reason);
    if (s.op == Op::icopy) w.said[s.r] = before;
    if (s.op == Op::logical_not && before.op != Op::copy)
      w.said[s.r] = {before.op, before.a, before.b, !before.negated};
  }
  std::uint32_t reason_of_choice(const Way<B>& w, const Step& s, const Whole& truth) {
    const bool first = !truth.known() || truth.bits() != 0, second = !truth.known() || truth.bits() == 0;
    std::uint32_t reason = w.undefined_integers[s.a];
    if (reason == 0 && first) reason = w.undefined_integers[s.b];
    if (reason == 0 && second) reason = w.undefined_integers[s.c];
    return placed(reason, s);
  }
  static std::optional<Undefined> undefined_integer(const Step& s, const Whole& a, const Whole& b) {
    if (!may_be_undefined(s.op, a, b)) return std::nullopt;
    return s.op == Op::index                                       ? Undefined::index
           : s.op == Op::shl || s.op == Op::shr || s.op == Op::sar ? Undefined::shift
                                                                   : Undefined::division;
  }

  const Program& program_;
  const shader::Symmetry& symmetry_;
  Way<B> start_;
  bool turns_ = false;
  I none_;
  std::vector<shader::UndefinedValue> reasons_{{Undefined::variable, 0, {}}, {Undefined::no_return, 0, {}}};
  std::optional<shader::UndefinedValue> found_;
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
ShaderBounds shader_on_box(const shader::Function& function, const ShaderInputs& inputs) {
  using I = Interval<B>;
  ShaderOnBox<B> on_box(function, inputs);
  const I value = on_box.run();
  const auto cosine = [](Bounds c) { return I::widened(c.lo, c.hi, 2); };
  const I r = without_cosine<B>(function.returns, value, cosine(inputs.cos_i), cosine(inputs.cos_o));
  return {{r.lo, r.hi}, on_box.undefined()};
}

template ShaderBounds shader_on_box<float>(const shader::Function&, const ShaderInputs&);
template ShaderBounds shader_on_box<double>(const shader::Function&, const ShaderInputs&);

}  // namespace brdf::prove
