// What an operation of a shader's program gives on intervals: everything that its float or double interpreter
// may compute, and the exact result. Poison where it may be no number or infinite, or where nothing is known.
#pragma once

#include <optional>

#include "prove/scalar/interval.h"
#include "shader/program/program.h"

namespace brdf::prove {

// Of numbers to a number; none where the operation is not known here.
template <class B>
std::optional<Interval<B>> number_op(shader::Op op, const Interval<B>& a, const Interval<B>& b,
                                     const Interval<B>& c);

// less, equal and so on, of numbers that are none is not asked.
template <class B>
Tri compared(shader::Op op, const Interval<B>& a, const Interval<B>& b);

}  // namespace brdf::prove
