// Numbers in two parts, which give exponents the necessary accuracy.
//
// At 1e-12 of a lobe's peak the exponent is 27 and multiplies the relative error of one rounding by 27; a
// dozen roundings would give an error of 1e-5 in float. The rounding errors are therefore carried along, in
// plain numbers (derivatives do not need them). Fused multiply-add is not used because shaders may split
// it; products of half mantissas are exact everywhere.
#pragma once

#include "brdf/math.h"

namespace brdf {

// The sum high + low; high has half a mantissa.
template <class T>
struct TwoPart {
  T high, low;

  friend TwoPart operator*(const TwoPart& a, const TwoPart& b) {
    const T product = a.high * b.high;
    const T high = math::upper_half(product);
    return {high, (product - high) + (a.high * b.low + a.low * (b.high + b.low))};
  }
  friend TwoPart operator+(const TwoPart& a, const TwoPart& b) {
    const T high = math::upper_half(a.high + b.high);
    return {high, ((larger(a.high, b.high) - high) + smaller(a.high, b.high)) + (a.low + b.low)};
  }
};

// Returns x + rest in two parts. rest is the rounding error of x.
template <class T>
TwoPart<T> two_part(const T& x, const T& rest) {
  const T high = math::upper_half(x);
  return {high, (x - high) + rest};
}

template <class T>
TwoPart<T> half(const TwoPart<T>& x) {
  return {T(0.5) * x.high, T(0.5) * x.low};
}

// Returns the square root, given its rounded value.
template <class T>
TwoPart<T> square_root(const TwoPart<T>& x, const T& root) {
  const TwoPart<T> r = two_part(root, T(0)), square = r * r;
  return two_part(root, T(0.5) * ((x.high - square.high) + (x.low - square.low)) / root);
}

// Returns a b - p, if p equals a b up to a few ulp.
template <class T>
T product_rest(const T& a, const T& b, const T& p) {
  const T a_high = math::upper_half(a), b_high = math::upper_half(b);
  const T a_low = a - a_high, b_low = b - b_high;
  return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

// Returns (n + n_rest)/d - q, if q equals n/d up to a few ulp and `inverse` is about 1/d.
template <class T>
T quotient_rest(const T& n, const T& n_rest, const TwoPart<T>& d, const T& inverse, const T& q) {
  const T q_high = math::upper_half(q);
  const T remainder = (n - q_high * d.high) - q_high * d.low + n_rest;
  return (q_high - q) + remainder * inverse;
}

}  // namespace brdf
