// Traits of scalar types, and the few operations that all scalars share.
//
// Scalars are float, double, Dual<T, N>, ceres::Jet, a 50-digit number and the tracing scalar. Forms are
// written once for all of them: constants are converted at use, S(0.33), and a choice is
// select(condition, a, b), never an `if`.
#pragma once

#include <type_traits>

// Fast mathematics breaks (x + magic) - magic and compensated sums. g++ from version 12 on defines a macro
// for each of its parts. clang defines a macro for -ffast-math only. For clang and for older g++ a pragma
// therefore forbids the reordering of sums up to the end of the source file, which does no harm to the sums
// of user code.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST)
#error \
    "libbrdf relies on IEEE arithmetic: -ffast-math, -Ofast, -funsafe-math-optimizations and -fassociative-math make its kernels wrong by up to 41 %"
#endif
#if defined(__clang__)
#pragma clang fp reassociate(off)
#elif defined(__GNUC__) && __GNUC__ < 12
#pragma GCC optimize("no-associative-math")
#endif

namespace brdf {

inline constexpr double kPi = 3.14159265358979323846;

class Traced;

// A scalar with a value `a` and partial derivatives `v`. This covers Dual and ceres::Jet without naming
// either.
template <class T>
concept Differentiated = requires(T t) {
  t.a;
  t.v;
};

// The type that determines the rounding of a scalar: float for float, Dual<float, N> and the tracing scalar.
template <class T>
struct BaseScalar {
  using type = T;
};
template <Differentiated T>
struct BaseScalar<T> {
  using type = std::remove_cvref_t<decltype(std::declval<T>().a)>;
};
template <>
struct BaseScalar<Traced> {
  using type = float;
};
template <class T>
using base_scalar_t = typename BaseScalar<T>::type;

// Returns the value without its derivatives.
template <class T>
constexpr const T& value_of(const T& x) {
  return x;
}
template <Differentiated T>
constexpr const auto& value_of(const T& x) {
  return x.a;
}

// Selects one of two computed values. This form vectorises, differentiates and can be traced.
template <class T>
constexpr T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}

// These functions pass NaN in `x` through: a comparison with NaN is false, and `x` is then the result.
template <class T>
constexpr T at_least(const T& x, const T& lower) {
  return select(x < lower, lower, x);
}
template <class T>
constexpr T at_most(const T& x, const T& upper) {
  return select(upper < x, upper, x);
}
template <class T>
constexpr T larger(const T& a, const T& b) {
  return select(a < b, b, a);
}
template <class T>
constexpr T smaller(const T& a, const T& b) {
  return select(b < a, b, a);
}

template <class T>
constexpr T square(const T& x) {
  return x * x;
}

// Returns a + b - sum exactly, if sum is a + b rounded (Knuth's two-sum).
template <class T>
constexpr T sum_rest(const T& a, const T& b, const T& sum) {
  const T second = sum - a;
  return (a - (sum - second)) + (b - second);
}

}  // namespace brdf
