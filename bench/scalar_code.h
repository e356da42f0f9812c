// The scalar code that batches are compared with.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::bench {

// f_r cos_i of one channel for each pair of directions, parameters in table order.
template <class T>
using Scalar = void (*)(std::span<const T> weights, std::span<const T> shape, const Directions<T>&, T* out);

// The library's template, one call of brdf::eval_cos per pair.
template <class T>
Scalar<T> scalar_template(const Reflectance& form);

// What one writes from a textbook: world space, normalised half vector, pow, acos; null for the other forms.
template <class T>
Scalar<T> textbook(const Reflectance& form);

// What the project wants of the batches of a form that textbooks have; 0: nothing.
struct Goals {
  double of_limit_in_double = 0, of_limit_in_float = 0;  // share of the machine's limit
  double float_over_double = 2;                          // 0: bound by memory, no goal at all
};
Goals goals_of(const Reflectance& form);

}  // namespace brdf::bench
