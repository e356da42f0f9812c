#include "bench/scalar_code.h"
#include "brdf/forms.h"

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
Scalar<T> scalar_template(const Reflectance& form) {
  Scalar<T> code = nullptr;
  with_form(catalogue_index(form), [&]<class F>(F) { code = &evaluate<F, T>; });
  return code;
}
template Scalar<float> scalar_template(const Reflectance&);
template Scalar<double> scalar_template(const Reflectance&);

}  // namespace brdf::bench
