#include "validate/numerics/exact.h"

#include <boost/math/special_functions/erf.hpp>
#include <numeric>

#include "brdf/forms.h"
#include "validate/numerics/extended.h"

namespace brdf::validate {

namespace {

// If the form has lobes, the lobes are computed once for all sets of weights, because they dominate the
// cost.
template <Form F, class Truth>
std::vector<Truth> evaluate(F form, std::span<const std::vector<Truth>> weight_sets,
                            std::span<const Truth> shape, const Geometry<Truth>& g) {
  using Weights = typename F::template Weights<Truth>;
  const auto s = from_values<typename F::template Shape<Truth>>(shape);
  std::vector<Truth> values;
  if constexpr (LinearForm<F>) {
    const auto lobes = F::lobes(s, g);
    for (const auto& set : weight_sets) {
      const auto w = from_values<Weights>(std::span<const Truth>(set)).linear();
      values.push_back(g.lowest < 0 ? Truth(0)
                                    : std::inner_product(w.begin(), w.end(), lobes.begin(), Truth(0)));
    }
  } else {
    for (const auto& set : weight_sets) {
      const auto w = from_values<Weights>(std::span<const Truth>(set));
      values.push_back(eval(form, w, w, s, g));
    }
  }
  return values;
}

}  // namespace

template <class Truth>
std::vector<Truth> exact_eval(const Reflectance& form,
                              std::type_identity_t<std::span<const std::vector<Truth>>> weights,
                              std::type_identity_t<std::span<const Truth>> shape, const Vec3<Truth>& wi,
                              const Vec3<Truth>& wo, double min_cosine) {
  const Geometry<Truth> g = geometry(wi, wo, min_cosine);
  std::vector<Truth> values;
  with_form(catalogue_index(form), [&](auto f) { values = evaluate(f, weights, shape, g); });
  return values;
}
template std::vector<double> exact_eval(const Reflectance&, std::span<const std::vector<double>>,
                                        std::span<const double>, const Vec3<double>&, const Vec3<double>&,
                                        double);
template std::vector<Extended> exact_eval(const Reflectance&, std::span<const std::vector<Extended>>,
                                          std::span<const Extended>, const Vec3<Extended>&,
                                          const Vec3<Extended>&, double);
template std::vector<Exact> exact_eval(const Reflectance&, std::span<const std::vector<Exact>>,
                                       std::span<const Exact>, const Vec3<Exact>&, const Vec3<Exact>&,
                                       double);

}  // namespace brdf::validate

namespace boost::multiprecision {

brdf::validate::Exact erfcx(const brdf::validate::Exact& x) {
  return exp(x * x) * boost::math::erfc(x);
}

}  // namespace boost::multiprecision
