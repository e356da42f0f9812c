// Definition of a form, and functions that evaluate any form.
//
// A form is an empty struct with static members:
//   name, family         strings; the main form of a family has the name of the family
//   Weights<T>, Shape<T> parameter structs with their tables; weights are per channel (base Takes<...>)
//   violations           its known violations, each with a witness
// and one of the functions
//   lobes(shape, g)               K lobes: f = sum of weights.linear()[k] * lobe[k] (can be fitted)
//   value(w, first, shape, g)     f of one channel; `first` are the weights of the first channel, for
//                                 listings that mix the channels
//   value_cos(w, first, shape, g) the same times cos_i
// The functions are templates over S (shape, weights) and G (geometry). G is a plain type or equal to S.
//
// Optional members (brdf/facts.h; a missing member is treated as unknown):
//   accuracy             an Accuracy, measured by `brdf validate --numerics`
//   kink                 a Kink; without it integrals use bisection
//   albedos              an array of ClosedAlbedo
//   Facets               the distribution and masking of its microfacets (brdf/facets.h)
//   basis                a MattBasis: lobes and weights of either sign
//   about_light          true: the lobe lies about the direction of the light, not about its mirror image
//   Sampler              the sampler of its specular lobe (brdf/samplers.h)
#pragma once

#include <concepts>
#include <string_view>
#include <tuple>

#include "brdf/facts.h"
#include "brdf/geometry.h"
#include "brdf/parameter.h"

namespace brdf {

// Base class that declares the parameters of a form: struct ward : Takes<LobeWeights, Roughness>.
template <template <class> class WeightsOf, template <class> class ShapeOf>
struct Takes {
  template <class T>
  using Weights = WeightsOf<T>;
  template <class T>
  using Shape = ShapeOf<T>;
};

template <class F>
concept LinearForm = requires(const typename F::template Shape<double>& shape, const Geometry<double>& g) {
  F::lobes(shape, g).size();
};
template <class F>
concept CosineForm =
    requires(const typename F::template Weights<double>& w, const typename F::template Shape<double>& shape,
             const Geometry<double>& g) { F::value_cos(w, w, shape, g); };
template <class F>
concept Form =
    requires {
      { F::name } -> std::convertible_to<std::string_view>;
      { F::family } -> std::convertible_to<std::string_view>;
      F::violations.size();
    } && table_is_sound<typename F::template Weights<double>, double>() &&
    table_is_sound<typename F::template Shape<double>, double>();

template <LinearForm F>
inline constexpr std::size_t lobe_count = std::tuple_size_v<decltype(F::lobes(
    std::declval<typename F::template Shape<double>>(), std::declval<Geometry<double>>()))>;

// Returns the closed-form albedo of a surface that reflects all light.
inline double whole_albedo(std::span<const double>, double) {
  return 1;
}

// The scalar type of a parameter struct.
template <ParameterStruct P>
using scalar_of = std::remove_cvref_t<decltype(std::declval<P>().*(P::fields()[0].member))>;

namespace detail {
template <class F, class W, class Shape, class G>
scalar_of<W> above_horizon(const W& w, const W& first, const Shape& shape, const Geometry<G>& g) {
  if constexpr (LinearForm<F>) {
    const auto weight = w.linear();
    const auto lobe = F::lobes(shape, g);
    scalar_of<W> f = weight[0] * lobe[0];
    // A loop over many lobes would keep the loop over directions from vectorising.
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      ((f = f + weight[k + 1] * lobe[k + 1]), ...);
    }(std::make_index_sequence<std::tuple_size_v<std::remove_const_t<decltype(lobe)>> - 1>{});
    return f;
  } else if constexpr (CosineForm<F>) {
    return F::value_cos(w, first, shape, g) / g.cos_i;
  } else {
    return F::value(w, first, shape, g);
  }
}
}  // namespace detail

// Returns f_r of one channel in 1/sr, without the cosine. The result is 0 below the horizon, and finite for
// every pair of unit directions and every parameter within the table's range. Cosines below kMinCosine are
// replaced by kMinCosine. `first` are the weights of the first channel.
template <Form F, ParameterStruct W, ParameterStruct Shape, class G>
scalar_of<W> eval(F, const W& w, const W& first, const Shape& shape, const Geometry<G>& g) {
  return select(g.lowest < G(0), scalar_of<W>(0), detail::above_horizon<F>(w, first, shape, g));
}

// Returns f_r cos_i. The radiance of a listing is returned unchanged instead of being divided by the cosine
// and multiplied by it again.
template <Form F, ParameterStruct W, ParameterStruct Shape, class G>
scalar_of<W> eval_cos(F, const W& w, const W& first, const Shape& shape, const Geometry<G>& g) {
  using S = scalar_of<W>;
  if constexpr (CosineForm<F>)
    return select(g.lowest < G(0), S(0), F::value_cos(w, first, shape, g));
  else
    return select(g.lowest < G(0), S(0), detail::above_horizon<F>(w, first, shape, g) * g.cos_i);
}

}  // namespace brdf
