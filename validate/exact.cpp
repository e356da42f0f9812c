#include "validate/exact.h"

#include <boost/math/special_functions/erf.hpp>
#include <numeric>

#include "brdf/forms.h"

namespace brdf::validate {

namespace {

// The lobes are computed once for all sets of weights where the form has lobes: it is their cost that counts.
template <Form F>
std::vector<Exact> evaluate(F form, std::span<const std::vector<Exact>> weight_sets,
                            std::span<const Exact> shape, const Geometry<Exact>& g) {
  using Weights = typename F::template Weights<Exact>;
  const auto s = from_values<typename F::template Shape<Exact>>(shape);
  std::vector<Exact> values;
  if constexpr (LinearForm<F>) {
    const auto lobes = F::lobes(s, g);
    for (const auto& set : weight_sets) {
      const auto w = from_values<Weights>(std::span<const Exact>(set)).linear();
      values.push_back(g.lowest < 0 ? Exact(0)
                                    : std::inner_product(w.begin(), w.end(), lobes.begin(), Exact(0)));
    }
  } else {
    for (const auto& set : weight_sets) {
      const auto w = from_values<Weights>(std::span<const Exact>(set));
      values.push_back(eval(form, w, w, s, g));
    }
  }
  return values;
}

}  // namespace

std::vector<Exact> exact_eval(const Reflectance& form, std::span<const std::vector<Exact>> weights,
                              std::span<const Exact> shape, const Vec3<Exact>& wi, const Vec3<Exact>& wo,
                              double min_cosine) {
  const Geometry<Exact> g = geometry(wi, wo, min_cosine);
  std::vector<Exact> values;
  with_form(catalogue_index(form), [&](auto f) { values = evaluate(f, weights, shape, g); });
  return values;
}

}  // namespace brdf::validate

namespace boost::multiprecision {

brdf::validate::Exact erfcx(const brdf::validate::Exact& x) {
  return exp(x * x) * boost::math::erfc(x);
}

}  // namespace boost::multiprecision
