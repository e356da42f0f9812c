// Elementary functions as branchless polynomials, one template per function for both precisions.
//
// The functions vectorise and give the same bits with every compiler. The float versions are also traced
// into GLSL; shader and library therefore agree bit for bit. Coefficients: tools/kernel_coefficients.py.
// Use the functions through brdf/math.h.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "brdf/scalar.h"

namespace brdf::kernels {

inline std::uint32_t to_bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}
inline std::uint64_t to_bits(double x) {
  return std::bit_cast<std::uint64_t>(x);
}
inline float from_bits(std::uint32_t bits) {
  return std::bit_cast<float>(bits);
}
inline double from_bits(std::uint64_t bits) {
  return std::bit_cast<double>(bits);
}

template <class Base>
struct Precision;

template <>
struct Precision<float> {
  using Bits = std::uint32_t;
  static constexpr int mantissa_bits = 23;
  static constexpr Bits exponent_bias = 127;
  // 1.5 * 2^23. Adding this number rounds to an integer, which is kept in the low bits.
  static constexpr double magic = 12582912.0;
  static constexpr Bits magic_bits = 0x4B400000;
  // exp of a smaller argument is flushed to 0 because subnormal numbers are slow and inaccurate.
  static constexpr double exp_lowest = -80;
  static constexpr double exp_highest = 88;
  static constexpr double ln2_high = 0.693359375;
  static constexpr double ln2_low = -2.12194440054690583e-4;
  static constexpr Bits sqrt_half_bits = 0x3F3504F3;
  static constexpr Bits upper_half = 0xFFFFF000;  // sign, exponent and 12 of the 24 bits of the mantissa
  static constexpr std::array exp{5.0e-1, 1.666657698969877568e-1, 4.16665546172045742e-2,
                                  8.36317905272257737e-3, 1.392618358771349454e-3};
  static constexpr std::array log{6.666668505073790482e-1, 3.9988775997834654e-1, 2.958015670534363011e-1};
  static constexpr std::array atan{-3.333333175970025407e-1, 1.999954014620640322e-1,
                                   -1.426394390771794394e-1, 1.074360514891744316e-1,
                                   -6.451509518644878843e-2};
  static constexpr std::array erfcx{
      1.07400690584419846,      -8.833944637484836637e-1, 5.902284472024083371e-1,  -3.104665180132022573e-1,
      1.195270776918359731e-1,  -2.683742574476377384e-2, -1.217209322850046247e-3, 3.079632146976925443e-3,
      -4.971422377149682283e-4, -3.331503551439262351e-4};
};

template <>
struct Precision<double> {
  using Bits = std::uint64_t;
  static constexpr int mantissa_bits = 52;
  static constexpr Bits exponent_bias = 1023;
  static constexpr double magic = 6755399441055744.0;  // 1.5 * 2^52
  static constexpr Bits magic_bits = 0x4338000000000000;
  static constexpr double exp_lowest = -690;
  static constexpr double exp_highest = 709;
  static constexpr double ln2_high = 6.93147180369123816490e-01;
  static constexpr double ln2_low = 1.90821492927058770002e-10;
  static constexpr Bits sqrt_half_bits = 0x3FE6A09E667F3BCD;
  static constexpr Bits upper_half = 0xFFFFFFFFF8000000;  // 26 of the 53 bits
  static constexpr std::array exp{5.000000000000001022e-1, 1.666666666666666745e-1, 4.166666666662412787e-2,
                                  8.333333333330061833e-3, 1.38888889172137169e-3,  1.984126986305361688e-4,
                                  2.480152129595437513e-5, 2.755726845999706477e-6, 2.762008844540974816e-7,
                                  2.510038549551031908e-8};
  static constexpr std::array log{6.666666666666666646e-1, 4.000000000000087823e-1, 2.857142857080284798e-1,
                                  2.22222223918870656e-1,  1.818179562163278234e-1, 1.538624070896966424e-1,
                                  1.326874619559659457e-1, 1.308690788796502749e-1};
  static constexpr std::array atan{
      -3.333333333333333322e-1, 1.999999999999980413e-1, -1.428571428565972786e-1, 1.11111111051457253e-1,
      -9.090908753017178325e-2, 7.692296361048217779e-2, -6.6664246345993367e-2,   5.878926110528100754e-2,
      -5.230433007482892121e-2, 4.551496237494930317e-2, -3.456806801496887646e-2, 1.628299323892448678e-2};
  static constexpr std::array erfcx{
      1.074006907088339704,     -8.8339445316988386e-1,   5.902283571041012059e-1,  -3.104672619005360446e-1,
      1.195277612873356205e-1,  -2.682723462572187474e-2, -1.212416628727439948e-3, 3.034062023528727786e-3,
      -5.48309663799597142e-4,  -2.767780624957131523e-4, 1.075611863752936288e-4,  3.039936792920557607e-5,
      -1.746862391597794314e-5, -4.753053676930213094e-6, 2.757786070184626397e-6,  1.004927010335464648e-6,
      -3.905352527163765348e-7, -2.347665507396995966e-7, 2.500304175541942423e-8,  4.188722748209490626e-8,
      8.623262566647286335e-9};
};

template <class T>
using precision_of = Precision<base_scalar_t<T>>;

