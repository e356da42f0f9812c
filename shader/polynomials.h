// Represents values of a program as polynomials in the coordinates across the normal, with named
// coefficients.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace brdf::shader {

// Names of values that do not change with a rotation about the normal. Equal names mean equal numbers.
using Name = int;
inline constexpr Name kZero = 0, kOne = 1;

class Names {
 public:
  Name of(const std::vector<int>& key);
  Name constant(double value);
  // Sums and products do not depend on the order of their two operands. Signs are factored out, so that two
  // minus signs cancel.
  Name add(Name a, Name b);
  Name neg(Name a);
  Name mul(Name a, Name b);
  Name div(Name a, Name b);

 private:
  bool is_negative(Name a) const { return negative_.contains(a); }
  Name positive(Name a) { return is_negative(a) ? neg(a) : a; }

  std::map<std::vector<int>, Name> known_;
  std::map<Name, Name> opposite_;
  std::set<Name> negative_;
  Name next_ = 2;
};

// Terms: 1; Lx, Ly, Vx, Vy; the ten products of these coordinates.
inline constexpr int kLinear = 1, kSquares = 5, kTerms = 15;
constexpr int product_term(int a, int b) {  // a and b: coordinates 0 to 3
  const int low = std::min(a, b), high = std::max(a, b);
  return kSquares + low * 4 - low * (low - 1) / 2 + (high - low);
}
inline constexpr int kLx = 0, kLy = 1, kVx = 2, kVy = 3;

using Terms = std::array<Name, kTerms>;

// How a value changes when the azimuth between light and viewer changes its sign: not at all (even), in its
// sign (odd), or in another way (mixed).
enum class Hand : std::uint8_t { even, odd, mixed };
inline Hand both(Hand a, Hand b) {
  return a == b ? a : Hand::mixed;
}
inline Hand product_of(Hand a, Hand b) {
  if (a == Hand::mixed || b == Hand::mixed) return Hand::mixed;
  return a == b ? Hand::even : Hand::odd;
}

// The value of a slot: a number that does not change (identified by its name), or a polynomial that does
// (identified by its position among the known ones).
struct Form {
  enum class Kind : std::uint8_t { absent, still, partial, unknown } kind = Kind::absent;
  Hand hand = Hand::even;
  bool whole = false;       // of a polynomial: its rounding error is relative to its own value
  bool square = false;      // a sum of squares of such values
  std::uint16_t depth = 0;  // of a polynomial: number of operations from the coordinates
  int name = 0;

  bool is_known() const { return kind == Kind::still || kind == Kind::partial; }
  bool is_still() const { return kind == Kind::still; }
  bool same(const Form& other) const { return kind == other.kind && name == other.name; }
  friend bool operator==(const Form&, const Form&) = default;
};

inline Form still(Name name, Hand hand = Hand::even) {
  return {Form::Kind::still, hand, true, false, 0, name};
}
inline Form unknown() {
  return {Form::Kind::unknown};
}
// Returns the largest degree of the terms that are not 0.
int degree_of(const Terms& terms);

inline constexpr int kFarthest = 200;  // number of operations from the coordinates

class Polynomials {
 public:
  Names names;

  Terms terms_of(const Form& f) const;
  Form form_of(const Terms& terms, Hand hand, int depth);

  Terms opposite(Terms a);
  Terms sum(Terms a, const Terms& b);
  // Returns std::nullopt beyond the second degree.
  std::optional<Terms> product(const Terms& a, const Terms& b);
  // Returns the polynomial as a form. A polynomial that depends only on dot products and on the cross
  // product along the normal is a number that does not change.
  Form closed(const Terms& terms, Hand hand, int depth);
  // Returns whether the terms of one form are the terms of the other along the other axis.
  bool is_pair(const Form& a, const Form& b) const;

 private:
  std::vector<Terms> known_;
  std::map<Terms, int> places_;
};

}  // namespace brdf::shader
