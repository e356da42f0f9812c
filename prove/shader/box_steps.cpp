#include "prove/shader/box_steps.h"

#include <algorithm>

#include "prove/scalar/on_box.h"
#include "prove/shader/number_op.h"
#include "shader/program/operations.h"

namespace brdf::prove {

using shader::Op;
using shader::Step;
using shader::Undefined;

namespace {

// Returns a coordinate over the length of its vector; the sum, the root and the division round.
template <class B>
Interval<B> of_unit(const Interval<B>& x) {
  constexpr double kMost = 1 + 16 * Interval<B>::kUnit;
  return x.poisoned() ? x : cut(x, -kMost, kMost);
}

// Returns the reason why an operation on numbers of these ranges may be undefined. Poison may be any number,
// an infinity or NaN.
template <class B>
std::optional<Undefined> undefined_number(const Step& s, const Way<B>& w) {
  return shader::undefined_of_numbers(
      s, [&](std::uint32_t slot) -> const Interval<B>& { return w.numbers[slot]; });
}

// Returns whether the step divides a coordinate by the length of its vector.
bool of_length_of(const Step& s, const Squares& a, const Squares& b, std::uint32_t root_a,
                  std::uint32_t root_b) {
  using Kind = Squares::Kind;
  if (s.op == Op::div) return b.kind == Kind::length && b.contains(root_a);
  if (s.op != Op::mul) return false;
  return (b.kind == Kind::inverse && b.contains(root_a)) || (a.kind == Kind::inverse && a.contains(root_b));
}

std::optional<Undefined> undefined_integer(const Step& s, const Whole& a, const Whole& b) {
  if (!may_be_undefined(s.op, a, b)) return std::nullopt;
  return s.op == Op::index                                       ? Undefined::index
         : s.op == Op::shl || s.op == Op::shr || s.op == Op::sar ? Undefined::shift
         : (s.op == Op::smod || s.op == Op::srem) && b.lo > 0    ? Undefined::remainder
                                                                 : Undefined::division;
}

std::int64_t limited(std::int64_t place, std::int64_t last) {
  return std::clamp(place, std::int64_t(0), last);
}

}  // namespace

template <class B>
std::uint32_t BoxSteps<B>::placed(std::uint32_t reason, const Step& s) {
  if (reason == 0 || reasons_[reason - 1].line > 0 || s.op == Op::copy || s.op == Op::icopy) return reason;
  reasons_.push_back({reasons_[reason - 1].why, s.line, {}});
  return std::uint32_t(reasons_.size());
}

template <class B>
std::uint32_t BoxSteps<B>::reason_of(const Way<B>& w, const Step& s, std::optional<Undefined> own) {
  const shader::Operation& o = shader::operation(s.op);
  const std::uint32_t slots[] = {s.a, s.b, s.c};
  for (int k = 0; k < o.count(); ++k)
    if (const std::uint32_t r = (o.reads_integer(k) ? w.undefined_integers : w.undefined)[slots[k]]; r > 0)
      return placed(r, s);
  if (!own) return 0;
  reasons_.push_back({*own, s.line, {}});
  return std::uint32_t(reasons_.size());
}

template <class B>
void BoxSteps<B>::apply(Way<B>& w, const Step& s) {
  const shader::Operation& o = shader::operation(s.op);
  if (s.op == Op::select)
    select(w, s);
  else if (o.of_numbers())
    apply_numbers(w, s);
  else if (o.compares != shader::Operation::Compares::no)
    apply_comparison(w, s);
  else if (s.op == Op::is_nan || s.op == Op::is_inf)
    w.write_integer(s.r, w.numbers[s.a].poisoned() ? Whole::truth() : Whole{0, 0}, reason_of(w, s, {}));
  else if (s.op == Op::to_signed || s.op == Op::to_unsigned)
    to_integer(w, s);
  else if (s.op == Op::from_signed || s.op == Op::from_unsigned)
    from_integer(w, s);
  else if (s.op == Op::texel)
    read_texel(w, s);
  else if (s.op == Op::load_number || s.op == Op::load_integer)
    load(w, s);
  else if (s.op == Op::store_number || s.op == Op::store_integer)
    store(w, s);
  else
    apply_integers(w, s);
}

template <class B>
void BoxSteps<B>::select(Way<B>& w, const Step& s) {
  const std::uint32_t condition = w.undefined_integers[s.a];
  if (condition > 0) return w.write(s.r, I::poison(), placed(condition, s));
  const I yes = w.numbers[s.b], no = w.numbers[s.c];
  const Whole truth = w.integers[s.a];
  const bool open = !truth.known(), first = truth.bits() != 0;
  const std::uint32_t reason = (open || first) && w.undefined[s.b] > 0    ? w.undefined[s.b]
                               : (open || !first) && w.undefined[s.c] > 0 ? w.undefined[s.c]
                                                                          : 0;
  w.write(s.r, open ? hull(yes, no) : first ? yes : no, placed(reason, s));
}

template <class B>
void BoxSteps<B>::apply_comparison(Way<B>& w, const Step& s) {
  const Tri t = compared<B>(s.op, w.numbers[s.a], w.numbers[s.b]);
  const bool poison = w.numbers[s.a].poisoned() || w.numbers[s.b].poisoned();
  const bool open = poison || t == Tri::maybe;
  w.write_integer(s.r, open ? Whole::truth() : Whole{t == Tri::yes, t == Tri::yes}, reason_of(w, s, {}));
  if (poison) return;
  w.said[s.r] = {s.op, s.a, s.b, false};
  w.tell_of(s.a);
  w.tell_of(s.b);
}

template <class B>
void BoxSteps<B>::from_integer(Way<B>& w, const Step& s) {
  const Whole x = w.integers[s.a];
  const bool wraps = s.op == Op::from_unsigned && x.lo < 0;
  const double low = wraps ? x.known() ? double(x.bits()) : 0 : double(x.lo),
               high = wraps ? x.known() ? low : 4294967295.0 : double(x.hi);
  w.write(s.r, I::of(double(B(low)), double(B(high))), reason_of(w, s, {}));
}

// Every texel of the table may be the one that is read.
template <class B>
void BoxSteps<B>::read_texel(Way<B>& w, const Step& s) {
  const shader::TexelTable& table = *tables_[s.c];
  w.write(s.r, I::of(double(table.least), double(table.most)), reason_of(w, s, {}));
}

template <class B>
void BoxSteps<B>::to_integer(Way<B>& w, const Step& s) {
  const I x = w.numbers[s.a];
  const std::optional<Undefined> own = undefined_number<B>(s, w);
  const std::uint32_t reason = reason_of(w, s, own);
  if (own) return w.write_integer(s.r, Whole::any(), reason);
  const Whole low = Whole::of_bits(shader::detail::to_integer(x.lo, s.op)),
              high = Whole::of_bits(shader::detail::to_integer(x.hi, s.op));
  w.write_integer(s.r, low.lo <= high.lo ? Whole{low.lo, high.lo} : Whole::any(), reason);
}

template <class B>
void BoxSteps<B>::apply_numbers(Way<B>& w, const Step& s) {
  const int count = shader::operation(s.op).count();
  const I no_number;
  const auto number = [&](int k, std::uint32_t slot) -> const I& {
    return k < count ? w.numbers[slot] : no_number;
  };
  const I &a = number(0, s.a), &b = number(1, s.b), &c = number(2, s.c);
  const std::uint32_t root_a = count > 0 ? w.root[s.a] : 0, root_b = count > 1 ? w.root[s.b] : ~0u;
  // An operation with the same number twice sees one number.
  I value = *number_op<B>(s.op, a, root_a == root_b ? a : b, c);
  const Squares none;
  const Squares &sa = count > 0 ? w.squares[s.a] : none, &sb = count > 1 ? w.squares[s.b] : none;
  const bool unit = of_length_of(s, sa, sb, root_a, root_b);
  if (unit) value = of_unit(value);
  Squares squares = squares_of(s, sa, sb, root_a, root_b);
  // Squares that may be subnormal have few digits, and a GPU may treat them as 0: their root is not a
  // length.
  if ((s.op == Op::sqrt || s.op == Op::inverse_sqrt) && !(a.lo >= I::kSmallest)) squares = {};
  w.write(s.r, value, reason_of(w, s, undefined_number<B>(s, w)));
  if (!squares.contains(s.r)) w.squares[s.r] = squares;
  for (const std::uint32_t slot : w.squares[s.r].slots()) w.tell_of(slot);
  if (s.op != Op::copy || root_a == s.r) return;
  w.root[s.r] = root_a;
  w.tell_of(root_a);
}

template <class B>
void BoxSteps<B>::load(Way<B>& w, const Step& s) {
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

template <class B>
void BoxSteps<B>::store(Way<B>& w, const Step& s) {
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

template <class B>
void BoxSteps<B>::apply_integers(Way<B>& w, const Step& s) {
  const int count = shader::operation(s.op).count();
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

template <class B>
std::uint32_t BoxSteps<B>::reason_of_choice(const Way<B>& w, const Step& s, const Whole& truth) {
  const bool first = !truth.known() || truth.bits() != 0, second = !truth.known() || truth.bits() == 0;
  std::uint32_t reason = w.undefined_integers[s.a];
  if (reason == 0 && first) reason = w.undefined_integers[s.b];
  if (reason == 0 && second) reason = w.undefined_integers[s.c];
  return placed(reason, s);
}

template <class B>
bool BoxSteps<B>::of_length(const Way<B>& w, const Step& s) {
  return of_length_of(s, w.squares[s.a], w.squares[s.b], w.root[s.a], w.root[s.b]);
}

template class BoxSteps<float>;
template class BoxSteps<double>;

}  // namespace brdf::prove
