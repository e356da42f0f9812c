#include "shader/symmetry.h"

#include <algorithm>
#include <optional>

#include "shader/turning_steps.h"

namespace brdf::shader {
namespace {

class Analysis {
 public:
  Analysis(const Program& program, const std::vector<Binding>& bindings)
      : p_(program), slots_(program, forms_), ends_(p_.stretches.size()), looped_(p_.stretches.size()) {
    start_.resize(p_.numbers + p_.integers);
    for (const Program::Constant& c : p_.constants)
      slots_.at(start_, false, c.slot) = still(forms_.names.constant(c.value));
    for (const Program::IntegerConstant& c : p_.integer_constants)
      slots_.at(start_, true, c.slot) = still(forms_.names.of({-2, int(c.value)}));
    for (const Program::Undefined& u : p_.undefined)
      slots_.at(start_, u.integer, u.slot) = still(forms_.names.of({-10, int(u.why), u.integer}));
    for (const Binding& b : bindings) slots_.at(start_, b.integer, b.slot) = input(b);
    for (const Stretch& s : p_.stretches) steps_.emplace_back(s.steps.size());
  }

  Symmetry run() {
    constexpr std::size_t kMost = std::size_t(1) << 22;  // limit of the number of forms of all stretches
    if (start_.size() * p_.stretches.size() > kMost) return {};
    for (int round = 0; round < kRounds; ++round) {
      bool changed = false;
      failed_ = handed_ = false;
      slots_.start_over();
      for (std::size_t k = 0; k < p_.stretches.size(); ++k) {
        const std::optional<State> begin = begin_of(k);
        if (!begin) continue;
        State end = pass(k, *begin);
        changed = changed || end != ends_[k];
        ends_[k] = std::move(end);
      }
      if (!changed) return failed_ ? Symmetry{false, false, line_, {}, 0} : result();
    }
    return {};
  }

 private:
  static constexpr int kRounds = 16;

  Symmetry result() {
    Symmetry s;
    s.isotropic = true;
    s.mirrored = !handed_;
    s.steps = std::move(steps_);
    s.depth = slots_.depth();
    return s;
  }

  Form coordinates(Axis axis, int component) {
    if (component == 2) return still(forms_.names.of({-3, int(axis)}));
    Terms terms{};
    if (axis == Axis::light || axis == Axis::view) {
      terms[std::size_t(kLinear + (axis == Axis::light ? kLx : kVx) + component)] = kOne;
      Form f = forms_.form_of(terms, Hand::even, 0);
      f.whole = true;
      return f;
    }
    const Name over_length = forms_.names.of({-4});  // of the half vector: 1 / |L + V|
    terms[std::size_t(kLinear + kLx + component)] = terms[std::size_t(kLinear + kVx + component)] =
        over_length;
    Form f = forms_.form_of(terms, Hand::even, 3);
    f.whole = true;
    return f;
  }
  Form input(const Binding& b) {
    switch (b.from) {
      case Binding::From::coordinate:
        if (frame_coordinate(b.a) >= 0) return still(frame_coordinate(b.a) == b.component ? kOne : kZero);
        return coordinates(b.a, b.component);
      case Binding::From::product: {
        if (b.a == b.b) return still(kOne);
        const int first = frame_coordinate(b.a), second = frame_coordinate(b.b);
        if (first >= 0 && second >= 0) return still(kZero);
        if (first >= 0 || second >= 0) return coordinates(first >= 0 ? b.b : b.a, std::max(first, second));
        return still(forms_.names.of({-5, int(std::min(b.a, b.b)), int(std::max(b.a, b.b))}));
      }
      case Binding::From::value:
        return still(forms_.names.of({-6, int(b.value), int(b.integer), int(b.boolean)}));
      case Binding::From::one:
        return still(b.integer ? forms_.names.of({-2, 1}) : kOne);
      case Binding::From::random:  // only of samplers
      case Binding::From::zero:
        break;
    }
    return still(b.integer ? forms_.names.of({-2, 0}) : kZero);
  }

  void fail(std::uint32_t line) {
    if (failed_) return;
    failed_ = true;
    line_ = line;
  }

