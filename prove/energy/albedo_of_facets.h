// The albedo of a form's lobes at given parameters, from its facets and its Fresnel term.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "prove/energy/facet_cells.h"
#include "prove/energy/student_cell.h"
#include "prove/scalar/on_box.h"

namespace brdf::prove {

template <class F>
inline constexpr bool kSchlick = std::is_same_v<typename F::template Weights<double>, SchlickWeights<double>>;
template <class F>
inline constexpr bool kIndexed = requires(typename F::template Shape<double> s) { s.eta; } &&
                                 std::is_same_v<typename F::template Weights<double>, LobeWeights<double>>;

template <class F>
inline constexpr bool kMetal = requires(typename F::template Shape<double> s) {
  s.n;
  s.k;
} && std::is_same_v<typename F::template Weights<double>, LobeWeights<double>>;

// Returns the weights of the lobes of a form.
template <class F>
auto lobe_weights(std::span<const Bounds> weights) {
  std::size_t at = 0;
  return parameters_from<typename F::template Weights<Exactly>, Exactly>(weights, at).linear();
}

// Returns the reflectance of facets with these weights, as a function of cos_d.
template <class F>
auto reflectance_of(const typename F::template Shape<Exactly>& s, const auto& w) {
  if constexpr (kSchlick<F>)
    return [w](const auto& c) { return schlick_at(c) * w[2] + w[1]; };
  else if constexpr (kMetal<F>)
    return [w, s](const auto& c) { return conductor_at(s.n.lo, s.k.lo, c) * w[1]; };
  else if constexpr (kIndexed<F>)
    return [w, s](const auto& c) { return dielectric_at(s.eta.lo, c) * w[1]; };
  else
    return [w](const auto&) { return w[1]; };
}

// Returns the sum of the lobes' weights times their albedos. The albedo of the diffuse lobe is 1.
template <class F, class LitFrom>
std::optional<AlbedoBounds> albedo_with(const typename F::template Shape<Exactly>& s, const Exactly& along2,
                                        const Exactly& across2, const auto& w, const LitFrom& lit_from,
                                        const Exactly& most, const Views& views, double accuracy) {
  if (s.alpha_x.lo != s.alpha_x.hi || s.alpha_y.lo != s.alpha_y.hi) return std::nullopt;
  const auto of_widths = [&](const auto& widths) {
    return facet_albedo(widths, lit_from(widths), reflectance_of<F>(s, w), views, accuracy);
  };
  const auto [facets, reach] = s.alpha_x.lo == s.alpha_y.lo ? of_widths(EqualWidths{along2})
                                                            : of_widths(UnequalWidths{along2, across2});
  const Exactly lobe = facets.hi < std::numeric_limits<double>::max()
                           ? Exactly::of(std::min(facets.lo, most.hi), std::min(facets.hi, most.hi))
                           : Exactly::of(0, most.hi);
  const Exactly all = w[0] * Exactly::of(kPiBounds.lo, kPiBounds.hi) * Exactly(1 / kPi) + lobe;
  return AlbedoBounds{{all.lo, all.hi}, reach};
}

// Encloses the albedo of a form with the facets of Cell.
template <class F, template <class> class Cell>
std::optional<AlbedoBounds> albedo_of_facets(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                             const Views& views, double accuracy) {
  std::size_t at = 0;
  const auto s = parameters_from<typename F::template Shape<Exactly>, Exactly>(shape, at);
  const auto w = lobe_weights<F>(weights);
  Exactly most = w[1];  // multiplies F G2/G1 and the density of visible normals, see majorants.h
  if constexpr (kSchlick<F>) most = most + w[2];
  const auto cells = []<class W>(const W&) { return [](const FacetView& view) { return Cell<W>(view); }; };
  return albedo_with<F>(s, square(s.alpha_x), square(s.alpha_y), w, cells, most, views, accuracy);
}

// For Student's t facets nothing is known except the integral.
template <class F>
std::optional<AlbedoBounds> albedo_of_student(std::span<const Bounds> shape, std::span<const Bounds> weights,
                                              const Views& views, double accuracy) {
  std::size_t at = 0;
  const auto s = parameters_from<typename F::template Shape<Exactly>, Exactly>(shape, at);
  const auto cells = [&s]<class W>(const W&) {
    return [&s](const FacetView& view) { return StudentCell<W>(view, s.gamma); };
  };
  const Exactly scale = s.gamma - Exactly(1), most = Exactly::of(0, std::numeric_limits<double>::max());
  return albedo_with<F>(s, square(s.alpha_x) * scale, square(s.alpha_y) * scale, lobe_weights<F>(weights),
                        cells, most, views, accuracy);
}

// Returns the factors of the view's tangents (EnergyMethod::stretch).
template <class F>
std::array<double, 2> stretch_of(std::span<const Bounds> shape) {
  std::size_t at = 0;
  const auto s = parameters_from<typename F::template Shape<Exactly>, Exactly>(shape, at);
  return {s.alpha_x.lo, s.alpha_y.lo};
}

// Returns the same factors for Student's t facets.
template <class F>
std::array<double, 2> stretch_of_student(std::span<const Bounds> shape) {
  std::size_t at = 0;
  const auto s = parameters_from<typename F::template Shape<Exactly>, Exactly>(shape, at);
  const double scale = std::sqrt(s.gamma.lo - 1);
  return {scale * s.alpha_x.lo, scale * s.alpha_y.lo};
}

}  // namespace brdf::prove
