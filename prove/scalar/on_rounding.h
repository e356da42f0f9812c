// Encloses the lobes of a form on a box, together with their rounding errors.
#pragma once

#include "prove/scalar/on_box.h"
#include "prove/scalar/rounding.h"
#include "prove/scalar/rounding_lemmas.h"

namespace brdf::prove {

// Returns the geometry of stored directions, with its guard in Base. No sum of two unit vectors is longer
// than 2.
template <class B>
Geometry<Rounded<B>> rounded_geometry(const Vec3<Rounded<B>>& wi, const Vec3<Rounded<B>>& wo) {
  using R = Rounded<B>;
  Geometry<R> g = geometry(wi, wo, double(B(kMinCosine<B>)));
  g.h2.range.hi = std::min(g.h2.range.hi, 4 * (1 + 64 * R::kUnit));
  g.cos_d.range.hi = std::min(g.cos_d.range.hi, 1 + 64 * R::kUnit);
  g.h2 = g.h2.finished();
  g.cos_d = g.cos_d.finished();
  return g;
}
// Returns the stored directions with these cosines and turns (Domain) as inputs.
template <class B>
Vec3<Rounded<B>> stored_direction(Bounds cosine, Bounds turn) {
  const Vec3<Interval<B>> w = direction<Interval<B>>(cosine, turn);
  const auto as_input = [](const Interval<B>& c) { return Rounded<B>::of(c.lo, c.hi); };
  return {as_input(w.x), as_input(w.y), as_input(w.z)};
}

// Returns the lobes of a form. If the form is not a sum of lobes, returns its one value: f, or f cos_i for
// a listing.
template <class F, class W, class Shape, class G>
auto lobes_or_value(const W& weights, const W& first, const Shape& shape, const G& g) {
  if constexpr (LinearForm<F>)
    return F::lobes(shape, g);
  else if constexpr (CosineForm<F>)
    return std::array{F::value_cos(weights, first, shape, g)};
  else
    return std::array{F::value(weights, first, shape, g)};
}

// Returns the error relative to the value if it is useful, otherwise relative to the peak.
template <class B>
LobeRounding judged(const Rounded<B>& x) {
  using Beside = LobeRounding::Beside;
  // For a value that is never small, the absolute part is included in the relative error.
  const double folded =
      x.least() > 0 ? x.relative.error + x.relative.underflow / x.least() : Rounded<B>::kNever;
  if (x.relative.known() && folded <= 4 * std::max(x.relative.error, Rounded<B>::kUnit))
    return {Beside::value, Rounded<B>::up(folded), 0, x.envelope.hi};
  // A value that may be 0 by cancellation has no useful relative error.
  if (x.relative.known() && x.relative.error <= 3 * x.peak.error)
    return {Beside::value, x.relative.error, x.relative.underflow, x.envelope.hi};
  if (x.peak.known()) return {Beside::peak, x.peak.error, x.peak.underflow, x.envelope.hi};
  return {};
}

// Returns the errors of the lobes on a box of domain_of(form).
template <class F, class B>
std::vector<LobeRounding> rounding(std::span<const Bounds> box) {
  using R = Rounded<B>;
  using W = typename F::template Weights<R>;
  std::size_t at = 0;
  const auto shape = parameters_from<typename F::template Shape<R>, R>(box, at);
  const W weights = parameters_from<W, R>(box, at);
  W first = weights;
  if constexpr (takes_first<F>) first = parameters_from<W, R>(box, at);
  const auto d = box.subspan(at);
  const Geometry<R> g = rounded_geometry(stored_direction<B>(d[0], d[1]), stored_direction<B>(d[2], d[3]));
  std::vector<LobeRounding> lobes;
  for (const R& lobe : lobes_or_value<F>(weights, first, shape, g)) lobes.push_back(judged(lobe));
  return lobes;
}

}  // namespace brdf::prove
