// The result of an operation of a shader's program on intervals: everything that its float or double
// interpreter may compute, and the exact result. The result is poison if it may be NaN or infinite, or if
// nothing is known of it.
#pragma once

#include <optional>

#include "prove/scalar/interval.h"
#include "shader/program/program.h"

namespace brdf::prove {

// Applies an operation from numbers to a number. Returns std::nullopt if the operation is not known here.
template <class B>
std::optional<Interval<B>> number_op(shader::Op op, const Interval<B>& a, const Interval<B>& b,
                                     const Interval<B>& c);

// Applies a comparison (less, equal and so on). Precondition: neither operand is NaN.
template <class B>
Tri compared(shader::Op op, const Interval<B>& a, const Interval<B>& b);

// Whether a comparison holds for some numbers of the ranges (shader/undefined.h). Poison may be any number,
// an infinity or NaN.
template <class B>
bool may_be_below(const Interval<B>& a, const Interval<B>& b) {
  return a.lo < b.hi;
}
template <class B>
bool may_be_below(const Interval<B>& a, double b) {
  return a.lo < b;
}
template <class B>
bool may_be_below(double a, const Interval<B>& b) {
  return a < b.hi;
}
template <class B>
bool may_be_at_most(const Interval<B>& a, const Interval<B>& b) {
  return a.lo <= b.hi;
}
template <class B>
bool may_be_at_most(const Interval<B>& a, double b) {
  return a.lo <= b;
}
template <class B>
bool may_be_at_most(double a, const Interval<B>& b) {
  return a <= b.hi;
}
template <class B>
bool may_be_nan(const Interval<B>& x) {
  return x.poisoned();
}

}  // namespace brdf::prove
