#include "shader/symmetry.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <optional>
#include <set>

#include "shader/program/operands.h"

namespace brdf::shader {
namespace {

// The names of values that do not change with the turn: equal names, equal numbers.
using Name = int;
constexpr Name kZero = 0, kOne = 1;

class Names {
 public:
  Name of(const std::vector<int>& key) {
    const auto [at, added] = known_.try_emplace(key, next_);
    if (added) ++next_;
    return at->second;
  }
  Name constant(double value) {
    if (value == 0) return kZero;
    if (value == 1) return kOne;
    if (value < 0) return neg(constant(-value));
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return of({-1, int(bits >> 32), int(bits & 0xffffffffu)});
  }
  // Sums and products do not depend on the order of two operands.
  Name add(Name a, Name b) {
    if (a == kZero) return b;
    if (b == kZero) return a;
    if (a == neg(b)) return kZero;
    return of({int(Op::add), std::min(a, b), std::max(a, b)});
  }
  Name neg(Name a) {
    if (a == kZero) return a;
    if (const auto found = opposite_.find(a); found != opposite_.end()) return found->second;
    const Name out = of({int(Op::neg), a});
    opposite_[out] = a;
    opposite_[a] = out;
    negative_.insert(out);
    return out;
  }
  // Signs are taken out, so that two of them meet.
  Name mul(Name a, Name b) {
    if (a == kZero || b == kZero) return kZero;
    if (is_negative(a) != is_negative(b)) return neg(mul(positive(a), positive(b)));
    a = positive(a), b = positive(b);
    if (a == kOne || b == kOne) return a == kOne ? b : a;
    return of({int(Op::mul), std::min(a, b), std::max(a, b)});
  }
  Name div(Name a, Name b) {
    if (a == kZero || b == kOne) return a;
    if (is_negative(a) != is_negative(b)) return neg(div(positive(a), positive(b)));
    return of({int(Op::div), positive(a), positive(b)});
  }

 private:
  bool is_negative(Name a) const { return negative_.contains(a); }
  Name positive(Name a) { return is_negative(a) ? neg(a) : a; }

  std::map<std::vector<int>, Name> known_;
  std::map<Name, Name> opposite_;
  std::set<Name> negative_;
  Name next_ = 2;
};

// Terms: 1; Lx, Ly, Vx, Vy; their ten products.
constexpr int kLinear = 1, kSquares = 5, kTerms = 15;
constexpr int product_term(int a, int b) {  // of coordinates 0 to 3
  const int low = std::min(a, b), high = std::max(a, b);
  return kSquares + low * 4 - low * (low - 1) / 2 + (high - low);
}
constexpr int kLx = 0, kLy = 1, kVx = 2, kVy = 3;

using Terms = std::array<Name, kTerms>;

// What becomes of a value when the azimuth between light and viewer changes its sign: nothing, its sign, or more.
enum class Hand : std::uint8_t { even, odd, mixed };
Hand both(Hand a, Hand b) {
  return a == b ? a : Hand::mixed;
}
Hand product_of(Hand a, Hand b) {
  if (a == Hand::mixed || b == Hand::mixed) return Hand::mixed;
  return a == b ? Hand::even : Hand::odd;
}

// A slot's value: a number that does not change (its name), or a polynomial that does (its place among those known).
struct Form {
  enum class Kind : std::uint8_t { absent, still, partial, unknown } kind = Kind::absent;
  Hand hand = Hand::even;
  bool whole = false;       // of a polynomial: its rounding error is relative to itself
  bool square = false;      // a sum of squares of such values
  std::uint16_t depth = 0;  // operations from the coordinates, of a polynomial
  int name = 0;

