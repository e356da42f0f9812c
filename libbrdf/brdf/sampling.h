// Random directions roughly proportional to a form: a mixture of the form's own sampler and the cosine.
//
// Directions are given in the local frame, with wo fixed and above the horizon; u in [0, 1). Densities are
// per solid angle of wi, in 1/sr. A sampled wi may lie below the horizon; its contribution is then 0. Over
// the upper hemisphere pdf() therefore integrates to the probability that wi lies above the horizon. T is
// float, double or the tracing scalar.
#pragma once

#include "brdf/form.h"
#include "brdf/samplers.h"

namespace brdf {

template <class F>
concept SampledForm = requires { typename F::Sampler; };

// Samples the specular lobe if u3 < `share`, otherwise the cosine. pdf() is the density of that mixture.
// Any form can be sampled; the lobe is followed only if the form names a sampler.
template <Form F, class T>
Vec3<T> sample(F, const typename F::template Shape<T>& shape, T u1, T u2, T u3, const Vec3<T>& wo,
               T share = T(0.5)) {
  if constexpr (SampledForm<F> && std::is_floating_point_v<T>) {
    if (u3 < share) return F::Sampler::sample(shape, u1, u2, wo);
  } else if constexpr (SampledForm<F>) {
    return chosen(u3 < share, F::Sampler::sample(shape, u1, u2, wo), sample_cosine(u1, u2));
  }
  return sample_cosine(u1, u2);
}

// Returns the density of sample() at wi, in 1/sr; 0 below the horizon.
template <Form F, class T>
T pdf(F, const typename F::template Shape<T>& shape, const Vec3<T>& wi, const Vec3<T>& wo, T share = T(0.5)) {
  const Geometry<T> g = geometry(wi, wo);
  const T diffuse = g.cos_i * T(1 / kPi);
  T density = diffuse;
  if constexpr (SampledForm<F>) density = share * F::Sampler::pdf(shape, g) + (T(1) - share) * diffuse;
  return select(g.lowest < T(0), T(0), density);
}

}  // namespace brdf
