#include "shader/turning_steps.h"

#include <algorithm>

namespace brdf::shader {

Turning TurningSteps::step(State& s, const Step& x) {
  const Operation& o = operation(x.op);
  if (o.loads() || o.stores()) return indexed(s, x, o);
  bool partial_operand = false;
  int depth = 0;
  const std::uint32_t slots[] = {x.a, x.b, x.c};
  for (int k = 0; k < o.count(); ++k) {
    const Form& f = at(s, o.reads_integer(k), slots[k]);
    partial_operand = partial_operand || f.kind == Form::Kind::partial;
    depth = std::max(depth, f.depth + 1);
  }
  const Form out = value(s, x, o);
  at(s, o.writes_integer(), x.r) = out;
  const bool partial = out.kind == Form::Kind::partial;
  if (partial || (out.is_still() && partial_operand)) depth_ = std::max(depth_, depth);
  if (partial && depth > kFarthest && too_deep_ == 0) too_deep_ = std::max(x.line, 1u);
  if (partial || !out.is_still() || !partial_operand) return partial ? Turning::partial : Turning::still;
  if (out.square) return Turning::squares;
  const bool pair =
      (x.op == Op::add || x.op == Op::sub) && forms_.is_pair(at(s, false, x.a), at(s, false, x.b));
  return pair ? Turning::pairs : Turning::closes;
}

// The elements of an array are followed only if all of them are numbers that do not change.
Turning TurningSteps::indexed(State& s, const Step& x, const Operation& o) {
  const Form place = at(s, true, x.b);
  bool known = place.is_still();
  Hand hand = place.hand == Hand::even ? Hand::even : Hand::mixed;
  std::vector<int> key{int(x.op), int(x.a), place.name};
  const auto include = [&](const Form& f) {
    // Reading an element that was never written is undefined; another check reports this.
    known = known && (f.is_still() || f.kind == Form::Kind::absent);
    if (f.hand != Hand::even) hand = Hand::mixed;
    key.push_back(f.is_still() ? f.name : -1);
  };
  for (std::uint32_t k = 0; k < (o.loads() ? x.c : 1); ++k) include(at(s, o.reads_integer(0), x.a + k));
  if (o.loads()) {
    at(s, o.writes_integer(), x.r) = known ? still(forms_.names.of(key), hand) : unknown();
    return Turning::still;
  }
  for (std::uint32_t k = 0; k < x.c; ++k) include(at(s, o.writes_integer(), x.r + k));
  for (std::uint32_t k = 0; k < x.c; ++k) {
    key.push_back(int(k));
    at(s, o.writes_integer(), x.r + k) = known ? still(forms_.names.of(key), hand) : unknown();
  }
  return Turning::still;
}

Form TurningSteps::value(const State& s, const Step& x, const Operation& o) {
  const std::uint32_t slots[] = {x.a, x.b, x.c};
  const auto operand = [&](int k) -> const Form& { return at(s, o.reads_integer(k), slots[k]); };
  if (x.op == Op::copy || x.op == Op::icopy || x.op == Op::to_half) return operand(0);
  bool all_still = true, all_known = true;
  int depth = 1;
  for (int k = 0; k < o.count(); ++k) {
    all_still = all_still && operand(k).is_still();
    all_known = all_known && operand(k).is_known();
    depth = std::max(depth, operand(k).depth + 1);
  }
  const Hand hand = hand_of(s, x, o, all_still);
  if (const auto terms = polynomial(s, x, all_known)) {
    Form f = forms_.closed(*terms, hand, depth);
    set_rounding(f, s, x);
    return f;
  }
  if (!all_still && all_known && o.count() == 2 && o.writes_integer() && !o.reads_integer(0)) {
    // A comparison of two sums equals a comparison of their difference with 0.
    const Form difference = forms_.closed(
        forms_.sum(forms_.terms_of(operand(0)), forms_.opposite(forms_.terms_of(operand(1)))), hand, depth);
    if (difference.is_still())
      return still(forms_.names.of({int(x.op), -11, difference.name}),
                   difference.hand == Hand::even ? Hand::even : Hand::mixed);
  }
  if (!all_still) return unknown();
  std::vector<int> key{int(x.op)};
  for (int k = 0; k < o.count(); ++k) key.push_back(operand(k).name);
  if (x.op == Op::min || x.op == Op::texel) key.push_back(int(x.c));
  return still(forms_.names.of(key), hand);
}

Hand TurningSteps::hand_of(const State& s, const Step& x, const Operation& o, bool all_still) const {
  const std::uint32_t slots[] = {x.a, x.b, x.c};
  const auto hand = [&](int k) { return at(s, o.reads_integer(k), slots[k]).hand; };
  bool all_even = true;
  for (int k = 0; k < o.count(); ++k) all_even = all_even && hand(k) == Hand::even;
  if (all_even) return Hand::even;
  if (!all_still) return Hand::mixed;
  if (x.op == Op::neg) return hand(0);
  if (x.op == Op::abs) return hand(0) == Hand::odd ? Hand::even : Hand::mixed;
  if (x.op == Op::mul || x.op == Op::div) return product_of(hand(0), hand(1));
  if (x.op == Op::add || x.op == Op::sub) return both(hand(0), hand(1));
  if (x.op == Op::select && hand(0) == Hand::even) return both(hand(1), hand(2));
  return Hand::mixed;
}

void TurningSteps::set_rounding(Form& f, const State& s, const Step& x) const {
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

std::optional<Terms> TurningSteps::polynomial(const State& s, const Step& x, bool all_known) {
  const auto form = [&](std::uint32_t slot) -> const Form& { return at(s, false, slot); };
  const auto terms = [&](std::uint32_t slot) { return forms_.terms_of(form(slot)); };
  if (!all_known) return std::nullopt;
  switch (x.op) {
    case Op::add:
      return forms_.sum(terms(x.a), terms(x.b));
    case Op::sub:
      return forms_.sum(terms(x.a), forms_.opposite(terms(x.b)));
    case Op::neg:
      return forms_.opposite(terms(x.a));
    case Op::mul:
      return forms_.product(terms(x.a), terms(x.b));
    case Op::fma: {
      const auto p = forms_.product(terms(x.a), terms(x.b));
      return p ? std::optional(forms_.sum(*p, terms(x.c))) : p;
    }
    case Op::div: {
      if (!form(x.b).is_still()) return std::nullopt;
      Terms out = terms(x.a);
      for (Name& term : out) term = forms_.names.div(term, form(x.b).name);
      return out;
    }
    case Op::mix: {
      const Terms share = terms(x.c);
      if (!form(x.c).is_still()) return std::nullopt;
      Terms rest{};
      rest[0] = forms_.names.add(kOne, forms_.names.neg(share[0]));
      return forms_.sum(*forms_.product(terms(x.a), rest), *forms_.product(terms(x.b), share));
    }
    case Op::select: {
      const Form& condition = at(s, true, x.a);
      Terms yes = forms_.terms_of(form(x.b));
      const Terms no = forms_.terms_of(form(x.c));
      if (!condition.is_still()) return std::nullopt;
      for (std::size_t t = 0; t < kTerms; ++t)
        if (yes[t] != no[t]) yes[t] = forms_.names.of({int(Op::select), condition.name, yes[t], no[t]});
      return yes;
    }
    default:
      return std::nullopt;
  }
}

}  // namespace brdf::shader
