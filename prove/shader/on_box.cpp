#include "prove/shader/on_box.h"

#include <algorithm>
#include <tuple>

#include "prove/scalar/on_box.h"
#include "prove/shader/box_steps.h"
#include "prove/shader/number_op.h"
#include "prove/shader/other_turns.h"
#include "shader/program/operations.h"

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

template <class B>
class ShaderOnBox {
 public:
  using I = Interval<B>;
  explicit ShaderOnBox(const shader::Function& f)
      : function_(f),
        program_(f.program<B>()),
        symmetry_(f.turning<B>()),
        others_(symmetry_),
        blank_(program_),
        way_(blank_),
        steps_(program_) {}

  // Returns whether this object belongs to this very function: another function at the same address has
  // another number.
  bool is_of(const shader::Function& f) const { return &f == &function_ && f.number == number_; }

  I run(const ShaderInputs& inputs) {
    const Vec3<I> wi = direction<I>(inputs.cos_i, inputs.turn_i),
                  wo = direction<I>(inputs.cos_o, inputs.turn_o);
    // The symmetry covers the other turns if a single turn is requested.
    turns_ = symmetry_.isotropic && inputs.turn_i.lo == inputs.turn_i.hi;
    steps_.start_over();
    found_.reset();
    way_ = blank_;
    fill(inputs, wi, wo);
    return hull_of_ways();
  }

  // Returns an undefined value on which the result may depend.
  const std::optional<shader::UndefinedValue>& undefined() const { return found_; }

 private:
  // Returns the hull of all ways; poison if the result of a way is poison, or may be undefined.
  I hull_of_ways() {
    std::vector<std::pair<Way<B>, std::uint32_t>> left;
    std::uint32_t at = 0;
    I result;
    for (int ways = 0;; ++ways) {
      if (ways >= kMostWays || !follow(way_, at, left)) return I::poison();
      for (std::size_t k = 0; k < program_.results.size(); ++k) {
        const std::uint32_t slot = program_.results[k];
        const I value = way_.numbers[slot];
        if (way_.undefined[slot] > 0) found_ = steps_.reason(way_.undefined[slot]);
        if (found_ && found_->line == 0) found_->line = program_.line;
        if (value.poisoned()) return I::poison();
        result = ways == 0 && k == 0 ? value : hull(result, value);
      }
      if (left.empty()) return result;
      std::tie(way_, at) = std::move(left.back());
      left.pop_back();
    }
  }
  void fill(const ShaderInputs& inputs, const Vec3<I>& wi, const Vec3<I>& wo) {
    const Vec3<I> h = half(wi, wo);
    for (const Binding& b : function_.bound<B>()) {
      if (b.integer) {
        const Bounds v = b.from == Binding::From::value ? inputs.values[b.value] : Bounds{1, 1};
        const bool zero = b.from == Binding::From::zero;
        const std::int64_t least = std::int32_t(shader::integer_of(b, double(B(v.lo)))),
                           most = std::int32_t(shader::integer_of(b, double(B(v.hi))));
        way_.write_integer(b.slot, zero ? Whole{} : Whole{least, most});
      } else {
        way_.write(b.slot, input(b, inputs, wi, wo, h));
        if (turns_ && across_normal(b)) OtherTurns<B>::begin(way_, b.slot);
      }
    }
  }
  // Returns whether the binding is a coordinate that changes when light and viewer are rotated together.
  static bool lies(Axis a) { return a == Axis::tangent || a == Axis::bitangent; }
  static bool is_outer(Axis a) { return a == Axis::light || a == Axis::view; }
  static bool across_normal(const Binding& b) {
    const auto moves = [](Axis a) { return a == Axis::light || a == Axis::view || a == Axis::half; };
    if (b.from == Binding::From::coordinate) return moves(b.a) && b.component < 2;
    return b.from == Binding::From::product && ((moves(b.a) && lies(b.b)) || (moves(b.b) && lies(b.a)));
  }
  // Returns the input that Runner::set_directions gives (shader/function.h).
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
        // The half vector with the light or the viewer is |h|/2; with an axis in the plane the product has
        // any sign.
        const bool facing = (b.a == Axis::half && is_outer(b.b)) || (b.b == Axis::half && is_outer(b.a));
        const bool upward = b.a == Axis::normal || b.b == Axis::normal;
        const I sum = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        // A coordinate, or a sum with a different rounding at turns other than the requested turn.
        return cut(lies(b.a) || lies(b.b) || upward ? sum : widened_by(sum, 8 * I::kUnit),
                   facing || upward ? 0.0 : -1.0, 1.0);
      }
      case Binding::From::one:
        return I(1);
      case Binding::From::random:  // only of samplers
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

  void apply_at_every_turn(Way<B>& way, const Step& s, shader::Turning turning) {
    const auto result = OtherTurns<B>::result_of(way, s, turning);
    steps_.apply(way, s);
    others_.widen(way, s, turning, result);
  }

  // Follows a way to its end; ways that branch off are added to `left`. Returns false if the way is too
  // long, or depends on an undefined value.
  bool follow(Way<B>& way, std::uint32_t at, std::vector<std::pair<Way<B>, std::uint32_t>>& left) {
    for (;;) {
      const shader::Stretch& stretch = program_.stretches[at];
      for (std::size_t k = 0; k < stretch.steps.size(); ++k) {
        if (turns_)
          apply_at_every_turn(way, stretch.steps[k], symmetry_.steps[at][k]);
        else
          steps_.apply(way, stretch.steps[k]);
      }
      way.steps += stretch.steps.size() + 1;
      if (way.steps > kMostSteps || left.size() > std::size_t(kMostWays)) return false;
      if (stretch.end == End::stop) return true;
      bool holds = true;
      if (stretch.end == End::branch) {
        if (const std::uint32_t reason = way.undefined_integers[stretch.condition]; reason > 0) {
          found_ = steps_.reason(reason);
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

  const shader::Function& function_;
  std::uint64_t number_ = function_.number;
  const Program& program_;
  const shader::Symmetry& symmetry_;
  OtherTurns<B> others_;
  Way<B> blank_, way_;
  bool turns_ = false;
  BoxSteps<B> steps_;
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
        return "a function without interval arithmetic" + where;
      if (s.op == Op::bits_of || s.op == Op::from_bits) return "an operation on the bits of a float" + where;
    }
  return "";
}

template <class B>
ShaderBounds shader_on_box(const shader::Function& function, const ShaderInputs& inputs) {
  using I = Interval<B>;
  // Kept between calls: preparing a way costs as much as following one.
  thread_local std::optional<ShaderOnBox<B>> kept;
  if (!kept || !kept->is_of(function)) kept.emplace(function);
  const I value = kept->run(inputs);
  const auto cosine = [](Bounds c) { return I::widened(c.lo, c.hi, 2); };
  const I r = without_cosine<B>(function.returns, value, cosine(inputs.cos_i), cosine(inputs.cos_o));
  return {{r.lo, r.hi}, kept->undefined()};
}

template ShaderBounds shader_on_box<float>(const shader::Function&, const ShaderInputs&);
template ShaderBounds shader_on_box<double>(const shader::Function&, const ShaderInputs&);

}  // namespace brdf::prove
