// One way through a shader's program: the knowledge about every number and integer on that way.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "prove/scalar/interval.h"
#include "prove/shader/whole.h"
#include "shader/program/program.h"

namespace brdf::prove {

// Additional knowledge about a number: it is a sum of squares of these slots, the root of such a sum, or
// one over the root.
struct Squares {
  enum class Kind { none, sum, length, inverse } kind = Kind::none;
  static constexpr std::size_t kMost = 4;
  std::size_t count = 0;
  std::array<std::uint32_t, kMost> of{};  // slots that represent a number: copies share one slot

  bool contains(std::uint32_t slot) const { return std::find(of.data(), end(), slot) != end(); }
  std::span<const std::uint32_t> slots() const { return {of.data(), count}; }
  // Returns false if there are too many slots.
  bool add(std::uint32_t slot) {
    if (contains(slot)) return true;
    if (count == kMost) return false;
    of[count++] = slot;
    return true;
  }

 private:
  const std::uint32_t* end() const { return of.data() + count; }
};

// The comparison that gave a truth.
struct Comparison {
  shader::Op op = shader::Op::copy;  // copy: nothing is known of the truth
  std::uint32_t a = 0, b = 0;
  bool negated = false;
};

// The state of one way through the program.
template <class B>
struct Way {
  using I = Interval<B>;
  std::vector<I> numbers;
  std::vector<std::uint32_t> root;  // the slot that holds the number of a copy
  std::vector<Squares> squares;
  std::vector<Whole> integers;
  std::vector<Comparison> said;
  std::vector<bool> told_of;  // slots that copies, squares or comparisons of other slots refer to
  // The reason why a slot may hold an undefined value: an index in the list of reasons, from 1. 0: the
  // value is defined. Undefined numbers are poisoned.
  std::vector<std::uint32_t> undefined, undefined_integers;
  // For a number that changes when light and viewer are rotated together: a bound of its absolute value at
  // every turn.
  std::vector<double> magnitude;
  std::vector<bool> turns;
  std::vector<double> underflow;  // a bound of the absolute error by underflow at every turn
  std::size_t steps = 0;

  // Reasons 1 and 2 are the members of Unset. Slots that are neither constants nor inputs are unwritten.
  explicit Way(const shader::Program& p)
      : numbers(p.numbers),
        root(p.numbers),
        squares(p.numbers),
        integers(p.integers),
        said(p.integers),
        told_of(p.numbers),
        undefined(p.numbers, 1),
        undefined_integers(p.integers, 1),
        magnitude(p.numbers),
        turns(p.numbers),
        underflow(p.numbers) {
    for (std::uint32_t k = 0; k < p.numbers; ++k) root[k] = k;
    for (I& number : numbers) number = I::poison();
    for (const shader::Program::Constant& c : p.constants) write(c.slot, I(double(B(c.value))));
    for (const shader::Program::IntegerConstant& c : p.integer_constants)
      write_integer(c.slot, Whole::of_bits(c.value));
    for (const shader::Program::Undefined& u : p.undefined)
      (u.integer ? undefined_integers : undefined)[u.slot] = 1 + std::uint32_t(u.why);
  }

  // Writes a number and discards the knowledge that refers to the slot's old number.
  void write(std::uint32_t slot, const I& value, std::uint32_t reason = 0) {
    if (told_of[slot]) {
      for (std::uint32_t k = 0; k < root.size(); ++k)
        if (root[k] == slot && k != slot) root[k] = k;
      for (Squares& s : squares)
        if (s.contains(slot)) s = {};
      for (Comparison& c : said)
        if (c.op != shader::Op::copy && (c.a == slot || c.b == slot)) c = {};
      told_of[slot] = false;
    }
    numbers[slot] = reason == 0 ? value : I::poison();
    undefined[slot] = reason;
    root[slot] = slot;
    squares[slot] = {};
    turns[slot] = false;
    underflow[slot] = 0;
  }
  // States that the number changes with the turn, and a bound of its absolute value.
  void set_turning(std::uint32_t slot, double most) {
    magnitude[slot] = most;
    turns[slot] = true;
  }
  // Returns a bound of the number's absolute value at every turn.
  double most(std::uint32_t slot) const { return turns[slot] ? magnitude[slot] : numbers[slot].magnitude(); }
  void tell_of(std::uint32_t slot) { told_of[slot] = true; }
  void write_integer(std::uint32_t slot, const Whole& value, std::uint32_t reason = 0) {
    integers[slot] = value;
    undefined_integers[slot] = reason;
    said[slot] = {};
  }
  // Narrows the range of a number and of its copies.
  void narrow(std::uint32_t slot, double low, double high) {
    const std::uint32_t r = root[slot];
    for (std::uint32_t k = 0; k < root.size(); ++k)
      if (root[k] == r && !numbers[k].poisoned()) {
        numbers[k].lo = std::min(std::max(numbers[k].lo, low), numbers[k].hi);
        numbers[k].hi = std::max(std::min(numbers[k].hi, high), numbers[k].lo);
      }
  }
  // Assumes that the condition holds, or does not, and narrows the compared numbers accordingly.
  void suppose(std::uint32_t condition, bool holds) {
    if (integers[condition] == Whole::truth()) integers[condition] = {holds, holds};
    const Comparison c = said[condition];
    if (c.op == shader::Op::copy) return;
    const bool truth = holds != c.negated;
    const I a = numbers[c.a], b = numbers[c.b];
    const bool less = c.op == shader::Op::less || c.op == shader::Op::less_or ||
                      c.op == shader::Op::less_equal || c.op == shader::Op::less_equal_or;
    if (less && truth) {
      narrow(c.a, -I::kLargest, b.hi);
      narrow(c.b, a.lo, I::kLargest);
    } else if (less) {
      narrow(c.a, b.lo, I::kLargest);
      narrow(c.b, -I::kLargest, a.hi);
    } else if (truth == (c.op == shader::Op::equal)) {
      narrow(c.a, b.lo, b.hi);
      narrow(c.b, a.lo, a.hi);
    }
  }
};

// Returns the knowledge about the result of a step from the knowledge about its operands.
inline Squares squares_of(const shader::Step& s, const Squares& a, const Squares& b, std::uint32_t root_a,
                          std::uint32_t root_b) {
  using Kind = Squares::Kind;
  if (s.op == shader::Op::copy) return a;
  Squares out;
  if (s.op == shader::Op::mul && root_a == root_b) {
    out.kind = Kind::sum;
    out.add(root_a);
  } else if ((s.op == shader::Op::sqrt || s.op == shader::Op::inverse_sqrt) && a.kind == Kind::sum) {
    out = a;
    out.kind = s.op == shader::Op::sqrt ? Kind::length : Kind::inverse;
  } else if (s.op == shader::Op::add && a.kind == Kind::sum && b.kind == Kind::sum) {
    out = a;
    for (const std::uint32_t slot : b.slots())
      if (!out.add(slot)) return {};
  }
  return out;
}

}  // namespace brdf::prove