  // The joined states at the ends of the preceding stretches; std::nullopt if no preceding stretch has been
  // reached.
  std::optional<State> begin_of(std::size_t target) {
    std::vector<std::pair<std::size_t, const State*>> ways;
    if (target == 0) ways.emplace_back(0, &start_);
    bool loop = false;
    for (std::size_t k = 0; k < p_.stretches.size(); ++k) {
      const Stretch& s = p_.stretches[k];
      if (s.end == End::stop || ends_[k].empty()) continue;
      if (s.next[0] != target && (s.end != End::branch || s.next[1] != target)) continue;
      ways.emplace_back(k, &ends_[k]);
      loop = loop || k >= target;
    }
    if (ways.empty()) return std::nullopt;
    State begin = *ways.front().second;
    if (ways.size() == 1) return begin;
    if (looped_[target].empty()) looped_[target].resize(begin.size());
    for (std::size_t slot = 0; slot < begin.size(); ++slot) begin[slot] = joined(ways, target, slot, loop);
    return begin;
  }

  // A value that arrives from several stretches is a choice between them, by conditions that do not change.
  // Of the values that a loop carries over, only numbers that do not change remain known. Such a number
  // gets a name of its own, because it differs between iterations.
  Form joined(const std::vector<std::pair<std::size_t, const State*>>& ways, std::size_t target,
              std::size_t slot, bool loop) {
    const Form& first = (*ways.front().second)[slot];
    bool same = !looped_[target][slot], still_all = true, known = true, whole = true, square = true;
    Hand hand = first.hand;
    int depth = 0;
    for (const auto& [source, state] : ways) {
      const Form& f = (*state)[slot];
      same = same && f.same(first);
      still_all = still_all && f.is_still();
      known = known && f.is_known();
      hand = both(hand, f.hand);
      whole = whole && f.whole;
      square = square && f.square;
      depth = std::max<int>(depth, f.depth);
    }
    if (same) return {first.kind, hand, whole, square, std::uint16_t(depth), first.name};
    if (loop) looped_[target][slot] = true;
    if (still_all) return still(forms_.names.of({-7, int(target), int(slot)}), hand);
    if (loop || !known) return unknown();
    std::vector<Terms> all;
    for (const auto& [source, state] : ways) all.push_back(forms_.terms_of((*state)[slot]));
    Terms out = all.front();
    for (std::size_t t = 0; t < kTerms; ++t) {
      std::vector<int> key{-8, int(target)};
      for (const Terms& terms : all) key.push_back(terms[t]);
      if (!std::equal(key.begin() + 3, key.end(), key.begin() + 2)) out[t] = forms_.names.of(key);
    }
    return forms_.form_of(out, hand, depth);
  }

  State pass(std::size_t which, State s) {
    const Stretch& stretch = p_.stretches[which];
    for (std::size_t k = 0; k < stretch.steps.size(); ++k)
      steps_[which][k] = slots_.step(s, stretch.steps[k]);
    if (slots_.too_deep() > 0) fail(slots_.too_deep());
    if (stretch.end == End::branch) {
      const Form& condition = slots_.at(s, true, stretch.condition);
      if (!condition.is_still()) fail(stretch.line);
      handed_ = handed_ || condition.hand != Hand::even;
    }
    if (stretch.end != End::stop) return s;
    for (const std::uint32_t slot : p_.results) {
      const Form& f = slots_.at(s, false, slot);
      if (!f.is_still()) fail(stretch.steps.empty() ? stretch.line : stretch.steps.back().line);
      handed_ = handed_ || f.hand != Hand::even;
    }
    return s;
  }

  const Program& p_;
  Polynomials forms_;
  TurningSteps slots_;
  State start_;
  std::vector<State> ends_;
  // For each stretch at which a loop begins, the slots that the loop changes.
  std::vector<std::vector<bool>> looped_;
  std::vector<std::vector<Turning>> steps_;
  bool failed_ = false, handed_ = false;
  std::uint32_t line_ = 0;
};

}  // namespace

Symmetry symmetry_of(const Program& program, const std::vector<Binding>& bindings) {
  return Analysis(program, bindings).run();
}

}  // namespace brdf::shader