  bool is_known() const { return kind == Kind::still || kind == Kind::partial; }
  bool is_still() const { return kind == Kind::still; }
  bool same(const Form& other) const { return kind == other.kind && name == other.name; }
  friend bool operator==(const Form&, const Form&) = default;
};

Form still(Name name, Hand hand = Hand::even) {
  return {Form::Kind::still, hand, true, false, 0, name};
}
Form unknown() {
  return {Form::Kind::unknown};
}
int degree_of(const Terms& terms) {
  const auto any = [&](int from, int to) {
    return std::any_of(terms.begin() + from, terms.begin() + to, [](Name n) { return n != kZero; });
  };
  return any(kSquares, kTerms) ? 2 : any(kLinear, kSquares) ? 1 : 0;
}

// What is known of every slot, numbers first.
using State = std::vector<Form>;

class Analysis {
 public:
  Analysis(const Program& program, const std::vector<Binding>& bindings)
      : p_(program), ends_(p_.stretches.size()), looped_(p_.stretches.size()) {
    start_.resize(p_.numbers + p_.integers);
    for (const Program::Constant& c : p_.constants)
      at(start_, false, c.slot) = still(names_.constant(c.value));
    for (const Program::IntegerConstant& c : p_.integer_constants)
      at(start_, true, c.slot) = still(names_.of({-2, int(c.value)}));
    for (const Program::Undefined& u : p_.undefined)
      at(start_, u.integer, u.slot) = still(names_.of({-10, int(u.why), u.integer}));
    for (const Binding& b : bindings) at(start_, b.integer, b.slot) = input(b);
    for (const Stretch& s : p_.stretches) steps_.emplace_back(s.steps.size());
  }

