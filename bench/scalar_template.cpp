#include "bench/scalar_code.h"

namespace brdf::bench {
namespace {

template <Form F, class T>
void evaluate(std::span<const T> weights, std::span<const T> shape, const Directions<T>& d, T* out) {
  const auto w = from_values<typename F::template Weights<T>>(weights);
  const auto s = from_values<typename F::template Shape<T>>(shape);
  for (std::size_t i = 0; i < d.count; ++i) out[i] = eval_cos(F{}, w, w, s, geometry(d.wi(i), d.wo(i)));
}

}  // namespace

template <class T>
Scalar<T> scalar_template(const AnyForm& form) {
  return std::visit([]<class F>(F) -> Scalar<T> { return &evaluate<F, T>; }, form);
}
template Scalar<float> scalar_template(const AnyForm&);
template Scalar<double> scalar_template(const AnyForm&);

}  // namespace brdf::bench
