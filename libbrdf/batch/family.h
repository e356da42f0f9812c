// The batch loops. <family>.cpp instantiates family_batches for its family's name and both scalars; which
// forms belong to it follows from the catalogue.
#pragma once

#include <algorithm>

#include "batch/batch_table.h"
#include "brdf/dual.h"

namespace brdf {

namespace detail {

// The one loop: one clone per generation of the CPU, chosen when the program is loaded. Without `flatten` the
// form would not be inlined into the clones, which costs a factor of 8. clang refuses the two together; under
// sanitizers plain code, because instrumented clones take minutes to compile and test nothing more.
template <class Body>
#if defined(__SANITIZE_ADDRESS__)
#elif defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
[[gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"), gnu::flatten]]
#else
[[gnu::flatten]]
#endif
void repeat(const Body body, const std::size_t count) {
#if defined(__clang__)
#pragma clang loop vectorize(assume_safety)
#else
#pragma GCC ivdep
#endif
  for (std::size_t i = 0; i < count; ++i) body(i);
}

template <Form F, class T, bool kCosine>
void eval_directions(std::span<const T> weights, std::span<const T> first, std::span<const T> shape,
                     const Directions<T>& directions, T* out) {
  using Weights = typename F::template Weights<T>;
  using Shape = typename F::template Shape<T>;
  const auto body = [w = from_values<Weights>(weights), f = from_values<Weights>(first),
                     s = from_values<Shape>(shape), d = directions, out](std::size_t i) {
    const Geometry<T> g = geometry(d.wi(i), d.wo(i));
    out[i] = kCosine ? eval_cos(F{}, w, f, s, g) : eval(F{}, w, f, s, g);
  };
  repeat(body, directions.count);
}

// A direction that turns with the frame: its last derivative is the one with respect to tangent_phi.
template <class T, int D>
Vec3<Dual<T, D>> turning(const Vec3<T>& w) {
  const auto last = [](T value, T derivative) {
    return Dual<T, D>(value,
                      Partials<T, D>::make([&](std::size_t k) { return k + 1 == D ? derivative : T(0); }));
  };
  return {last(w.x, w.y), last(w.y, -w.x), last(w.z, T(0))};
}

template <Form F, class T, Partial kPartial>
void lobe_directions(std::span<const T> shape, const Directions<T>& directions, const LobeRows<T>& out) {
  constexpr std::size_t P = parameter_count<typename F::template Shape<T>>;
  constexpr int D = kPartial == Partial::kNone ? 0 : int(P) + (kPartial == Partial::kShapeAndPhi);
  using S = Dual<T, D>;
  using Shape = typename F::template Shape<S>;
  std::array<S, P> variables;
  for (std::size_t k = 0; k < P; ++k)
    variables[k] = kPartial == Partial::kNone ? S(shape[k]) : S::variable(shape[k], k);
  const auto body = [s = from_values<Shape>(std::span<const S>(variables)), d = directions,
                     out](std::size_t i) {
    const auto g = [&] {
      if constexpr (kPartial == Partial::kShapeAndPhi)
        return geometry(turning<T, D>(d.wi(i)), turning<T, D>(d.wo(i)));
      else
        return geometry(d.wi(i), d.wo(i));
    }();
    const auto lobes = F::lobes(s, g);
    const bool below = smaller(d.wi_z[i], d.wo_z[i]) < T(0);
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      const auto put = [&](std::size_t row, const T& value) {
        out.data[row * out.stride + i] = below ? T(0) : value;
      };
      const auto put_lobe = [&](std::size_t lobe, const S& value) {
        put(lobe * (D + 1), value.a);
        [&]<std::size_t... j>(std::index_sequence<j...>) {
          (put(lobe * (D + 1) + 1 + j, value.v[j]), ...);
        }(std::make_index_sequence<D>{});
      };
      (put_lobe(k, lobes[k]), ...);
    }(std::make_index_sequence<lobe_count<F>>{});
  };
  repeat(body, directions.count);
}

template <Form F, class T>
BatchKernels<T> make_batch_kernels() {
  BatchKernels<T> kernels;
  kernels.eval = &eval_directions<F, T, false>;
  kernels.eval_cos = &eval_directions<F, T, true>;
  if constexpr (LinearForm<F>) {
    kernels.lobes = {&lobe_directions<F, T, Partial::kNone>, &lobe_directions<F, T, Partial::kShape>,
                     &lobe_directions<F, T, Partial::kShapeAndPhi>};
  }
  return kernels;
}

}  // namespace detail

template <FamilyName family, class T>
BatchTable<T> family_batches() {
  BatchTable<T> table{};
  std::size_t k = 0;
  for_each_form([&]<class F>(F) {
    if constexpr (family == F::family) table[k] = detail::make_batch_kernels<F, T>();
    ++k;
  });
  return table;
}

}  // namespace brdf