  Symmetry run() {
    constexpr std::size_t kMost = std::size_t(1) << 22;  // forms of all stretches
    if (start_.size() * p_.stretches.size() > kMost) return {};
    for (int round = 0; round < kRounds; ++round) {
      bool changed = false;
      failed_ = handed_ = false;
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
  static constexpr int kRounds = 16, kDeepest = 200;

  const Form& at(const State& s, bool integer, std::uint32_t slot) const {
    return s[integer ? p_.numbers + slot : slot];
  }
  Form& at(State& s, bool integer, std::uint32_t slot) const { return s[integer ? p_.numbers + slot : slot]; }

  Symmetry result() {
    Symmetry s;
    s.isotropic = true;
    s.mirrored = !handed_;
    s.steps = std::move(steps_);
    s.depth = depth_;
    return s;
  }

  Terms terms_of(const Form& f) const {
    if (f.kind == Form::Kind::partial) return polynomials_[std::size_t(f.name)];
    Terms terms{};
    terms[0] = f.name;
    return terms;
  }
  Form form_of(const Terms& terms, Hand hand, int depth) {
    if (degree_of(terms) == 0) return still(terms[0], hand);
    const auto [place, added] = places_.try_emplace(terms, int(polynomials_.size()));
    if (added) polynomials_.push_back(terms);
    return {Form::Kind::partial, hand, false, false, std::uint16_t(std::min(depth, kDeepest + 1)),
            place->second};
  }

  Form coordinates(Axis axis, int component) {
    if (component == 2) return still(names_.of({-3, int(axis)}));
    Terms terms{};
    if (axis == Axis::light || axis == Axis::view) {
      terms[std::size_t(kLinear + (axis == Axis::light ? kLx : kVx) + component)] = kOne;
      Form f = form_of(terms, Hand::even, 0);
      f.whole = true;
      return f;
    }
    const Name over_length = names_.of({-4});  // of the half vector: one over the length of L + V
    terms[std::size_t(kLinear + kLx + component)] = terms[std::size_t(kLinear + kVx + component)] =
        over_length;
    Form f = form_of(terms, Hand::even, 3);
    f.whole = true;
    return f;
  }
  Form input(const Binding& b) {
    const auto frame = [](Axis a) {
      return a == Axis::tangent ? 0 : a == Axis::bitangent ? 1 : a == Axis::normal ? 2 : -1;
    };
    switch (b.from) {
      case Binding::From::coordinate:
        if (frame(b.a) >= 0) return still(frame(b.a) == b.component ? kOne : kZero);
        return coordinates(b.a, b.component);
      case Binding::From::product: {
        if (b.a == b.b) return still(kOne);
        const int first = frame(b.a), second = frame(b.b);
        if (first >= 0 && second >= 0) return still(kZero);
        if (first >= 0 || second >= 0) return coordinates(first >= 0 ? b.b : b.a, std::max(first, second));
        return still(names_.of({-5, int(std::min(b.a, b.b)), int(std::max(b.a, b.b))}));
      }
      case Binding::From::value:
        return still(names_.of({-6, int(b.value), int(b.integer), int(b.boolean)}));
      case Binding::From::one:
        return still(b.integer ? names_.of({-2, 1}) : kOne);
      case Binding::From::zero:
        break;
    }
    return still(b.integer ? names_.of({-2, 0}) : kZero);
  }

  void fail(std::uint32_t line) {
    if (failed_) return;
    failed_ = true;
    line_ = line;
  }

  // What the stretches before it leave, joined; nothing where none of them is reached.
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

  // What comes by several ways is a choice between them, by conditions that do not change. Of what a loop brings back
  // only a number that does not change stays known: its name stands for another number in each turn of the loop.
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
    if (still_all) return still(names_.of({-7, int(target), int(slot)}), hand);
    if (loop || !known) return unknown();
    std::vector<Terms> all;
    for (const auto& [source, state] : ways) all.push_back(terms_of((*state)[slot]));
    Terms out = all.front();
    for (std::size_t t = 0; t < kTerms; ++t) {
      std::vector<int> key{-8, int(target)};
      for (const Terms& terms : all) key.push_back(terms[t]);
      if (!std::equal(key.begin() + 3, key.end(), key.begin() + 2)) out[t] = names_.of(key);
    }
    return form_of(out, hand, depth);
  }

  State pass(std::size_t which, State s) {
    const Stretch& stretch = p_.stretches[which];
    for (std::size_t k = 0; k < stretch.steps.size(); ++k) steps_[which][k] = step(s, stretch.steps[k]);
    if (stretch.end == End::branch) {
      const Form& condition = at(s, true, stretch.condition);
      if (!condition.is_still()) fail(stretch.line);
      handed_ = handed_ || condition.hand != Hand::even;
    }
    if (stretch.end != End::stop) return s;
    for (const std::uint32_t slot : p_.results) {
      const Form& f = at(s, false, slot);
      if (!f.is_still()) fail(stretch.steps.empty() ? stretch.line : stretch.steps.back().line);
      handed_ = handed_ || f.hand != Hand::even;
    }
    return s;
  }

  Turning step(State& s, const Step& x) {
    const Operands o = operands_of(x.op);
    if (o.indexed_load || o.indexed_store) return indexed(s, x, o);
    bool partial_operand = false;
    int depth = 0;
    const std::uint32_t slots[] = {x.a, x.b, x.c};
    for (int k = 0; k < o.count; ++k) {
      const Form& f = at(s, o.integer[k], slots[k]);
      partial_operand = partial_operand || f.kind == Form::Kind::partial;
      depth = std::max(depth, f.depth + 1);
    }
    const Form out = value(s, x, o);
    at(s, o.result_integer, x.r) = out;
    const bool partial = out.kind == Form::Kind::partial;
    if (partial || (out.is_still() && partial_operand)) depth_ = std::max(depth_, depth);
    if (partial && depth > kDeepest) fail(x.line);
    if (partial || !out.is_still() || !partial_operand) return partial ? Turning::partial : Turning::still;
    if (out.square) return Turning::squares;
    return is_pair(s, x) ? Turning::pairs : Turning::closes;
  }

  // The terms of one operand are those of the other along the other axis.
  bool is_pair(const State& s, const Step& x) const {
    if (x.op != Op::add && x.op != Op::sub) return false;
    const Form &a = at(s, false, x.a), &b = at(s, false, x.b);
    if (a.kind != Form::Kind::partial || b.kind != Form::Kind::partial) return false;
    const Terms first = terms_of(a), second = terms_of(b);
    const auto mirrored = [](int coordinate) { return coordinate ^ 1; };
    for (int i = 0; i < 4; ++i)
      for (int j = i; j < 4; ++j)
        if ((first[std::size_t(product_term(i, j))] == kZero) !=
            (second[std::size_t(product_term(mirrored(i), mirrored(j)))] == kZero))
          return false;
    return first[0] == kZero && second[0] == kZero;
  }

  // Elements of an array are followed only where all of them are numbers that do not change.
  Turning indexed(State& s, const Step& x, const Operands& o) {
    const Form place = at(s, true, x.b);
    bool known = place.is_still();
    Hand hand = place.hand == Hand::even ? Hand::even : Hand::mixed;
    std::vector<int> key{int(x.op), int(x.a), place.name};
    const auto include = [&](const Form& f) {
      // An element that was never written is undefined, which is another finding.
      known = known && (f.is_still() || f.kind == Form::Kind::absent);
      if (f.hand != Hand::even) hand = Hand::mixed;
      key.push_back(f.is_still() ? f.name : -1);
    };
    for (std::uint32_t k = 0; k < (o.indexed_load ? x.c : 1); ++k) include(at(s, o.integer[0], x.a + k));
    if (o.indexed_load) {
      at(s, o.result_integer, x.r) = known ? still(names_.of(key), hand) : unknown();
      return Turning::still;
    }
    for (std::uint32_t k = 0; k < x.c; ++k) include(at(s, o.result_integer, x.r + k));
    for (std::uint32_t k = 0; k < x.c; ++k) {
      key.push_back(int(k));
      at(s, o.result_integer, x.r + k) = known ? still(names_.of(key), hand) : unknown();
    }
    return Turning::still;
  }

  Form value(const State& s, const Step& x, const Operands& o) {
    const std::uint32_t slots[] = {x.a, x.b, x.c};
    const auto operand = [&](int k) -> const Form& { return at(s, o.integer[k], slots[k]); };
    if (x.op == Op::copy || x.op == Op::icopy) return operand(0);
    bool all_still = true, all_known = true;
    int depth = 1;
    for (int k = 0; k < o.count; ++k) {
      all_still = all_still && operand(k).is_still();
      all_known = all_known && operand(k).is_known();
      depth = std::max(depth, operand(k).depth + 1);
    }
    const Hand hand = hand_of(s, x, o, all_still);
    if (const auto terms = polynomial(s, x, all_known)) {
      Form f = closed(*terms, hand, depth);
      set_rounding(f, s, x);
      return f;
    }
    if (!all_still && all_known && o.count == 2 && o.result_integer && !o.integer[0]) {
      // A comparison of two sums is one of their difference with 0.
      const Form difference = closed(sum(terms_of(operand(0)), opposite(terms_of(operand(1)))), hand, depth);
      if (difference.is_still())
        return still(names_.of({int(x.op), -11, difference.name}),
                     difference.hand == Hand::even ? Hand::even : Hand::mixed);
    }
    if (!all_still) return unknown();
    std::vector<int> key{int(x.op)};
    for (int k = 0; k < o.count; ++k) key.push_back(operand(k).name);
    if (x.op == Op::min) key.push_back(int(x.c));
    return still(names_.of(key), hand);
  }

  Hand hand_of(const State& s, const Step& x, const Operands& o, bool all_still) const {
    const std::uint32_t slots[] = {x.a, x.b, x.c};
    const auto hand = [&](int k) { return at(s, o.integer[k], slots[k]).hand; };
    bool all_even = true;
    for (int k = 0; k < o.count; ++k) all_even = all_even && hand(k) == Hand::even;
    if (all_even) return Hand::even;
    if (!all_still) return Hand::mixed;
    if (x.op == Op::neg) return hand(0);
    if (x.op == Op::abs) return hand(0) == Hand::odd ? Hand::even : Hand::mixed;
    if (x.op == Op::mul || x.op == Op::div) return product_of(hand(0), hand(1));
    if (x.op == Op::add || x.op == Op::sub) return both(hand(0), hand(1));
    if (x.op == Op::select && hand(0) == Hand::even) return both(hand(1), hand(2));
    return Hand::mixed;
  }

  // Which errors of rounding are relative to the value itself: not those of sums whose terms are rounded already and
  // may cancel.
  void set_rounding(Form& f, const State& s, const Step& x) const {
    const Form &a = at(s, false, x.a), &b = at(s, false, x.op == Op::neg ? x.a : x.b);
    const bool both = a.whole && b.whole;
    if (x.op == Op::mul || x.op == Op::div) {
      f.whole = both;
      f.square = both && x.op == Op::mul && a.same(b);
    } else if (x.op == Op::neg) {
      f.whole = a.whole;
    } else if (x.op == Op::add) {
      f.square = a.square && b.square;
      f.whole = f.is_still() || f.square || (both && a.depth == 0 && b.depth == 0);
    } else if (x.op == Op::sub) {
      f.whole = f.is_still() || (both && a.depth == 0 && b.depth == 0);
    } else {
      f.whole = f.is_still();
    }
  }

  // Sums, products and choices as polynomials; nothing of other operations, or beyond the second degree.
  std::optional<Terms> polynomial(const State& s, const Step& x, bool all_known) {
    const auto form = [&](std::uint32_t slot) -> const Form& { return at(s, false, slot); };
    const auto terms = [&](std::uint32_t slot) { return terms_of(form(slot)); };
    if (!all_known) return std::nullopt;
    switch (x.op) {
      case Op::add:
        return sum(terms(x.a), terms(x.b));
      case Op::sub:
        return sum(terms(x.a), opposite(terms(x.b)));
      case Op::neg:
        return opposite(terms(x.a));
      case Op::mul:
        return product(terms(x.a), terms(x.b));
      case Op::fma: {
        const auto p = product(terms(x.a), terms(x.b));
        return p ? std::optional(sum(*p, terms(x.c))) : p;
      }
      case Op::div: {
        if (!form(x.b).is_still()) return std::nullopt;
        Terms out = terms(x.a);
        for (Name& term : out) term = names_.div(term, form(x.b).name);
        return out;
      }
      case Op::mix: {
        const Terms share = terms(x.c);
        if (!form(x.c).is_still()) return std::nullopt;
        Terms rest{};
        rest[0] = names_.add(kOne, names_.neg(share[0]));
        return sum(*product(terms(x.a), rest), *product(terms(x.b), share));
      }
      case Op::select: {
        const Form& condition = at(s, true, x.a);
        Terms yes = terms_of(form(x.b));
        const Terms no = terms_of(form(x.c));
        if (!condition.is_still()) return std::nullopt;
        for (std::size_t t = 0; t < kTerms; ++t)
          if (yes[t] != no[t]) yes[t] = names_.of({int(Op::select), condition.name, yes[t], no[t]});
        return yes;
      }
      default:
        return std::nullopt;
    }
  }

  Terms opposite(Terms a) {
    for (Name& term : a) term = names_.neg(term);
    return a;
  }
  Terms sum(Terms a, const Terms& b) {
    for (std::size_t t = 0; t < kTerms; ++t) a[t] = names_.add(a[t], b[t]);
    return a;
  }
  std::optional<Terms> product(const Terms& a, const Terms& b) {
    if (degree_of(a) + degree_of(b) > 2) return std::nullopt;
    Terms out{};
    for (int i = 0; i < kTerms; ++i)
      for (int j = 0; j < kTerms; ++j) {
        const Name p = names_.mul(a[std::size_t(i)], b[std::size_t(j)]);
        if (p == kZero) continue;
        Name& term = out[std::size_t(i == 0 ? j : j == 0 ? i : product_term(i - kLinear, j - kLinear))];
        term = names_.add(term, p);
      }
    return out;
  }
  // A sum of products that does not change becomes one number.
  Form closed(const Terms& terms, Hand hand, int depth) {
    const bool linear =
        std::any_of(terms.begin() + kLinear, terms.begin() + kSquares, [](Name n) { return n != kZero; });
    if (degree_of(terms) != 2 || linear) return form_of(terms, hand, depth);
    const auto term = [&](int a, int b) { return terms[std::size_t(product_term(a, b))]; };
    const Name cross = term(kLx, kVy);
    const bool dots = term(kLx, kLx) == term(kLy, kLy) && term(kVx, kVx) == term(kVy, kVy) &&
                      term(kLx, kVx) == term(kLy, kVy) && term(kLx, kLy) == kZero && term(kVx, kVy) == kZero;
    if (!dots || names_.neg(cross) != term(kLy, kVx)) return form_of(terms, hand, depth);
    std::vector<int> key{-9};
    key.insert(key.end(), terms.begin(), terms.end());
    const bool alone = std::count(terms.begin(), terms.end(), kZero) == kTerms - 2;
    if (cross == kZero) return still(names_.of(key), hand);
    return still(names_.of(key), hand == Hand::even && alone ? Hand::odd : Hand::mixed);
  }

  const Program& p_;
  Names names_;
  State start_;
  std::vector<State> ends_;
  std::vector<std::vector<bool>> looped_;  // slots that a loop changes, where it begins
  std::vector<std::vector<Turning>> steps_;
  std::vector<Terms> polynomials_;
  std::map<Terms, int> places_;
  bool failed_ = false, handed_ = false;
  std::uint32_t line_ = 0;
  int depth_ = 0;
};

}  // namespace

Symmetry symmetry_of(const Program& program, const std::vector<Binding>& bindings) {
  return Analysis(program, bindings).run();
}

}  // namespace brdf::shader
