// A scalar with the elementary functions of the C library: the same forms with other kernels. With long
// double this scalar is the reference for double.
#pragma once

#include <cmath>
#include <concepts>

#include "brdf/math.h"

namespace brdf::trade {

template <class B>
struct Libm {
  B value;

  Libm() = default;
  explicit Libm(B x) : value(x) {}
  template <class N>
    requires(std::is_arithmetic_v<N> && !std::same_as<N, B>)
  explicit Libm(N x) : value(B(x)) {}

  friend Libm operator+(Libm a, Libm b) { return Libm(a.value + b.value); }
  friend Libm operator-(Libm a, Libm b) { return Libm(a.value - b.value); }
  friend Libm operator*(Libm a, Libm b) { return Libm(a.value * b.value); }
  friend Libm operator/(Libm a, Libm b) { return Libm(a.value / b.value); }
  friend Libm operator-(Libm a) { return Libm(-a.value); }
  friend bool operator<(Libm a, Libm b) { return a.value < b.value; }
  friend constexpr bool operator==(Libm a, Libm b) { return a.value == b.value; }

  friend Libm exp(Libm x) { return Libm(std::exp(x.value)); }
  friend Libm log(Libm x) { return Libm(std::log(x.value)); }
  friend Libm log1p(Libm x) { return Libm(std::log1p(x.value)); }
  friend Libm sqrt(Libm x) { return Libm(std::sqrt(x.value)); }
  friend Libm atan2(Libm y, Libm x) { return Libm(std::atan2(y.value, x.value)); }
  // The C library has no erfcx. For x <= 10.5 the product stays in the range of double; in float only up to
  // 9.
  friend Libm erfcx(Libm x) { return Libm(std::exp(x.value * x.value) * std::erfc(x.value)); }
};

}  // namespace brdf::trade

namespace brdf {
template <>
struct BaseScalar<trade::Libm<float>> {
  using type = float;
};
}  // namespace brdf
