// Forward-mode derivatives with N partials. The code consists of element-wise copies and pack expansions
// only, so that loops over duals vectorise. (A loop over the partials is 8 times slower.)
#pragma once

#include <cstddef>
#include <utility>

#include "brdf/scalar.h"

namespace brdf {

template <class T, int N>
struct Partials {
  T d[N > 0 ? N : 1];

  constexpr Partials() = default;
  // The default copy would be a memory operation on the whole struct, and a loop that contains one does not
  // vectorise.
  constexpr Partials(const Partials& x) {
    set([&](std::size_t k) { return x.d[k]; });
  }
  constexpr Partials& operator=(const Partials& x) {
    set([&](std::size_t k) { return x.d[k]; });
    return *this;
  }

  template <class F>
  static constexpr Partials make(F&& f) {
    Partials p;
    p.set(f);
    return p;
  }
  constexpr const T& operator[](std::size_t k) const { return d[k]; }

  friend constexpr Partials operator+(const Partials& x, const Partials& y) {
    return make([&](std::size_t k) { return x.d[k] + y.d[k]; });
  }
  friend constexpr Partials operator-(const Partials& x, const Partials& y) {
    return make([&](std::size_t k) { return x.d[k] - y.d[k]; });
  }
  friend constexpr Partials operator*(const Partials& x, const T& s) {
    return make([&](std::size_t k) { return x.d[k] * s; });
  }

 private:
  template <class F>
  constexpr void set(F&& f) {
    [&]<std::size_t... k>(std::index_sequence<k...>) { ((d[k] = f(k)), ...); }(std::make_index_sequence<N>{});
  }
};

// A value a with its partial derivatives v.
template <class T, int N>
struct Dual {
  T a;
  Partials<T, N> v;

  constexpr Dual() : Dual(T(0)) {}
  explicit constexpr Dual(double value)
      : a(T(value)), v(Partials<T, N>::make([](std::size_t) { return T(0); })) {}
  explicit constexpr Dual(float value) : Dual(double(value)) {}
  explicit constexpr Dual(int value) : Dual(double(value)) {}
  constexpr Dual(const T& value, const Partials<T, N>& partials) : a(value), v(partials) {}
  // Returns the k-th independent variable.
  static constexpr Dual variable(T value, std::size_t k) {
    return {value, Partials<T, N>::make([&](std::size_t j) { return j == k ? T(1) : T(0); })};
  }

  friend constexpr Dual operator+(const Dual& x, const Dual& y) { return {x.a + y.a, x.v + y.v}; }
  friend constexpr Dual operator-(const Dual& x, const Dual& y) { return {x.a - y.a, x.v - y.v}; }
  friend constexpr Dual operator-(const Dual& x) { return {-x.a, x.v * T(-1)}; }
  friend constexpr Dual operator*(const Dual& x, const Dual& y) { return {x.a * y.a, x.v * y.a + y.v * x.a}; }
  friend constexpr Dual operator/(const Dual& x, const Dual& y) {
    const T inverse = T(1) / y.a;
    const T q = x.a / y.a;
    return {q, (x.v - y.v * q) * inverse};
  }
  // The geometry is often plain while the shape carries derivatives. These operators do half the work then.
  friend constexpr Dual operator+(const Dual& x, const T& y) { return {x.a + y, x.v}; }
  friend constexpr Dual operator+(const T& x, const Dual& y) { return {x + y.a, y.v}; }
  friend constexpr Dual operator-(const Dual& x, const T& y) { return {x.a - y, x.v}; }
  friend constexpr Dual operator-(const T& x, const Dual& y) { return {x - y.a, y.v * T(-1)}; }
  friend constexpr Dual operator*(const Dual& x, const T& y) { return {x.a * y, x.v * y}; }
  friend constexpr Dual operator*(const T& x, const Dual& y) { return {x * y.a, y.v * x}; }
  friend constexpr Dual operator/(const Dual& x, const T& y) { return {x.a / y, x.v * (T(1) / y)}; }
  friend constexpr Dual operator/(const T& x, const Dual& y) {
    const T q = x / y.a;
    return {q, y.v * (-q / y.a)};
  }

  friend constexpr bool operator<(const Dual& x, const Dual& y) { return x.a < y.a; }
  friend constexpr bool operator==(const Dual& x, const Dual& y) { return x.a == y.a; }
  friend constexpr Dual select(bool c, const Dual& x, const Dual& y) {
    return {c ? x.a : y.a, Partials<T, N>::make([&](std::size_t k) { return c ? x.v.d[k] : y.v.d[k]; })};
  }
};

}  // namespace brdf
