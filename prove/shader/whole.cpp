#include "prove/shader/whole.h"

#include <algorithm>

#include "shader/program/operations.h"
#include "shader/run/step.h"

namespace brdf::prove {
namespace {

using shader::Op;

// Returns the range; any value if the language wraps results that do not fit.
Whole fitting(std::int64_t lo, std::int64_t hi) {
  return lo >= Whole::kLeast && hi <= Whole::kMost ? Whole{lo, hi} : Whole::any();
}

// Evaluates the operation with the interpreter itself.
Whole exactly(Op op, const Whole& a, const Whole& b, const Whole& c) {
  shader::Program four;
  four.integers = 4;
  shader::Bank<double, 1> bank(four);
  bank.set_integer(0, a.bits());
  bank.set_integer(1, b.bits());
  bank.set_integer(2, c.bits());
  shader::detail::run_step(shader::Step{op, 3, 0, 1, 2, 0}, bank, shader::AllLanes<1>{});
  return Whole::of_bits(*bank.integer(3));
}

Whole product(const Whole& a, const Whole& b) {
  const std::int64_t all[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
  return fitting(*std::min_element(all, all + 4), *std::max_element(all, all + 4));
}

// Returns true if the first operand is always below, false if it never is; else either.
Whole below(const Whole& a, const Whole& b, bool or_equal) {
  if (or_equal ? a.hi <= b.lo : a.hi < b.lo) return {1, 1};
  if (or_equal ? a.lo > b.hi : a.lo >= b.hi) return {0, 0};
  return Whole::truth();
}

Whole equal(const Whole& a, const Whole& b) {
  if (a.known() && a == b) return {1, 1};
  return a.hi < b.lo || b.hi < a.lo ? Whole{0, 0} : Whole::truth();
}

Whole negated(const Whole& truth) {
  return truth == Whole::truth() ? truth : Whole{1 - truth.lo, 1 - truth.lo};
}

// For operands that are not negative when read as signed.
Whole of_unsigned(Op op, const Whole& a, const Whole& b) {
  switch (op) {
    case Op::udiv:
    case Op::sdiv:
      return b.lo > 0 ? Whole{a.lo / b.hi, a.hi / b.lo} : Whole::any();
    case Op::umod:
    case Op::smod:
    case Op::srem:
      if (b.lo <= 0) return Whole::any();
      return a.hi < b.lo ? a : Whole{0, std::min(a.hi, b.hi - 1)};
    case Op::shr:
    case Op::sar:
      return b.hi < 32 ? Whole{a.lo >> b.hi, a.hi >> b.lo} : Whole::any();
    case Op::umin:
    case Op::index:
      return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
    case Op::umax:
      return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
    case Op::ult:
    case Op::ule:
      return below(a, b, op == Op::ule);
    case Op::iand:
      return a.hi <= 1 && b.hi <= 1 ? Whole{a.lo & b.lo, a.hi & b.hi} : Whole{0, std::min(a.hi, b.hi)};
    case Op::ior:
      return a.hi <= 1 && b.hi <= 1 ? Whole{a.lo | b.lo, a.hi | b.hi} : Whole::any();
    case Op::ixor:
      return a.hi <= 1 && b.hi <= 1 ? Whole::truth() : Whole::any();
    default:
      return Whole::any();
  }
}

bool is_comparison(Op op) {
  return op == Op::ieq || op == Op::ine || op == Op::slt || op == Op::sle || op == Op::ult || op == Op::ule ||
         op == Op::logical_not;
}

}  // namespace

Whole whole_op(Op op, const Whole& a, const Whole& b, const Whole& c) {
  const int count = shader::operation(op).count();
  if (a.known() && (count < 2 || b.known()) && (count < 3 || c.known())) return exactly(op, a, b, c);
  switch (op) {
    case Op::icopy:
      return a;
    case Op::iadd:
      return fitting(a.lo + b.lo, a.hi + b.hi);
    case Op::isub:
      return fitting(a.lo - b.hi, a.hi - b.lo);
    case Op::imul:
      return product(a, b);
    case Op::ineg:
      return fitting(-a.hi, -a.lo);
    case Op::iabs:
      return a.lo >= 0 ? a : fitting(0, std::max(-a.lo, a.hi));
    case Op::isign:
      return {(a.lo > 0) - (a.lo < 0), (a.hi > 0) - (a.hi < 0)};
    case Op::imin:
      return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)};
    case Op::imax:
      return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
    case Op::slt:
    case Op::sle:
      return below(a, b, op == Op::sle);
    case Op::ieq:
      return equal(a, b);
    case Op::ine:
      return negated(equal(a, b));
    case Op::logical_not:
      return a.lo > 0 || a.hi < 0 ? Whole{0, 0} : Whole::truth();
    case Op::iselect:
      if (a.lo > 0 || a.hi < 0) return b;
      return a == Whole{0, 0} ? c : hull(b, c);
    case Op::iand:
      if (a == Whole{0, 0} || b == Whole{0, 0}) return {0, 0};
      break;
    default:
      break;
  }
  if (a.not_negative() && b.not_negative()) return of_unsigned(op, a, b);
  return is_comparison(op) ? Whole::truth() : Whole::any();
}

bool may_be_undefined(Op op, const Whole& a, const Whole& b) {
  const auto holds = [](const Whole& x, std::int64_t value) { return x.lo <= value && value <= x.hi; };
  switch (op) {
    case Op::smod:
      return a.lo < 0 || b.lo <= 0;
    case Op::srem:
      if ((a.lo < 0 && b.hi > 0) || (a.hi > 0 && b.lo < 0)) return true;
      [[fallthrough]];
    case Op::sdiv:
      return holds(b, 0) || (holds(b, -1) && holds(a, Whole::kLeast));
    case Op::udiv:
    case Op::umod:
      return holds(b, 0);
    case Op::shl:
    case Op::shr:
    case Op::sar:
      return b.lo < 0 || b.hi > 31;
    case Op::index:
      return a.lo < 0 || b.lo < 0 || a.hi > b.lo;
    default:
      return false;
  }
}

}  // namespace brdf::prove
