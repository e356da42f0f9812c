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

// Returns the defaults of the table, except a diffuse weight of 0.3 if the form has a lobe.
template <class Weights, class S>
constexpr Weights shown_weights() {
  bool lobe = false;
  for (const auto& field : Weights::fields()) lobe = lobe || field.info.role == Role::specular;
  Weights w{};
  for (const auto& field : Weights::fields())
    w.*(field.member) = S(lobe && field.info.role == Role::diffuse ? 0.3 : field.info.initial);
  return w;
}

// Sets the form's f0 to the row's f0. If the form has no f0, multiplies its lobe by the row's f0.
template <class Weights, class S>
constexpr void set_f0(Weights& w, const S& f0) {
  bool has_f0 = false;
  for (const auto& field : Weights::fields()) has_f0 = has_f0 || field.info.role == Role::f0;
  for (const auto& field : Weights::fields())
    if (field.info.role == (has_f0 ? Role::f0 : Role::specular))
      w.*(field.member) = has_f0 ? f0 : w.*(field.member) * f0;
}

// A form at these weights, with every shape parameter set to the row's width. The computation uses
// Scalar<T>.
template <class F, template <class> class Scalar = Own, bool kF0 = false>
struct form_kernel {
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    using S = Scalar<T>;
    using Shape = typename F::template Shape<S>;
    auto w = shown_weights<typename F::template Weights<S>, S>();
    if constexpr (kF0) set_f0(w, S(x.f0));
    Shape shape{};
    for (const auto& field : Shape::fields()) shape.*(field.member) = S(x.width);
    const auto in_scalar = [](const Vec3<T>& v) { return Vec3<S>{S(v.x), S(v.y), S(v.z)}; };
    return narrowed<T>(eval(F{}, w, w, shape, geometry(in_scalar(x.wi), in_scalar(x.wo), 1e-6)));
  }
};

}  // namespace brdf::trade
