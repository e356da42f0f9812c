// Forms as kernels, in any scalar.
#pragma once

#include "brdf/form.h"
#include "trade/approximations/libm.h"
#include "trade/approximations/masking.h"

namespace brdf::trade {

template <class T>
using Own = T;
template <class T>
using Extended = Libm<long double>;

template <class T, class S>
T narrowed(const S& x) {
  if constexpr (requires { x.value; })
    return T(x.value);
  else
    return T(x);
}

// The table's defaults, but 0.3 for the diffuse weight beside a lobe.
template <class Weights, class S>
constexpr Weights shown_weights() {
  bool lobe = false;
  for (const auto& field : Weights::fields()) lobe = lobe || field.info.role == Role::specular;
  Weights w{};
  for (const auto& field : Weights::fields())
    w.*(field.member) = S(lobe && field.info.role == Role::diffuse ? 0.3 : field.info.initial);
  return w;
}

// A form at those weights, every parameter of its shape the row's width. Scalar<T> is what it computes in.
template <class F, template <class> class Scalar = Own>
struct form_kernel {
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    using S = Scalar<T>;
    using Weights = typename F::template Weights<S>;
    using Shape = typename F::template Shape<S>;
    const auto w = shown_weights<Weights, S>();
    Shape shape{};
    for (const auto& field : Shape::fields()) shape.*(field.member) = S(x.width);
    const auto in_scalar = [](const Vec3<T>& v) { return Vec3<S>{S(v.x), S(v.y), S(v.z)}; };
    return narrowed<T>(eval(F{}, w, w, shape, geometry(in_scalar(x.wi), in_scalar(x.wo), 1e-6)));
  }
};

// The same with the row's f0; where the form has none it multiplies the lobe.
template <class F>
struct form_with_f0 {
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    using Weights = typename F::template Weights<T>;
    using Shape = typename F::template Shape<T>;
    auto w = shown_weights<Weights, T>();
    bool has_f0 = false;
    for (const auto& field : Weights::fields())
      if (field.info.role == Role::f0) {
        w.*(field.member) = x.f0;
        has_f0 = true;
      }
    for (const auto& field : Weights::fields())
      if (!has_f0 && field.info.role == Role::specular) w.*(field.member) = w.*(field.member) * x.f0;
    Shape shape{};
    for (const auto& field : Shape::fields()) shape.*(field.member) = x.width;
    return eval(F{}, w, w, shape, geometry_of(x));
  }
};

}  // namespace brdf::trade
