#include "shader/polynomials.h"

#include <bit>

#include "shader/program/program.h"

namespace brdf::shader {

Name Names::of(const std::vector<int>& key) {
  const auto [at, added] = known_.try_emplace(key, next_);
  if (added) ++next_;
  return at->second;
}

Name Names::constant(double value) {
  if (value == 0) return kZero;
  if (value == 1) return kOne;
  if (value < 0) return neg(constant(-value));
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return of({-1, int(bits >> 32), int(bits & 0xffffffffu)});
}

Name Names::add(Name a, Name b) {
  if (a == kZero) return b;
  if (b == kZero) return a;
  if (a == neg(b)) return kZero;
  return of({int(Op::add), std::min(a, b), std::max(a, b)});
}

Name Names::neg(Name a) {
  if (a == kZero) return a;
  if (const auto found = opposite_.find(a); found != opposite_.end()) return found->second;
  const Name out = of({int(Op::neg), a});
  opposite_[out] = a;
  opposite_[a] = out;
  negative_.insert(out);
  return out;
}

Name Names::mul(Name a, Name b) {
  if (a == kZero || b == kZero) return kZero;
  if (is_negative(a) != is_negative(b)) return neg(mul(positive(a), positive(b)));
  a = positive(a), b = positive(b);
  if (a == kOne || b == kOne) return a == kOne ? b : a;
  return of({int(Op::mul), std::min(a, b), std::max(a, b)});
}

Name Names::div(Name a, Name b) {
  if (a == kZero || b == kOne) return a;
  if (is_negative(a) != is_negative(b)) return neg(div(positive(a), positive(b)));
  return of({int(Op::div), positive(a), positive(b)});
}

int degree_of(const Terms& terms) {
  const auto any = [&](int from, int to) {
    return std::any_of(terms.begin() + from, terms.begin() + to, [](Name n) { return n != kZero; });
  };
  return any(kSquares, kTerms) ? 2 : any(kLinear, kSquares) ? 1 : 0;
}

Terms Polynomials::terms_of(const Form& f) const {
  if (f.kind == Form::Kind::partial) return known_[std::size_t(f.name)];
  Terms terms{};
  terms[0] = f.name;
  return terms;
}

Form Polynomials::form_of(const Terms& terms, Hand hand, int depth) {
  if (degree_of(terms) == 0) return still(terms[0], hand);
  const auto [place, added] = places_.try_emplace(terms, int(known_.size()));
  if (added) known_.push_back(terms);
  return {Form::Kind::partial, hand, false, false, std::uint16_t(std::min(depth, kFarthest + 1)),
          place->second};
}

Terms Polynomials::opposite(Terms a) {
  for (Name& term : a) term = names.neg(term);
  return a;
}

Terms Polynomials::sum(Terms a, const Terms& b) {
  for (std::size_t t = 0; t < kTerms; ++t) a[t] = names.add(a[t], b[t]);
  return a;
}

std::optional<Terms> Polynomials::product(const Terms& a, const Terms& b) {
  if (degree_of(a) + degree_of(b) > 2) return std::nullopt;
  Terms out{};
  for (int i = 0; i < kTerms; ++i)
    for (int j = 0; j < kTerms; ++j) {
      const Name p = names.mul(a[std::size_t(i)], b[std::size_t(j)]);
      if (p == kZero) continue;
      Name& term = out[std::size_t(i == 0 ? j : j == 0 ? i : product_term(i - kLinear, j - kLinear))];
      term = names.add(term, p);
    }
  return out;
}

Form Polynomials::closed(const Terms& terms, Hand hand, int depth) {
  const bool linear =
      std::any_of(terms.begin() + kLinear, terms.begin() + kSquares, [](Name n) { return n != kZero; });
  if (degree_of(terms) != 2 || linear) return form_of(terms, hand, depth);
  const auto term = [&](int a, int b) { return terms[std::size_t(product_term(a, b))]; };
  const Name cross = term(kLx, kVy);
  const bool dots = term(kLx, kLx) == term(kLy, kLy) && term(kVx, kVx) == term(kVy, kVy) &&
                    term(kLx, kVx) == term(kLy, kVy) && term(kLx, kLy) == kZero && term(kVx, kVy) == kZero;
  if (!dots || names.neg(cross) != term(kLy, kVx)) return form_of(terms, hand, depth);
  std::vector<int> key{-9};
  key.insert(key.end(), terms.begin(), terms.end());
  const bool alone = std::ranges::count(terms, kZero) == kTerms - 2;
  if (cross == kZero) return still(names.of(key), hand);
  return still(names.of(key), hand == Hand::even && alone ? Hand::odd : Hand::mixed);
}

bool Polynomials::is_pair(const Form& a, const Form& b) const {
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

}  // namespace brdf::shader
