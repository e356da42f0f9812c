// Encloses the value of a form on a box.
#pragma once

#include "brdf/forms.h"
#include "prove/scalar/enclosed.h"
#include "prove/scalar/lemmas.h"
#include "prove/scalar/views.h"

namespace brdf::prove {

// Encloses the stored directions with these cosines and turns (Domain).
template <class I>
Vec3<I> direction(Bounds cosine, Bounds turn) {
  const double low = std::min(cosine.lo, 1.0), high = std::min(cosine.hi, 1.0);
  const I s = I::of(std::sqrt((1 - high) * (1 + high)) * (1 - 4 * I::kUnit),
                    std::sqrt((1 - low) * (1 + low)) * (1 + 4 * I::kUnit));
  I x, y;
  circle(turn, x, y);
  const auto stored = [](const I& c) { return I::widened(c.lo, c.hi, 2); };
  return {stored(s * x), stored(s * y), stored(I::of(low, high))};
}

// Reads parameters from the box, from the variable `at` on; advances `at`.
template <class P, class I>
P parameters_from(std::span<const Bounds> box, std::size_t& at) {
  P p{};
  for (const auto& field : P::fields()) {
    p.*(field.member) = I::of(box[at].lo, box[at].hi);
    ++at;
  }
  return p;
}

template <class F>
inline constexpr bool takes_first = !LinearForm<F>;

template <class F, class I>
struct OnBox {
  typename F::template Weights<I> weights, first;
  typename F::template Shape<I> shape;
  Geometry<I> g;

  explicit OnBox(std::span<const Bounds> box) {
    using W = typename F::template Weights<I>;
    std::size_t at = 0;
    shape = parameters_from<typename F::template Shape<I>, I>(box, at);
    weights = parameters_from<W, I>(box, at);
    first = weights;
    if constexpr (takes_first<F>) first = parameters_from<W, I>(box, at);
    const Vec3<I> wi = direction<I>(box[at], box[at + 1]), wo = direction<I>(box[at + 2], box[at + 3]);
    g = geometry(wi, wo);
  }
};

// Encloses f and f cos_i on the box.
template <class F, class Base>
Bounds enclose(std::span<const Bounds> box) {
  using I = Interval<Base>;
  const OnBox<F, I> b(box);
  bool both_signs = false;
  const auto value = [&](auto side) {
    const OneSide one(side);
    const I f = eval(F{}, b.weights, b.first, b.shape, b.g);
    const I all = hull(f, eval_cos(F{}, b.weights, b.first, b.shape, b.g));
    both_signs = one.open();
    return all;
  };
  I f = value(Side::negative);
  if (both_signs) f = hull(f, value(Side::other));
  return {f.lo, f.hi};
}

}  // namespace brdf::prove