// Returns c[last] z^n + c[last - step] z^(n-1) + ... + c[last % step]. The sum is expanded by a template
// because compilers do not unroll a loop of this length, and a loop body that contains a loop does not
// vectorise.
template <std::size_t last, std::size_t step, class T, std::size_t N>
constexpr T chain(const T& z, const std::array<double, N>& c) {
  T y(c[last]);
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    ((y = y * z + T(c[last - step * (k + 1)])), ...);
  }(std::make_index_sequence<last / step>{});
  return y;
}
// Returns the sum of c[k] x^k as one chain. This is the most accurate order if the first term dominates the
// sum.
template <class T, std::size_t N>
constexpr T horner(const T& x, const std::array<double, N>& c) {
  return chain<N - 1, 1>(x, c);
}
// Returns the same sum as two chains in x^2, one of even and one of odd powers, if that halves the latency.
template <class T, std::size_t N>
constexpr T polynomial(const T& x, const std::array<double, N>& c) {
  if constexpr (N <= 3) {
    return horner(x, c);
  } else {
    const T x2 = x * x;
    const T last = chain<N - 1, 2>(x2, c), other = chain<N - 2, 2>(x2, c);
    return N % 2 == 1 ? other * x + last : last * x + other;
  }
}

// Returns x with the lower half of its mantissa set to 0. Products of two such numbers are exact.
template <class T>
inline T upper_half(const T& x) {
  return from_bits(to_bits(x) & precision_of<T>::upper_half);
}

// The integer n nearest to x (halves to even), and 2^n. |x| must be at most 2^10 (float: 2^7).
template <class T>
struct WholePower {
  T n, power;
};
template <class T>
inline WholePower<T> whole_power(const T& x) {
  using P = precision_of<T>;
  const T rounded = x + T(P::magic);
  return {rounded - T(P::magic),
          from_bits((to_bits(rounded) << P::mantissa_bits) + (P::exponent_bias << P::mantissa_bits))};
}

// Returns e^x for x <= 709 (float: 88). Largest error: 1.0 ulp. The result is 0 below -690 (float: -80).
// NaN passes through.
template <class T>
inline T exp(const T& x) {
  using P = precision_of<T>;
  const T lowest(P::exp_lowest);
  const T clamped = at_most(at_least(x, lowest), T(P::exp_highest));
  const auto [n, power] = whole_power(clamped * T(1.44269504088896340736));
  const T r = (clamped - n * T(P::ln2_high)) - n * T(P::ln2_low);
  const T mantissa = T(1) + (r + r * r * polynomial(r, P::exp));
  return select(x < lowest, T(0), mantissa * power);
}

// Decomposition x = m 2^e with m in [sqrt(1/2), sqrt(2)), f = m - 1 and s = (m - 1)/(m + 1). Then
// log m = 2 s + s^3 R(s^2).
template <class T>
struct LogParts {
  T e, f, s;
  T tail;     // log m = f - tail
  T inverse;  // 2^-e
};
template <class T>
inline LogParts<T> log_parts(const T& x) {
  using P = precision_of<T>;
  const auto shifted = to_bits(x) - P::sqrt_half_bits + (P::exponent_bias << P::mantissa_bits);
  const auto biased = shifted >> P::mantissa_bits;
  const auto power = (biased - P::exponent_bias) << P::mantissa_bits;
  LogParts<T> parts;
  parts.e = from_bits(biased | P::magic_bits) - T(P::magic + double(P::exponent_bias));
  const T m = from_bits(to_bits(x) - power);
  parts.f = m - T(1);
  parts.s = parts.f / (m + T(1));
  const T z = parts.s * parts.s;
  // 2 s = f - s f is exact in the sense of the expansion, and f carries no rounding error.
  parts.tail = parts.s * (parts.f - z * polynomial(z, P::log));
  parts.inverse = from_bits(to_bits(T(1)) - power);
  return parts;
}

// Returns the natural logarithm of a normal positive x. Largest error: 1 ulp away from 1, 1.5 ulp near 1.
template <class T>
inline T log(const T& x) {
  using P = precision_of<T>;
  const LogParts<T> p = log_parts(x);
  return p.e * T(P::ln2_high) + (p.f - (p.tail - p.e * T(P::ln2_low)));
}

// Returns log(1 + x + rest) for x > -1, accurate also for tiny x. |rest| must be at most a few ulp of x.
// Largest error: 2 ulp. The rounding error of 1 + x is added to the rest, which contributes rest/(1 + x)
// (after Kahan). 1/m is approximated by 1 - 2s + 2s^2, which is accurate enough for this correction.
template <class T>
inline T log1p(const T& x, const T& rest) {
  using P = precision_of<T>;
  const T u = T(1) + x;
  const T lost = select(x < T(1), x - (u - T(1)), T(1) - (u - x)) + rest;
  const LogParts<T> p = log_parts(u);
  const T correction = lost * p.inverse * (T(1) - T(2) * (p.s - p.s * p.s));
  return p.e * T(P::ln2_high) + (p.f - (p.tail - (p.e * T(P::ln2_low) + correction)));
}

// Returns the angle of the point (cosine, sine) in [0, pi/2]. Both coordinates must be >= 0 and not both 0.
// Largest error: 2 ulp.
template <class T>
inline T angle(const T& sine, const T& cosine) {
  using P = precision_of<T>;
  const T low = smaller(sine, cosine);
  const T high = larger(sine, cosine);
  const auto steep = high * T(0.41421356237309504880) < low;  // above tan(pi/8), rotate by pi/4
  const T t = select(steep, low - high, low) / select(steep, low + high, high);
  const T z = t * t;
  const T reduced = t + t * z * polynomial(z, P::atan);
  const T octant = select(steep, reduced + T(kPi / 4), reduced);
  return select(cosine < sine, T(kPi / 2) - octant, octant);
}

// Returns exp(x^2) erfc(x) for x in [0, 10.5]. Largest relative error: 6e-16 (double), 3e-7 (float).
template <class T>
inline T erfcx(const T& x) {
  using P = precision_of<T>;
  const T scale = T(1) / (x + T(3));
  const T q = (x - T(3)) * scale;
  return polynomial(q, P::erfcx) * scale;
}

}  // namespace brdf::kernels
